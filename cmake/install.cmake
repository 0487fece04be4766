# SPDX-License-Identifier: MIT
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(typemesh_package_folder ${CMAKE_INSTALL_DATADIR}/cmake/typemesh)

install(DIRECTORY include/typemesh DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.hpp" PATTERN "compiled/*.cpp")
install(TARGETS typemesh EXPORT typemesh-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT typemesh-targets NAMESPACE typemesh:: DESTINATION ${typemesh_package_folder})

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
    DESTINATION ${typemesh_package_folder})
