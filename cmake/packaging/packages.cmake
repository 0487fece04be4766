# SPDX-License-Identifier: MIT
#
# What cpack makes in a build folder: libtypemesh-dev and text-to-mesh as Debian packages (cpack -G DEB), both as archives
# (cpack -G TGZ), and the sources (cpack --config CPackSourceConfig.cmake), each with its SHA-256 beside it.
# tests/run.sh --only packages makes them all and tries them.

set(CPACK_PACKAGE_NAME typemesh)
set(CPACK_PACKAGE_VENDOR typemesh)
set(CPACK_PACKAGE_CONTACT "the authors of typemesh")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_CURRENT_SOURCE_DIR}/LICENSE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR TGZ)
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME typemesh-${PROJECT_VERSION})
set(CPACK_SOURCE_IGNORE_FILES "/build/" "/[.]git/" "/node_modules/")

set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL headers)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libtypemesh-dev RENAME copyright  # where Debian looks for it
    COMPONENT headers EXCLUDE_FROM_ALL)
set(CPACK_DEBIAN_HEADERS_PACKAGE_NAME libtypemesh-dev)
set(CPACK_DEBIAN_HEADERS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SUGGESTS "libharfbuzz-dev, libfreetype-dev, libicu-dev, libglm-dev, libfontconfig-dev")
set(CPACK_COMPONENT_HEADERS_DESCRIPTION "Header-only C++20 library that makes meshes of text: flat, extruded or bevelled, for any vertex layout.")
if(TARGET text_to_mesh)
    install(TARGETS text_to_mesh RUNTIME COMPONENT tool)
    install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/text-to-mesh RENAME copyright COMPONENT tool EXCLUDE_FROM_ALL)
    list(APPEND CPACK_COMPONENTS_ALL tool)
    set(CPACK_DEBIAN_TOOL_PACKAGE_NAME text-to-mesh)
    set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION graphics)
    set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
    set(CPACK_COMPONENT_TOOL_DESCRIPTION "Writes text as a mesh: glTF, OBJ, STL, PLY, 3MF or a picture.")
endif()
include(CPack)
