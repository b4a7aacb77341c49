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

# Two Debian packages by `cpack`: trihedron, the program with manual page and completions, and
# trihedron-dev, the libraries for C++ users.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME trihedron)
set(CPACK_PACKAGE_CONTACT "Trihedron maintainers <maintainers@trihedron.example>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME trihedron)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "recognises polyhedral objects from three camera views
 Simulates a streaming hardware front end (contours and vertices), recognises
 and locates objects known as CAD models, calibrates cameras.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME trihedron-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "libeigen3-dev, libopencv-dev, nlohmann-json3-dev, libfmt-dev, libceres-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "libraries of Trihedron for C++ programs
 Static libraries, headers, CMake package and pkg-config file of Trihedron,
 which recognises polyhedral objects from three camera views.")

# What Debian expects beside the files themselves.
set(debian ${PROJECT_BINARY_DIR}/debian)
file(MAKE_DIRECTORY ${debian})
file(WRITE ${debian}/copyright
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: trihedron

Files: *
Copyright: 2026 Trihedron contributors
License: Apache-2.0
 On Debian systems the full text is in /usr/share/common-licenses/Apache-2.0.
")
file(WRITE ${debian}/changelog
"trihedron (${PROJECT_VERSION}) unstable; urgency=medium

  * This version; CHANGELOG.md of the project says what changed.

 -- Trihedron maintainers <maintainers@trihedron.example>  Sun, 22 Nov 2026 00:00:00 +0000
")
find_program(GZIP gzip)
if(GZIP)
  execute_process(COMMAND ${GZIP} -9nkf ${debian}/changelog)
  foreach(part program dev)
    string(REPLACE "program" "trihedron" name ${part})
    string(REPLACE "dev" "trihedron-dev" name ${name})
    install(FILES ${debian}/copyright ${debian}/changelog.gz
            DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${part})
  endforeach()
endif()
include(CPack)
