#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Sources are as clang-format 19 leaves them by .clang-format (Debian: clang-format-19), and no line of a header is longer
# than 120 characters or holds a byte that is not ASCII: Microsoft's compiler without /utf-8, under an East Asian code page,
# can take such a comment and the line after it for one. Other versions differ in small things: with none of that version the status is 77.
#
#     format.sh              names the files that differ
#     format.sh --mend       formats them
#
# Not looked at: pages' snippets, whose lines stand in the pages as they are, and what functions.awk is tried with.
set -eu
cd "$(dirname "$0")/../.."
status=0

long=$(find include -name '*.hpp' -exec env LC_ALL=C.UTF-8 grep -HnE '^.{121,}' {} + || true)
if [ -n "$long" ]; then
    printf '%s\n' "$long" | cut -c 1-100
    echo "These lines of headers are longer than 120 characters: break them."
    status=1
fi

foreign=$(find include -type f -exec env LC_ALL=C grep -HnE '[^ -~[:cntrl:]]' {} + || true)
if [ -n "$foreign" ]; then
    printf '%s\n' "$foreign" | cut -c 1-100
    echo "These lines of headers are not ASCII: write \"Bezier\", draw with - | + and ^ v < >."
    status=1
fi

spliced=$(find include -type f -exec grep -HnE '//.*\\[[:space:]]*$|\?\?/' {} + || true)
if [ -n "$spliced" ]; then
    printf '%s\n' "$spliced" | cut -c 1-100
    echo "These comments go on in the next line, for a compiler: no backslash, nor ??/, at their end."
    status=1
fi

formatter=
for tool in clang-format-19 clang-format; do
    if command -v $tool >/dev/null 2>&1 && $tool --version | grep -q ' version 19\.'; then formatter=$tool && break; fi
done
if [ -z "$formatter" ]; then
    echo "clang-format 19 is not installed (Debian: clang-format-19), so formatting was not checked."
    [ $status = 0 ] && exit 77
    exit $status
fi

sources() {
    find include tests bench examples \( -name '*.hpp' -o -name '*.cpp' \) ! -name '*_snippets.cpp' \
        ! -path tests/architecture/sample.hpp -print | LC_ALL=C sort | tr '\n' '\0'
}
if [ "${1:-}" = --mend ]; then
    sources | xargs -0 "$formatter" -i
    exit $status
fi
differ=$(sources | xargs -0 "$formatter" --dry-run 2>&1 | sed -nE 's/^([^ :]+):[0-9]+:[0-9]+: warning: .*/\1/p' | LC_ALL=C sort -u)
if [ -n "$differ" ]; then
    printf '%s\n' "$differ"
    echo "These files are not as .clang-format says: sh tests/architecture/format.sh --mend formats them."
    status=1
fi
exit $status
