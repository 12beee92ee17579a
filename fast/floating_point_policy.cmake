# SPDX-License-Identifier: BSD-3-Clause
# One floating-point policy for everything whose bits are promised: round to nearest, no contraction into fused
# multiply-adds, no value-changing optimisation. Error-free transformations and the rounded problem depend on it.
add_library(pcm_floating_point INTERFACE)
target_compile_options(pcm_floating_point INTERFACE -ffp-contract=off)

# All that sets flags before the sources do; meshes/base/floating_point_policy.h refuses what comes otherwise.
get_directory_property(pcm_inherited_options COMPILE_OPTIONS)
string(JOIN " " pcm_flags ${pcm_inherited_options} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}
  ${CMAKE_CXX_FLAGS_RELWITHDEBINFO} ${CMAKE_CXX_FLAGS_MINSIZEREL} ${CMAKE_CXX_FLAGS_DEV} ${CMAKE_CXX_FLAGS_DEBUG} "")
foreach(flag IN ITEMS -ffast-math -Ofast -funsafe-math-optimizations -fassociative-math -freciprocal-math -ffinite-math-only)
  if(pcm_flags MATCHES "${flag} ")
    message(FATAL_ERROR "pcm: ${flag} changes values and breaks exact decisions; remove it from the compiler flags.")
  endif()
endforeach()
