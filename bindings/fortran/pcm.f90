! SPDX-FileCopyrightText: 2026 The pcm authors
! SPDX-License-Identifier: BSD-3-Clause
!
!> The engine for Fortran 2003: define a pairing of two surfaces, evaluate it for as many states as wanted, dispose of
!> it. pcm/pcm.h of the C interface says what every number is; here,
!> - a matrix is a Fortran matrix: A(i, j) stands in row i and column j;
!> - vertices, faces and a polygon's first crossing are numbered from 1, patches too;
!> - lists come as allocatable arrays;
!> - errors are told as ALLOCATE tells them: `stat` is one of pcm_ok, pcm_bad_input, ..., `errmsg` says why and is left
!>   alone where nothing failed. Without `stat` an error writes its text to the error unit and stops the program, and
!>   so does, in any case, a list that there is no memory for;
!> - a call that fails leaves its answer undefined; pcm_read and pcm_define first dispose of what their handle holds.
!>
!> Handles (pcm_surface, pcm_pairing, pcm_workspace) are not to be assigned: copies would share what is disposed of
!> once. Threads: surfaces and pairings may be shared, each thread needs a workspace of its own.
module pcm
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_int32_t, c_null_char, c_null_ptr, c_ptr, &
    c_signed_char, c_size_t
  use, intrinsic :: iso_fortran_env, only: error_unit
  use pcm_c
  implicit none
  private

  public :: pcm_ok, pcm_bad_input, pcm_bad_call, pcm_out_of_memory, pcm_internal_error
  public :: pcm_E, pcm_F, pcm_mode_E, pcm_mode_F, pcm_mode_both, pcm_barycentric, pcm_clipped
  public :: pcm_damping_no_tension, pcm_damping_full, pcm_damping_compression
  public :: pcm_wanted_polygons, pcm_wanted_areas, pcm_wanted_force, pcm_wanted_elements, pcm_wanted_bound, &
    pcm_wanted_statistics, pcm_wanted_tangent
  public :: pcm_intersected, pcm_inner, pcm_infinity
  public :: pcm_law, pcm_answer, pcm_active_area, pcm_bound, pcm_statistics
  public :: pcm_element, pcm_polygon, pcm_crossing
  public :: pcm_surface, pcm_pairing, pcm_workspace
  public :: pcm_default_law, pcm_read, pcm_define, pcm_evaluate, pcm_dispose
  public :: pcm_get_mesh, pcm_get_elements, pcm_get_polygons, pcm_get_crossings, pcm_get_faces, pcm_get_tangent

  type :: pcm_surface
    private
    type(c_ptr) :: handle = c_null_ptr
  end type

  type :: pcm_pairing
    private
    type(c_ptr) :: handle = c_null_ptr
  end type

  !> Made when it is first used. Keeps how long the lists of its last answer are.
  type :: pcm_workspace
    private
    type(c_ptr) :: handle = c_null_ptr
    integer :: elements = 0, polygons = 0, crossings = 0
    integer :: faces(pcm_intersected:pcm_inner, pcm_E:pcm_F) = 0
  end type

  interface pcm_define
    module procedure define_surface, define_pairing
  end interface

  interface pcm_dispose
    module procedure dispose_surface, dispose_pairing, dispose_workspace
  end interface

