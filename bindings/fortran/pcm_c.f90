! SPDX-FileCopyrightText: 2026 The pcm authors
! SPDX-License-Identifier: BSD-3-Clause
!
!> The C interface (pcm/pcm.h, which explains everything in it) as Fortran sees it: its structs, its constants, and its
!> functions under their own names with a c_ before them. Module pcm is what programs use.
module pcm_c
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int32_t, c_int64_t, c_ptr, c_size_t
  implicit none
  private :: c_char, c_double, c_int32_t, c_int64_t, c_ptr, c_size_t

  integer(c_int32_t), parameter :: pcm_ok = 0, pcm_bad_input = 1, pcm_bad_call = 2, pcm_out_of_memory = 3, &
    pcm_internal_error = 4
  integer(c_int32_t), parameter :: pcm_E = 0, pcm_F = 1
  integer(c_int32_t), parameter :: pcm_mode_E = 0, pcm_mode_F = 1, pcm_mode_both = 2
  integer(c_int32_t), parameter :: pcm_barycentric = 0, pcm_clipped = 1
  integer(c_int32_t), parameter :: pcm_damping_no_tension = 0, pcm_damping_full = 1, pcm_damping_compression = 2
  !> What is wanted: a sum of these.
  integer(c_int32_t), parameter :: pcm_wanted_polygons = 1, pcm_wanted_areas = 2, pcm_wanted_force = 4, &
    pcm_wanted_elements = 8, pcm_wanted_bound = 16, pcm_wanted_statistics = 32, pcm_wanted_tangent = 64
  integer(c_int32_t), parameter :: pcm_intersected = 0, pcm_inner = 1
  !> The stiffness of a rigid body's layer, and the greatest penetration of a law that has none.
  real(c_double), parameter :: pcm_infinity = transfer(int(z'7FF0000000000000', c_int64_t), 1.0_c_double)

  type, bind(c) :: pcm_error
    character(kind=c_char) :: text(1024)
  end type

  type, bind(c) :: pcm_law
    integer(c_size_t) :: size
    real(c_double) :: stiffness, layer_stiffness_E, layer_stiffness_F, damping, transition_depth, friction, &
      slip_velocity, max_penetration
    integer(c_int32_t) :: damping_mode, reserved
  end type

  type, bind(c) :: pcm_active_area
    real(c_double) :: area, vector_area_Me(3)
    integer(c_int32_t) :: intersected, inner
  end type

  type, bind(c) :: pcm_bound
    real(c_double) :: force_Me(3), torque_Me(3), penetration_at_least, penetration_at_most
    integer(c_int32_t) :: given, flipped
  end type

  type, bind(c) :: pcm_statistics
    real(c_double) :: patch_area, mean_penetration, max_pressure, mean_pressure, max_normal_velocity, &
      max_tangential_velocity, centre_of_pressure_Me(3)
  end type

  type, bind(c) :: pcm_answer
    integer(c_size_t) :: size
    integer(c_int32_t) :: touching, nested, ambiguous, has_volume, penetration_exceeded, too_deep, undefined_areas, &
      patches, polygons, crossings, element_count, elements
    real(c_double) :: force_Me(3), torque_Me(3), max_penetration, volume
    type(pcm_active_area) :: E, F
    type(pcm_bound) :: bound
    type(pcm_statistics) :: statistics
  end type

  type, bind(c) :: pcm_element
    integer(c_int32_t) :: master, master_face, slave_face, reserved
    real(c_double) :: area, penetration, normal_velocity, tangential_velocity, normal_force, tangential_force, &
      normal_Me(3), position_Me(3), force_Me(3)
  end type

  type, bind(c) :: pcm_polygon
    integer(c_int32_t) :: closed, first, count, patch
  end type

  type, bind(c) :: pcm_crossing
    integer(c_int32_t) :: edge_side, edge(2), face
    real(c_double) :: position_Me(3)
  end type

  interface
    function c_abi_version() bind(c, name="pcm_abi_version") result(version)
      import :: c_int32_t
      integer(c_int32_t) :: version
    end function

    function c_surface_define(vertices, vertex_count, faces, face_count, surface, error) &
        bind(c, name="pcm_surface_define") result(status)
      import :: c_double, c_int32_t, c_ptr, c_size_t, pcm_error
      real(c_double), intent(in) :: vertices(*)
      integer(c_size_t), value :: vertex_count, face_count
      integer(c_int32_t), intent(in) :: faces(*)
      type(c_ptr), intent(out) :: surface
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    function c_surface_read(path, surface, error) bind(c, name="pcm_surface_read") result(status)
      import :: c_char, c_int32_t, c_ptr, pcm_error
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(out) :: surface
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    function c_surface_counts(surface, vertex_count, face_count, closed, error) &
        bind(c, name="pcm_surface_counts") result(status)
      import :: c_int32_t, c_ptr, c_size_t, pcm_error
      type(c_ptr), value :: surface
      integer(c_size_t), intent(out) :: vertex_count, face_count
      integer(c_int32_t), intent(out) :: closed
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    function c_surface_copy(surface, vertices, vertex_capacity, faces, face_capacity, error) &
        bind(c, name="pcm_surface_copy") result(status)
      import :: c_double, c_int32_t, c_ptr, c_size_t, pcm_error
      type(c_ptr), value :: surface
      real(c_double), intent(out) :: vertices(*)
      integer(c_size_t), value :: vertex_capacity, face_capacity
      integer(c_int32_t), intent(out) :: faces(*)
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    subroutine c_surface_dispose(surface) bind(c, name="pcm_surface_dispose")
      import :: c_ptr
      type(c_ptr), value :: surface
    end subroutine

    function c_law_init(law, size, error) bind(c, name="pcm_law_init") result(status)
      import :: c_int32_t, c_size_t, pcm_error, pcm_law
      type(pcm_law), intent(out) :: law
      integer(c_size_t), value :: size
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    function c_pairing_define(E, F, law, mode, scheme, pairing, error) &
        bind(c, name="pcm_pairing_define") result(status)
      import :: c_int32_t, c_ptr, pcm_error, pcm_law
      type(c_ptr), value :: E, F
      type(pcm_law), intent(in) :: law
      integer(c_int32_t), value :: mode, scheme
      type(c_ptr), intent(out) :: pairing
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    subroutine c_pairing_dispose(pairing) bind(c, name="pcm_pairing_dispose")
      import :: c_ptr
      type(c_ptr), value :: pairing
    end subroutine

    function c_workspace_define(workspace, error) bind(c, name="pcm_workspace_define") result(status)
      import :: c_int32_t, c_ptr, pcm_error
      type(c_ptr), intent(out) :: workspace
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    subroutine c_workspace_dispose(workspace) bind(c, name="pcm_workspace_dispose")
      import :: c_ptr
      type(c_ptr), value :: workspace
    end subroutine

    function c_evaluate(pairing, A, r, v, w, wanted, workspace, answer, error) &
        bind(c, name="pcm_evaluate") result(status)
      import :: c_double, c_int32_t, c_ptr, pcm_answer, pcm_error
      type(c_ptr), value :: pairing, workspace
      real(c_double), intent(in) :: A(*), r(*), v(*), w(*)
      integer(c_int32_t), value :: wanted
      type(pcm_answer), intent(inout) :: answer
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    function c_copy_elements(workspace, elements, capacity, error) bind(c, name="pcm_copy_elements") result(status)
      import :: c_int32_t, c_ptr, c_size_t, pcm_element, pcm_error
      type(c_ptr), value :: workspace
      type(pcm_element), intent(out) :: elements(*)
      integer(c_size_t), value :: capacity
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    function c_copy_polygons(workspace, polygons, capacity, error) bind(c, name="pcm_copy_polygons") result(status)
      import :: c_int32_t, c_ptr, c_size_t, pcm_error, pcm_polygon
      type(c_ptr), value :: workspace
      type(pcm_polygon), intent(out) :: polygons(*)
      integer(c_size_t), value :: capacity
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    function c_copy_crossings(workspace, crossings, capacity, error) bind(c, name="pcm_copy_crossings") result(status)
      import :: c_int32_t, c_ptr, c_size_t, pcm_crossing, pcm_error
      type(c_ptr), value :: workspace
      type(pcm_crossing), intent(out) :: crossings(*)
      integer(c_size_t), value :: capacity
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    function c_copy_faces(workspace, side, kind, faces, capacity, error) bind(c, name="pcm_copy_faces") result(status)
      import :: c_int32_t, c_ptr, c_size_t, pcm_error
      type(c_ptr), value :: workspace
      integer(c_int32_t), value :: side, kind
      integer(c_int32_t), intent(out) :: faces(*)
      integer(c_size_t), value :: capacity
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function

    function c_copy_tangent(workspace, tangent, capacity, error) bind(c, name="pcm_copy_tangent") result(status)
      import :: c_double, c_int32_t, c_ptr, c_size_t, pcm_error
      type(c_ptr), value :: workspace
      real(c_double), intent(out) :: tangent(*)
      integer(c_size_t), value :: capacity
      type(pcm_error), intent(out) :: error
      integer(c_int32_t) :: status
    end function
  end interface
end module
