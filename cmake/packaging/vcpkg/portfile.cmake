# SPDX-License-Identifier: MIT
#
# A port of this source tree, for an overlay: vcpkg install typemesh --overlay-ports=cmake/packaging/vcpkg
# The features install the libraries of the adapters; the headers are the same.
set(VCPKG_BUILD_TYPE release)  # headers only

vcpkg_cmake_configure(
    SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.."
    OPTIONS
        -DTYPEMESH_BUILD_TESTS=OFF
        -DTYPEMESH_BUILD_BENCH=OFF
        -DTYPEMESH_BUILD_EXAMPLES=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/typemesh)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${CMAKE_CURRENT_LIST_DIR}/../../../LICENSE")