contains

  !> A surface from a file, .obj or .off, whose coordinates are metres.
  subroutine pcm_read(path, surface, stat, errmsg)
    character(*), intent(in) :: path
    type(pcm_surface), intent(inout) :: surface
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    call dispose_surface(surface)
    call finish(c_surface_read(trim(path)//c_null_char, surface%handle, error), error, stat, errmsg)
  end subroutine

  !> A surface from vertices(3, n), m, and faces(3, m): vertex numbers from 1, counterclockwise seen from outside.
  subroutine define_surface(vertices, faces, surface, stat, errmsg)
    real(c_double), intent(in) :: vertices(:, :)
    integer(c_int32_t), intent(in) :: faces(:, :)
    type(pcm_surface), intent(inout) :: surface
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    call dispose_surface(surface)
    if (size(vertices, 1) /= 3 .or. size(faces, 1) /= 3) then
      call fail("vertices and faces must have shapes (3, n) and (3, m)", stat, errmsg)
      return
    end if
    call finish(c_surface_define(vertices, size(vertices, 2, c_size_t), faces - 1, size(faces, 2, c_size_t), &
      surface%handle, error), error, stat, errmsg)
  end subroutine

  !> What define_surface takes.
  subroutine pcm_get_mesh(surface, vertices, faces, stat, errmsg)
    type(pcm_surface), intent(in) :: surface
    real(c_double), allocatable, intent(out) :: vertices(:, :)
    integer(c_int32_t), allocatable, intent(out) :: faces(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    integer(c_size_t) :: vertex_count, face_count
    integer(c_int32_t) :: closed, status
    status = c_surface_counts(surface%handle, vertex_count, face_count, closed, error)
    if (status == pcm_ok) then
      allocate (vertices(3, vertex_count), faces(3, face_count))
      status = c_surface_copy(surface%handle, vertices, vertex_count, faces, face_count, error)
      faces = faces + 1
    end if
    call finish(status, error, stat, errmsg)
  end subroutine

  function pcm_default_law() result(law)
    type(pcm_law) :: law
    type(pcm_error) :: error
    call finish(c_law_init(law, bytes(size(transfer(law, (/0_c_signed_char/)))), error), error)
  end function

  subroutine define_pairing(E, F, law, mode, scheme, pairing, stat, errmsg)
    type(pcm_surface), intent(in) :: E, F
    type(pcm_law), intent(in) :: law
    integer(c_int32_t), intent(in) :: mode, scheme
    type(pcm_pairing), intent(inout) :: pairing
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    call dispose_pairing(pairing)
    call finish(c_pairing_define(E%handle, F%handle, law, mode, scheme, pairing%handle, error), error, stat, errmsg)
  end subroutine

  !> F's points lie at matmul(A, x_F) + r. Without v and w nothing moves; without `wanted` everything but
  !> bounds and tangents is.
  subroutine pcm_evaluate(pairing, A, r, workspace, answer, v, w, wanted, stat, errmsg)
    type(pcm_pairing), intent(in) :: pairing
    real(c_double), intent(in) :: A(3, 3), r(3)
    type(pcm_workspace), intent(inout) :: workspace
    type(pcm_answer), intent(out) :: answer
    real(c_double), intent(in), optional :: v(3), w(3)
    integer(c_int32_t), intent(in), optional :: wanted
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    real(c_double) :: v_or_0(3), w_or_0(3)
    integer(c_int32_t) :: wanted_or_default, status
    v_or_0 = 0
    w_or_0 = 0
    wanted_or_default = pcm_wanted_polygons + pcm_wanted_areas + pcm_wanted_force + pcm_wanted_elements
    if (present(v)) v_or_0 = v
    if (present(w)) w_or_0 = w
    if (present(wanted)) wanted_or_default = wanted
    answer%size = bytes(size(transfer(answer, (/0_c_signed_char/))))
    status = pcm_ok
    if (.not. c_associated(workspace%handle)) status = c_workspace_define(workspace%handle, error)
    ! C takes the matrix row by row.
    if (status == pcm_ok) status = c_evaluate(pairing%handle, transpose(A), r, v_or_0, w_or_0, wanted_or_default, &
      workspace%handle, answer, error)
    if (status == pcm_ok) call keep_lengths(answer, workspace)
    call finish(status, error, stat, errmsg)
  end subroutine

  subroutine keep_lengths(answer, workspace)
    type(pcm_answer), intent(in) :: answer
    type(pcm_workspace), intent(inout) :: workspace
    workspace%elements = answer%elements
    workspace%polygons = answer%polygons
    workspace%crossings = answer%crossings
    workspace%faces(:, pcm_E) = (/answer%E%intersected, answer%E%inner/)
    workspace%faces(:, pcm_F) = (/answer%F%intersected, answer%F%inner/)
  end subroutine

  subroutine pcm_get_elements(workspace, elements, stat, errmsg)
    type(pcm_workspace), intent(in) :: workspace
    type(pcm_element), allocatable, intent(out) :: elements(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    integer(c_int32_t) :: status
    allocate (elements(workspace%elements))
    status = c_copy_elements(workspace%handle, elements, bytes(size(elements)), error)
    if (status == pcm_ok) then
      elements%master_face = elements%master_face + 1
      elements%slave_face = elements%slave_face + 1
    end if
    call finish(status, error, stat, errmsg)
  end subroutine

  !> The derivatives of force and torque, the rows, by r, by a turn of F about Mf, by v and by w, three columns each.
  subroutine pcm_get_tangent(workspace, tangent, stat, errmsg)
    type(pcm_workspace), intent(in) :: workspace
    real(c_double), intent(out) :: tangent(6, 12)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    real(c_double) :: by_rows(12, 6)
    integer(c_int32_t) :: status
    by_rows = 0
    status = c_copy_tangent(workspace%handle, by_rows, bytes(size(by_rows)), error)
    tangent = transpose(by_rows)
    call finish(status, error, stat, errmsg)
  end subroutine

  subroutine pcm_get_polygons(workspace, polygons, stat, errmsg)
    type(pcm_workspace), intent(in) :: workspace
    type(pcm_polygon), allocatable, intent(out) :: polygons(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    integer(c_int32_t) :: status
    allocate (polygons(workspace%polygons))
    status = c_copy_polygons(workspace%handle, polygons, bytes(size(polygons)), error)
    if (status == pcm_ok) then
      polygons%first = polygons%first + 1
      polygons%patch = polygons%patch + 1
    end if
    call finish(status, error, stat, errmsg)
  end subroutine

  subroutine pcm_get_crossings(workspace, crossings, stat, errmsg)
    type(pcm_workspace), intent(in) :: workspace
    type(pcm_crossing), allocatable, intent(out) :: crossings(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    integer(c_int32_t) :: status
    allocate (crossings(workspace%crossings))
    status = c_copy_crossings(workspace%handle, crossings, bytes(size(crossings)), error)
    if (status == pcm_ok) then
      crossings%edge(1) = crossings%edge(1) + 1
      crossings%edge(2) = crossings%edge(2) + 1
      crossings%face = crossings%face + 1
    end if
    call finish(status, error, stat, errmsg)
  end subroutine

  !> The active faces of a side, pcm_E or pcm_F, that are pcm_intersected or pcm_inner.
  subroutine pcm_get_faces(workspace, side, kind, faces, stat, errmsg)
    type(pcm_workspace), intent(in) :: workspace
    integer(c_int32_t), intent(in) :: side, kind
    integer(c_int32_t), allocatable, intent(out) :: faces(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    integer(c_int32_t) :: status
    ! The greatest length there is serves a side or kind that is none, which C then refuses.
    allocate (faces(maxval(workspace%faces)))
    if (any(side == (/pcm_E, pcm_F/)) .and. any(kind == (/pcm_intersected, pcm_inner/))) then
      deallocate (faces)
      allocate (faces(workspace%faces(kind, side)))
    end if
    status = c_copy_faces(workspace%handle, side, kind, faces, bytes(size(faces)), error)
    if (status == pcm_ok) faces = faces + 1
    call finish(status, error, stat, errmsg)
  end subroutine

  subroutine dispose_surface(surface)
    type(pcm_surface), intent(inout) :: surface
    call c_surface_dispose(surface%handle)
    surface%handle = c_null_ptr
  end subroutine

  subroutine dispose_pairing(pairing)
    type(pcm_pairing), intent(inout) :: pairing
    call c_pairing_dispose(pairing%handle)
    pairing%handle = c_null_ptr
  end subroutine

  subroutine dispose_workspace(workspace)
    type(pcm_workspace), intent(inout) :: workspace
    call c_workspace_dispose(workspace%handle)
    workspace%handle = c_null_ptr
  end subroutine

  pure function bytes(count) result(converted)
    integer, intent(in) :: count
    integer(c_size_t) :: converted
    converted = int(count, c_size_t)
  end function

  !> Tells what became of a call.
  subroutine finish(status, error, stat, errmsg)
    integer(c_int32_t), intent(in) :: status
    type(pcm_error), intent(in) :: error
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (present(stat)) stat = status
    if (status == pcm_ok) return
    if (present(errmsg)) errmsg = text_of(error)
    if (present(stat)) return
    write (error_unit, '(2a)') "pcm: ", text_of(error)
    stop 2
  end subroutine

  !> A call that is wrong already here.
  subroutine fail(text, stat, errmsg)
    character(*), intent(in) :: text
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    type(pcm_error) :: error
    integer :: i
    error%text = c_null_char
    do i = 1, len(text)
      error%text(i) = text(i:i)
    end do
    call finish(pcm_bad_call, error, stat, errmsg)
  end subroutine

  pure function text_of(error) result(text)
    type(pcm_error), intent(in) :: error
    character(length_of(error)) :: text
    integer :: i
    do i = 1, len(text)
      text(i:i) = error%text(i)
    end do
  end function

  pure function length_of(error) result(length)
    type(pcm_error), intent(in) :: error
    integer :: length
    length = 0
    do while (error%text(length + 1) /= c_null_char)
      length = length + 1
    end do
  end function
end module
