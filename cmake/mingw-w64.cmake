# SPDX-License-Identifier: MIT
#
# Windows programs, built on another system with mingw-w64 and run under Wine: cmake --preset windows, or any project with
# -DCMAKE_TOOLCHAIN_FILE=cmake/mingw-w64.cmake. The programs stand alone. Wine works in a folder of this build's own
# (0.7 GB), says nothing of itself and needs no display.

set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
find_program(TYPEMESH_MINGW NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++ REQUIRED
    DOC "The cross compiler of mingw-w64")
set(CMAKE_CXX_COMPILER ${TYPEMESH_MINGW})
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)

foreach(kind IN ITEMS LIBRARY INCLUDE PACKAGE)
    set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)

set(CMAKE_CROSSCOMPILING_EMULATOR
    env WINEPREFIX=${CMAKE_BINARY_DIR}/wine WINEDEBUG=-all WINEDLLOVERRIDES=mscoree,mshtml= DISPLAY= wine)
