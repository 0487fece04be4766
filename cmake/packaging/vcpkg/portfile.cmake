# SPDX-License-Identifier: MIT
#
# A port of this source tree, for an overlay: vcpkg install typemesh --overlay-ports=cmake/packaging/vcpkg
# Each feature is an adapter, whose library must then be there when the port is made.
set(source "${CMAKE_CURRENT_LIST_DIR}/../../..")  # registry.sh: the archive of a release
set(VCPKG_BUILD_TYPE release)  # headers only

set(adapters "${FEATURES}")
list(REMOVE_ITEM adapters core)
vcpkg_cmake_configure(
    SOURCE_PATH "${source}"
    OPTIONS
        "-DTYPEMESH_ADAPTERS=${adapters}"
        -DTYPEMESH_BUILD_TESTS=OFF
        -DTYPEMESH_BUILD_BENCH=OFF
        -DTYPEMESH_BUILD_EXAMPLES=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/typemesh)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${source}/LICENSE")
