# SPDX-License-Identifier: MIT
#
# What cpack makes in a build folder: libtypemesh-dev and text-to-mesh as Debian packages (cpack -G DEB), both as archives
# (cpack -G TGZ), and the sources (cpack --config CPackSourceConfig.cmake), each with its SHA-256 beside it.
# tests/run.sh --only packages makes them all and tries them.

set(CPACK_PACKAGE_NAME typemesh)
set(CPACK_PACKAGE_VENDOR typemesh)
set(CPACK_PACKAGE_CONTACT "the authors of typemesh")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "3D meshes of text: flat, extruded, bevelled")  # of both packages
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_CURRENT_SOURCE_DIR}/LICENSE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR TGZ)
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME typemesh-${PROJECT_VERSION})
set(CPACK_SOURCE_IGNORE_FILES "/build/" "/[.]git/" "/node_modules/" "/examples/web/package/(typemesh[.]wasm|LICENSE|.*[.]tgz)$"
    "^${CMAKE_CURRENT_SOURCE_DIR}/(CMakeUserPresets[.]json|compile_commands[.]json|hello[.](glb|png))$")

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
set(CPACK_DEBIAN_HEADERS_DESCRIPTION "A header-only C++20 library. It turns
text into triangles in vertices of the caller's own layout: outlines and
shaping by HarfBuzz or FreeType, exact overlaps, two triangulators, paragraphs.
The core needs the standard library alone.")
if(TARGET text_to_mesh)
    install(TARGETS text_to_mesh RUNTIME COMPONENT tool)
    install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/text-to-mesh RENAME copyright COMPONENT tool EXCLUDE_FROM_ALL)
    if(NOT CMAKE_CROSSCOMPILING AND UNIX)  # the page is what the program's --help says
        add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/text_to_mesh.1
            COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/cmake/packaging/man_page.sh $<TARGET_FILE:text_to_mesh>
                text_to_mesh.1
            DEPENDS text_to_mesh cmake/packaging/man_page.sh VERBATIM)
        add_custom_target(typemesh_man_page ALL DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/text_to_mesh.1)
        install(FILES ${CMAKE_CURRENT_BINARY_DIR}/text_to_mesh.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tool)
    endif()
    list(APPEND CPACK_COMPONENTS_ALL tool)
    set(CPACK_DEBIAN_TOOL_PACKAGE_NAME text-to-mesh)
    set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION graphics)
    set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_TOOL_DESCRIPTION "A program for the command line. It
writes a text in any installed font as a mesh: flat, extruded, bevelled, bold
or hollow, as glTF, OBJ, STL, PLY or 3MF, and draws a picture of it. Texts are
shaped by HarfBuzz, wrapped, justified, styled and coloured; meshes are closed
and, for 3D printing, in millimetres on z = 0.")
endif()
include(CPack)
