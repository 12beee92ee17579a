# SPDX-License-Identifier: BSD-3-Clause
# `cmake --install`: the engine for other projects, meshes/ and fast/; the whole tree may be moved afterwards.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS pcm_meshes pcm_fast EXPORT pcm-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(
  DIRECTORY meshes/include/ fast/include/ ${PROJECT_BINARY_DIR}/meshes/include/
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h")
install(FILES LICENSES/BSD-3-Clause.txt DESTINATION ${CMAKE_INSTALL_DOCDIR})  # the licence of all that is installed

set(pcm_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pcm)
if(TARGET pcm_simbody)
  install(TARGETS pcm_simbody EXPORT pcm-simbody-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(DIRECTORY simbody/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
  install(EXPORT pcm-simbody-targets NAMESPACE pcm:: DESTINATION ${pcm_package_folder})
endif()
# The component `c`, which may be installed alone: the shared library needs nothing of the rest.
if(TARGET pcm_c)
  install(TARGETS pcm_c EXPORT pcm-c-targets COMPONENT c INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(DIRECTORY bindings/c/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT c FILES_MATCHING PATTERN "*.h")
  # As sources: a module file is of use to the very compiler alone that wrote it.
  install(FILES bindings/fortran/pcm_c.f90 bindings/fortran/pcm.f90
    DESTINATION ${CMAKE_INSTALL_DATADIR}/pcm/fortran COMPONENT c)
  install(EXPORT pcm-c-targets NAMESPACE pcm:: DESTINATION ${pcm_package_folder} COMPONENT c)
endif()
install(EXPORT pcm-targets NAMESPACE pcm:: DESTINATION ${pcm_package_folder})
configure_package_config_file(cmake/pcm-config.cmake.in cmake/pcm-config.cmake INSTALL_DESTINATION ${pcm_package_folder})
# Until 1.0 a minor version may break callers.
write_basic_package_version_file(cmake/pcm-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cmake/pcm-config.cmake ${PROJECT_BINARY_DIR}/cmake/pcm-config-version.cmake
  DESTINATION ${pcm_package_folder})
install(FILES ${PROJECT_BINARY_DIR}/cmake/pcm-config.cmake ${PROJECT_BINARY_DIR}/cmake/pcm-config-version.cmake
  DESTINATION ${pcm_package_folder} COMPONENT c EXCLUDE_FROM_ALL)
install(FILES LICENSES/BSD-3-Clause.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT c EXCLUDE_FROM_ALL)

# Paths from pcm.pc and from the prefix, so that neither is written into it.
set(pcm_pc_folder ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pcm_prefix_from_pc ${pcm_pc_folder} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" pcm_prefix_from_pc ${pcm_prefix_from_pc})
file(RELATIVE_PATH pcm_libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH pcm_includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(cmake/pcm.pc.in cmake/pcm.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cmake/pcm.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(TARGET pcm_c)
  configure_file(cmake/pcm-c.pc.in cmake/pcm-c.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/cmake/pcm-c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT c)
endif()
