#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What Microsoft's compiler would see, as far as it can be tried without it: clang as clang-cl, in Microsoft's mode, for
# Microsoft's linker, over mingw-w64's headers and libstdc++, with CMake's flags for that front end.
#
#     run.sh WORK            WORK: a folder for the build
#
# It checks that
# - all headers, and the templates made of them, compile after windows.h without a warning of /W4;
# - the adapters of DirectWrite name their library to the linker, and read the same for every Windows that a unit may be
#   compiled for: units that differ in that must not break the one-definition rule;
# - nothing needs a function of the compiler's own library for 128 bits, which Microsoft's linker does not find;
# - with typemesh::unfused no multiplication is fused with an addition.
#
# Ends with 77 where clang or mingw-w64 is missing.
set -eu
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$1
clang=$(command -v clang++ || true)
mingw=$(command -v x86_64-w64-mingw32-g++-posix || command -v x86_64-w64-mingw32-g++ || true)
if [ -z "$clang" ] || [ -z "$mingw" ]; then
    echo "clang++ or mingw-w64 is not installed, so Microsoft's mode was not tried."
    exit 77
fi

rm -rf "$work" && mkdir -p "$work"
ln -s "$clang" "$work/clang-cl"  # whose name chooses the driver

# mingw's own folders of headers, as it lists them, less those with its compiler's.
flags="/imsvc$here/headers"
while IFS= read -r folder; do
    case $(basename "$folder") in include-fixed | include) [ -e "$folder/windows.h" ] || continue ;; esac
    flags="$flags /imsvc$folder"
done <<END
$("$mingw" -xc++ -E -v /dev/null 2>&1 >/dev/null | sed -n '/^#include <...>/,/^End/s/^ //p' | xargs -n 1 realpath)
END
# libstdc++ wants to see g++, and then takes a strict g++ for granted. Templates are read as late as cl reads them.
flags="$flags /clang:-fgnuc-version=12.2.0 /D__STRICT_ANSI__=1 /Zc:twoPhase-"

build() {  # build TARGET
    if ! cmake --build "$work/build" --target "$1" >"$work/$1.log" 2>&1; then
        head -n 60 "$work/$1.log"
        echo "$1 does not compile in Microsoft's mode."
        exit 1
    fi
}
# Nothing is linked. CMake looks for its findings on the compiler in a library, for which the bytes of its object will do.
cat >"$work/lib" <<'END'
#!/bin/sh
for word; do
    case $word in /out:*) out=${word#/out:} ;; *.obj) cat "$word" >"$out" ;; esac
done
END
chmod +x "$work/lib"
none=$(command -v true)
cmake -S "$here/project" -B "$work/build" -G Ninja -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_SYSTEM_PROCESSOR=AMD64 \
    -DCMAKE_CXX_COMPILER="$work/clang-cl" -DCMAKE_CXX_COMPILER_TARGET=x86_64-pc-windows-msvc \
    -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY -DCMAKE_AR="$work/lib" -DCMAKE_LINKER="$none" \
    -DCMAKE_MT="$none" -DCMAKE_RC_COMPILER="$none" \
    -DCMAKE_BUILD_TYPE=None -DCMAKE_COMPILE_WARNING_AS_ERROR=ON -DCMAKE_CXX_FLAGS="$flags" >"$work/cmake.log" 2>&1 || {
    cat "$work/cmake.log"
    exit 1
}
object_of() { find "$work/build" -name "$1.cpp.obj"; }

build every_policy
wanted=$("${mingw%-g++*}-nm" "$(object_of every_policy)" | grep -E ' U __[a-z]*[td][if][a-z0-9]*$' || true)
if [ -n "$wanted" ]; then
    printf '%s\n' "$wanted"
    echo "Microsoft's linker has none of these functions for integers of 128 bits."
    exit 1
fi

# Who copies the headers need not name the library. (objdump -s: 16 bytes a line, their letters in columns 44 to 59.)
case $("${mingw%-g++*}-objdump" -s -j .drectve "$(object_of every_policy)" | cut -c 44-59 | tr -d '\n') in
    *dwrite*) ;;
    *) echo "The adapters do not name dwrite.lib to the linker." && exit 1 ;;
esac

# The words of our own headers after preprocessing, of those that are compiled for one Windows.
words_for() {  # words_for _WIN32_WINNT NTDDI_VERSION
    # shellcheck disable=SC2086  # a list of words
    "$work/clang-cl" --target=x86_64-pc-windows-msvc $flags /std:c++20 "/D_WIN32_WINNT=$1" "/DNTDDI_VERSION=$2" "/I$here/../../include" \
        /E -- "$work/build/adapters.cpp" 2>"$work/words.log" |
        awk '/^# *[0-9]+ "/ { ours = index($0, "include/typemesh/") > 0; next } /^#line/ { exit 1 } ours && NF' || {
        cat "$work/words.log"
        exit 1
    }
}
printf '#include <windows.h>\n#include "adapter_headers.hpp"\n' >"$work/build/adapters.cpp"
words_for 0x0601 0x06010000 >"$work/windows7"
words_for 0x0A00 0x0A000006 >"$work/windows10"
[ "$(wc -l <"$work/windows7")" -gt 1000 ] || { echo "No words were found." && exit 1; }
if ! diff "$work/windows7" "$work/windows10" >"$work/words.diff"; then
    head -n 20 "$work/words.diff"
    echo "Adapters differ where units are compiled for different Windows."
    exit 1
fi

build unfused
code=$("${mingw%-g++*}-objdump" -d "$(object_of multiply_add)")
case $code in
    *vfmadd*) echo "typemesh::unfused fuses under clang-cl." && exit 1 ;;
    *vmulsd*vaddsd*) ;;
    *) printf '%s\n' "$code" "Neither a multiplication nor an addition was found." && exit 1 ;;
esac
