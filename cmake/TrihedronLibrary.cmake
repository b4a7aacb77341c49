# SPDX-License-Identifier: Apache-2.0
include(GNUInstallDirs)

# trihedron_library(NAME DEPENDS...): the static library trihedron_NAME (alias
# trihedron::NAME) from all sources of the current folder; headers are included as
# "NAME/header.hpp".
function(trihedron_library name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(trihedron_${name} STATIC ${sources})
  add_library(trihedron::${name} ALIAS trihedron_${name})
  target_include_directories(trihedron_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/..>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/trihedron>)
  target_compile_options(trihedron_${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  target_link_libraries(trihedron_${name} PUBLIC ${ARGN})
  set_target_properties(trihedron_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS trihedron_${name} EXPORT trihedron ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY . DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trihedron/${name}
          FILES_MATCHING PATTERN "*.hpp")
endfunction()
