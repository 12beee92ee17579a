# SPDX-License-Identifier: BSD-3-Clause
# The compilers that the bindings and their tests need beside that of C++, for the whole project: C for the tests alone,
# Fortran where it is found (Debian: gfortran). Sanitizers' runtime libraries are those of the C++ compiler, with which no
# other Fortran compiler goes together.
if(PCM_BUILD_TESTS AND PROJECT_IS_TOP_LEVEL)
  enable_language(C)
endif()
if(NOT PCM_SANITIZE)
  include(CheckLanguage)
  check_language(Fortran)
  if(CMAKE_Fortran_COMPILER)
    enable_language(Fortran)
  else()
    message(STATUS "no Fortran compiler (Debian: gfortran) is installed: Fortran is left out")
  endif()
endif()
