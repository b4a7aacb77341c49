# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` lays down beside the libraries: the exported CMake package and a
# pkg-config file.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/trihedron)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/trihedron-config.cmake.in
  ${PROJECT_BINARY_DIR}/trihedron-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/trihedron-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/trihedron-config.cmake
              ${PROJECT_BINARY_DIR}/trihedron-config-version.cmake DESTINATION ${package_dir})
install(EXPORT trihedron NAMESPACE trihedron:: FILE trihedron-targets.cmake
        DESTINATION ${package_dir})

# Relative, so that `cmake --install --prefix` may choose the place.
file(RELATIVE_PATH prefix_from_pkgconfig /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/trihedron.pc.in ${PROJECT_BINARY_DIR}/trihedron.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/trihedron.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
