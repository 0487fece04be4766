#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Each header include/typemesh/ROOM/NAME.hpp or ROOM/impl/NAME.hpp has its tests in tests/ROOM/NAME.test.cpp,
# DirectWrite's in tests/windows.
# Headers that have none stand in mirror_exceptions.txt with the reason; that list only gets shorter.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
exceptions=$here/mirror_exceptions.txt
status=0
wrong() { echo "$*" && status=1; }

cd "$here/../../include/typemesh"
for header in $(find . -mindepth 2 -name '*.hpp' | sed 's,^\./,,' | LC_ALL=C sort); do
    tests=$(echo "${header%.hpp}.test.cpp" | sed 's,/impl/,/,')
    reason=$(sed -n "s,^$header  *,,p" "$exceptions")
    if [ -e "$here/../$tests" ] || { [ "${tests#adapt/directwrite}" != "$tests" ] && [ -e "$here/../windows/$(basename "$tests")" ]; }; then
        [ -z "$reason" ] || wrong "$header: has tests/$tests: take it out of mirror_exceptions.txt"
    elif [ -z "$reason" ]; then
        wrong "$header: write tests/$tests"
    fi
done
for header in $(sed -n 's,^\([a-z0-9_]*/[a-z0-9_]*\.hpp\) .*,\1,p' "$exceptions"); do
    [ -e "$header" ] || wrong "$header: is no more: take it out of mirror_exceptions.txt"
done
exit $status
