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
install(EXPORT pcm-targets NAMESPACE pcm:: DESTINATION ${pcm_package_folder})
configure_package_config_file(cmake/pcm-config.cmake.in cmake/pcm-config.cmake INSTALL_DESTINATION ${pcm_package_folder})
# Until 1.0 a minor version may break callers.
write_basic_package_version_file(cmake/pcm-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cmake/pcm-config.cmake ${PROJECT_BINARY_DIR}/cmake/pcm-config-version.cmake
  DESTINATION ${pcm_package_folder})

# Paths from pcm.pc and from the prefix, so that neither is written into it.
set(pcm_pc_folder ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pcm_prefix_from_pc ${pcm_pc_folder} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" pcm_prefix_from_pc ${pcm_prefix_from_pc})
file(RELATIVE_PATH pcm_libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH pcm_includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(cmake/pcm.pc.in cmake/pcm.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cmake/pcm.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
