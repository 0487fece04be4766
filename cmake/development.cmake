# SPDX-License-Identifier: MIT
#
# What our own tests, benchmarks and examples are built with; nothing of it reaches a user of the library.

add_library(typemesh_dev INTERFACE)
target_link_libraries(typemesh_dev INTERFACE typemesh)
if(MSVC)  # cl, and clang-cl, which takes -Wall for every warning that it has
    target_compile_options(typemesh_dev INTERFACE /W4 /permissive- /utf-8)
else()
    target_compile_options(typemesh_dev INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
endif()

if(PROJECT_IS_TOP_LEVEL)
    set(CMAKE_CXX_EXTENSIONS OFF)
    find_program(TYPEMESH_CCACHE ccache DOC "Compiler cache for typemesh's own builds")
    if(TYPEMESH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
        set(CMAKE_CXX_COMPILER_LAUNCHER ${TYPEMESH_CCACHE})
    endif()
endif()

# The API reference, by Doxygen: reference/html/index.html in the build folder.
if(NOT CMAKE_HOST_WIN32)
    add_custom_target(typemesh_reference
        COMMAND sh ${PROJECT_SOURCE_DIR}/docs/reference/make.sh ${PROJECT_BINARY_DIR}/reference VERBATIM)
endif()
