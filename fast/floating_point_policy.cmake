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

# Where there are fused multiply-adds, GCC's vectorizer makes one of a product whose neighbour is subtracted where it is
# added itself (a b - c beside d e + f: vfmaddsub), even with contraction off (seen in 12.2, at -O2 and -O3). Asked anew
# each time: a cached answer would outlive a change of flags. What a parent project sets by target stays unseen.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  include(CheckCXXSourceCompiles)
  unset(PCM_NO_FUSED_INSTRUCTIONS CACHE)
  string(JOIN " " CMAKE_REQUIRED_FLAGS ${pcm_inherited_options})
  check_cxx_source_compiles("
    #if defined(__FMA__) || defined(__FMA4__) || defined(__AVX512F__)
    #error
    #endif
    int main() {}" PCM_NO_FUSED_INSTRUCTIONS)
  unset(CMAKE_REQUIRED_FLAGS)
  if(NOT PCM_NO_FUSED_INSTRUCTIONS)
    target_compile_options(pcm_floating_point INTERFACE -fno-tree-vectorize)
  endif()
endif()
