! SPDX-FileCopyrightText: 2026 The pcm authors
! SPDX-License-Identifier: BSD-3-Clause
program bubbles
  use, intrinsic :: iso_c_binding, only: c_double
  use pcm
  implicit none
  type(pcm_surface) :: bubble
  type(pcm_law) :: law
  type(pcm_pairing) :: pairing
  type(pcm_workspace) :: workspace  ! one per thread
  type(pcm_answer) :: answer
  real(c_double) :: A(3, 3), r(3)

  call pcm_read("meshes/surfaces/bubble.obj", bubble)  ! stops the program if it can't, for there is no stat=
  law = pcm_default_law()
  law%stiffness = 5.9e5_c_double
  call pcm_define(bubble, bubble, law, pcm_mode_both, pcm_barycentric, pairing)
  A(1, :) = (/1.0_c_double, 0.0_c_double, 0.0_c_double/)
  A(2, :) = (/0.0_c_double, 0.96_c_double, -0.28_c_double/)
  A(3, :) = (/0.0_c_double, 0.28_c_double, 0.96_c_double/)
  r = (/0.16_c_double, 0.02_c_double, 0.01_c_double/)
  call pcm_evaluate(pairing, A, r, workspace, answer, wanted=pcm_wanted_force)
  print '(a, 3(1x, g0.6), a)', "force on E:", answer%force_Me, " N"
  call pcm_dispose(workspace)
  call pcm_dispose(pairing)
  call pcm_dispose(bubble)
end program
