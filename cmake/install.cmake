# SPDX-License-Identifier: MIT
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(typemesh_package_folder ${CMAKE_INSTALL_DATADIR}/cmake/typemesh)

install(DIRECTORY include/typemesh DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    COMPONENT headers FILES_MATCHING PATTERN "*.hpp" PATTERN "compiled/*.cpp")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/typemesh COMPONENT headers)
install(TARGETS typemesh typemesh_unfused EXPORT typemesh-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT typemesh-targets NAMESPACE typemesh:: DESTINATION ${typemesh_package_folder} COMPONENT headers)

configure_package_config_file(cmake/typemesh-config.cmake.in typemesh-config.cmake
    INSTALL_DESTINATION ${typemesh_package_folder} PATH_VARS CMAKE_INSTALL_INCLUDEDIR NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
set(typemesh_compatibility SameMajorVersion)
if(PROJECT_VERSION_MAJOR EQUAL 0)  # before 1.0 a new minor version may break its users
    set(typemesh_compatibility SameMinorVersion)
endif()
write_basic_package_version_file(typemesh-config-version.cmake
    COMPATIBILITY ${typemesh_compatibility} ARCH_INDEPENDENT)
install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/typemesh-config.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/typemesh-config-version.cmake
    cmake/typemesh-adapters.cmake
    DESTINATION ${typemesh_package_folder} COMPONENT headers)

# For pkg-config: typemesh, and typemesh-harfbuzz and so on, which need the adapter's library.
function(typemesh_install_pc name description needs)
    set(pc_name ${name})
    set(pc_description "${description}")
    set(pc_needs "${needs}")
    configure_file(cmake/packaging/typemesh.pc.in ${name}.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig COMPONENT headers)
endfunction()

typemesh_install_pc(typemesh "${PROJECT_DESCRIPTION}" "Cflags: -I\${includedir}")
foreach(adapter IN ITEMS "harfbuzz|Requires: typemesh, harfbuzz >= 4.0" "freetype|Requires: typemesh, freetype2"
        "fontconfig|Requires: typemesh, fontconfig" "icu|Requires: typemesh, icu-uc" "glm|Requires: typemesh, glm"
        "threads|Requires: typemesh\nCflags: -pthread\nLibs: -pthread" "directwrite|Requires: typemesh\nLibs: -ldwrite")
    string(REPLACE "|" ";" adapter "${adapter}")
    list(POP_FRONT adapter name)
    typemesh_install_pc(typemesh-${name} "typemesh's adapter ${name}" "${adapter}")
endforeach()

if(PROJECT_IS_TOP_LEVEL)
    include(cmake/packaging/packages.cmake)
endif()
