! SPDX-FileCopyrightText: 2026 The pcm authors
! SPDX-License-Identifier: GPL-3.0-or-later
!
!> answers FOLDER: asks, through the Fortran module, what write_answers has written there, and compares every bit. Then
!> a few calls that are refused.
program answers
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
  use pcm
  implicit none
  integer, parameter :: numbers = 52
  character(512) :: folder
  character(64) :: file_E, file_F
  type(pcm_pairing) :: pairing
  type(pcm_workspace) :: workspace  ! the same for all pairings
  integer :: unit, pairings, i, k, count, poses, differing

  call get_command_argument(1, folder)
  unit = 10
  open (unit, file=trim(folder)//"/answers.txt", status="old", action="read", recl=2000)
  read (unit, *) pairings
  poses = 0
  differing = 0
  do i = 1, pairings
    read (unit, *) file_E, file_F
    call read_pairing(trim(folder)//"/"//file_E, trim(folder)//"/"//file_F, pairing, count)
    do k = 1, count
      if (.not. same_answer()) differing = differing + 1
    end do
    poses = poses + count
  end do
  close (unit)
  call refuse_bad_input()
  ! The last of all: the test asks for this line alone, whatever the exit status is.
  print '(i0, a, i0, a)', poses, " poses, ", differing, " with another answer"
  call pcm_dispose(pairing)
  call pcm_dispose(workspace)

contains

  subroutine read_pairing(path_E, path_F, pairing, count)
    character(*), intent(in) :: path_E, path_F
    type(pcm_pairing), intent(inout) :: pairing
    integer, intent(out) :: count
    type(pcm_surface) :: E, F
    type(pcm_law) :: law
    integer(c_int64_t) :: bits(12)
    real(c_double) :: x(8)
    read (unit, '(12(z16, 1x))') bits
    x = transfer(bits(4:11), x)
    law = pcm_default_law()
    law%damping_mode = int(bits(3), c_int32_t)
    law%stiffness = x(1)
    law%layer_stiffness_E = x(2)
    law%layer_stiffness_F = x(3)
    law%damping = x(4)
    law%transition_depth = x(5)
    law%friction = x(6)
    law%slip_velocity = x(7)
    law%max_penetration = x(8)
    call read_surface(path_E, E)
    call read_surface(path_F, F)
    call pcm_define(E, F, law, int(bits(1), c_int32_t), int(bits(2), c_int32_t), pairing)
    call pcm_dispose(E)
    call pcm_dispose(F)
    count = int(bits(12))
  end subroutine

  !> As a file has it, taken apart into arrays and put together again.
  subroutine read_surface(path, surface)
    character(*), intent(in) :: path
    type(pcm_surface), intent(inout) :: surface
    real(c_double), allocatable :: vertices(:, :)
    integer(c_int32_t), allocatable :: faces(:, :)
    call pcm_read(path, surface)
    call pcm_get_mesh(surface, vertices, faces)
    call pcm_define(vertices, faces, surface)
  end subroutine

  function same_answer() result(same)
    logical :: same
    integer(c_int64_t) :: question(19), expected(numbers)
    real(c_double) :: state(18)
    type(pcm_answer) :: answer
    read (unit, '(19(z16, 1x))') question
    read (unit, '(52(z16, 1x))') expected
    state = transfer(question(2:19), state)
    call pcm_evaluate(pairing, transpose(reshape(state(1:9), (/3, 3/))), state(10:12), workspace, answer, &
      v=state(13:15), w=state(16:18), wanted=int(question(1), c_int32_t))
    same = all(numbers_of(answer, iand(question(1), int(pcm_wanted_tangent, c_int64_t)) /= 0) == expected)
  end function

  function numbers_of(a, with_tangent) result(bits)
    type(pcm_answer), intent(in) :: a
    logical, intent(in) :: with_tangent
    integer(c_int64_t) :: bits(numbers)
    real(c_double) :: x(33)
    bits(1:18) = (/a%touching, a%nested, a%ambiguous, a%has_volume, a%penetration_exceeded, a%too_deep, &
      a%undefined_areas, a%patches, a%polygons, a%crossings, a%element_count, a%elements, a%E%intersected, &
      a%E%inner, a%F%intersected, a%F%inner, a%bound%given, a%bound%flipped/)
    x = (/a%force_Me, a%torque_Me, a%max_penetration, a%volume, a%E%area, a%E%vector_area_Me, a%F%area, &
      a%F%vector_area_Me, a%bound%force_Me, a%bound%torque_Me, a%bound%penetration_at_least, &
      a%bound%penetration_at_most, a%statistics%patch_area, a%statistics%mean_penetration, &
      a%statistics%max_pressure, a%statistics%mean_pressure, a%statistics%max_normal_velocity, &
      a%statistics%max_tangential_velocity, a%statistics%centre_of_pressure_Me/)
    bits(19:51) = transfer(x, bits)
    bits(52) = checksum(with_tangent)
  end function

  !> Over all lists of the answer, numbered from 0 as in C.
  function checksum(with_tangent) result(total)
    logical, intent(in) :: with_tangent
    integer(c_int64_t) :: total
    real(c_double) :: tangent(6, 12)
    type(pcm_element), allocatable :: elements(:)
    type(pcm_polygon), allocatable :: polygons(:)
    type(pcm_crossing), allocatable :: crossings(:)
    integer(c_int32_t), allocatable :: faces(:)
    integer(c_int32_t) :: side, kind
    integer :: n, added
    total = 0
    added = 0
    call pcm_get_elements(workspace, elements)
    do n = 1, size(elements)
      call add(total, added, int((/elements(n)%master, elements(n)%master_face - 1, elements(n)%slave_face - 1/), &
        c_int64_t))
      call add(total, added, transfer((/elements(n)%area, elements(n)%penetration, elements(n)%normal_velocity, &
        elements(n)%tangential_velocity, elements(n)%normal_force, elements(n)%tangential_force, &
        elements(n)%normal_Me, elements(n)%position_Me, elements(n)%force_Me/), (/total/)))
    end do
    call pcm_get_polygons(workspace, polygons)
    do n = 1, size(polygons)
      call add(total, added, int((/polygons(n)%closed, polygons(n)%first - 1, polygons(n)%count, &
        polygons(n)%patch - 1/), c_int64_t))
    end do
    call pcm_get_crossings(workspace, crossings)
    do n = 1, size(crossings)
      call add(total, added, int((/crossings(n)%edge_side, crossings(n)%edge - 1, crossings(n)%face - 1/), c_int64_t))
      call add(total, added, transfer(crossings(n)%position_Me, (/total/)))
    end do
    do side = pcm_E, pcm_F
      do kind = pcm_intersected, pcm_inner
        call pcm_get_faces(workspace, side, kind, faces)
        call add(total, added, int(faces - 1, c_int64_t))
      end do
    end do
    if (with_tangent) then
      call pcm_get_tangent(workspace, tangent)
      do n = 1, 6
        call add(total, added, transfer(tangent(n, :), (/total/)))
      end do
    end if
  end function

  !> The exclusive or of all bits added, those of the i-th number rotated left by i modulo 64.
  subroutine add(total, added, bits)
    integer(c_int64_t), intent(inout) :: total
    integer, intent(inout) :: added
    integer(c_int64_t), intent(in) :: bits(:)
    integer :: n
    do n = 1, size(bits)
      total = ieor(total, ishftc(bits(n), mod(added, 64)))
      added = added + 1
    end do
  end subroutine

  subroutine refuse_bad_input()
    type(pcm_surface) :: surface
    type(pcm_pairing) :: undefined
    type(pcm_answer) :: answer
    type(pcm_element), allocatable :: elements(:)
    integer(c_int32_t), allocatable :: faces(:)
    real(c_double) :: A(3, 3), r(3), flat(2, 4)
    integer(c_int32_t) :: triangle(3, 1)
    integer :: stat
    character(200) :: errmsg
    triangle(:, 1) = (/1, 2, 3/)
    flat = 0
    A = 0
    r = 0
    call pcm_read("no_such_file.obj", surface, stat, errmsg)
    call expect("a missing file", stat, pcm_bad_input, errmsg, "no_such_file.obj")
    call pcm_define(flat, triangle, surface, stat, errmsg)
    call expect("vertices in a plane", stat, pcm_bad_call, errmsg, "(3, n)")
    call pcm_evaluate(undefined, A, r, workspace, answer, stat=stat, errmsg=errmsg)
    call expect("an undefined pairing", stat, pcm_bad_call, errmsg, "pairing is NULL")
    call pcm_evaluate(pairing, A, r, workspace, answer, stat=stat, errmsg=errmsg)
    call expect("no rotation", stat, pcm_bad_input, errmsg, "no rotation")
    call pcm_get_elements(workspace, elements, stat, errmsg)
    call expect("elements of no answer", stat, pcm_bad_call, errmsg, "no answer")
    call pcm_get_faces(workspace, 2_c_int32_t, pcm_inner, faces, stat, errmsg)
    call expect("faces of no answer", stat, pcm_bad_call, errmsg, "no answer")
  end subroutine

  subroutine expect(what, stat, wanted, errmsg, words)
    character(*), intent(in) :: what, errmsg, words
    integer, intent(in) :: stat, wanted
    if (stat == wanted .and. index(errmsg, words) > 0) return
    print '(4a, i0)', what, ": ", trim(errmsg), ", status ", stat
    stop 1
  end subroutine
end program
