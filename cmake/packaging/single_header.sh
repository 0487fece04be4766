#!/bin/sh
# SPDX-License-Identifier: MIT
#
# usage: cmake/packaging/single_header.sh FOLDER
#
# Writes typemesh_single.hpp, all of the library but its adapters in one file, and typemesh_single_ADAPTER.hpp for each
# adapter, which includes the first. Each header stands where it was first included, once.
set -eu
case ${1:-} in
    -h | --help) sed -n '3,7s/^# \{0,1\}//p' "$0" && exit 0 ;;
esac
folder=${1:?usage: cmake/packaging/single_header.sh FOLDER}
include=$(cd "$(dirname "$0")/../../include" && pwd)
mkdir -p "$folder"
version=$(awk '/^#define TYPEMESH_VERSION_/ { v = v dot $3; dot = "." } END { print v }' "$include/typemesh/core/version.hpp")

# Prints the named headers and the headers that they include, except for the headers listed in the file `known`.
join() {  # join KNOWN HEADER...
    awk -v include="$include" '
        function put(header,   line, path) {
            if (header in put_already) return
            put_already[header] = 1
            path = include "/" header
            while ((status = (getline line < path)) > 0) {
                if (line ~ /^#include <typemesh\/compiled\//) {
                    print "#error \"typemesh::compiled is made of the separate headers, not of this one.\""
                } else if (line ~ /^#include <typemesh\//) {
                    sub(/^#include </, "", line)
                    sub(/>.*/, "", line)
                    put(line)
                } else if (line ~ /^#include <[a-z0-9_]+>$/ && !(line in put_already)) {
                    put_already[line] = 1
                    print line
                } else if (line !~ /^#include <[a-z0-9_]+>$/ && line !~ /^#pragma once/ && line !~ /^\/\/ SPDX/) {
                    print line
                }
            }
            if (status < 0) { print "There is no " path > "/dev/stderr"; exit 1 }
            close(path)
            if (known != "") print header > known
        }
        BEGIN {
            known = ARGV[1]
            while ((getline line < known) > 0) put_already[line] = 1
            close(known)
            for (i = 2; i < ARGC; i++) put(ARGV[i])
        }' "$@"
}

# The words at the beginning of each file.
begin() {  # begin WHAT
    printf '// SPDX-License-Identifier: MIT\n//\n// typemesh %s, %s. Made by cmake/packaging/single_header.sh:\n' "$version" "$1"
    printf '// change the headers of include/typemesh, not this file. Not to be mixed with those headers in one unit.\n//\n'
    sed 's,^,// ,; s, *$,,' "$include/../LICENSE"
    printf '#pragma once\n'
}

known=$(mktemp)
trap 'rm -f "$known"' EXIT
core=$(cd "$include" && find typemesh -name '*.hpp' ! -path 'typemesh/adapt/*' ! -path 'typemesh/compiled/*' | LC_ALL=C sort)
{
    begin "all but the adapters"
    # shellcheck disable=SC2086  # a list of words
    join "$known" typemesh/typemesh.hpp $core
} >"$folder/typemesh_single.hpp"
for adapter in harfbuzz freetype directwrite fontconfig icu glm threads; do
    of_adapter=$(mktemp)
    cp "$known" "$of_adapter"
    headers=$(cd "$include" && find typemesh/adapt -name "$adapter.hpp" -o -name "${adapter}_*.hpp" | LC_ALL=C sort)
    {
        begin "the adapter $adapter"
        printf '#include "typemesh_single.hpp"\n'
        # shellcheck disable=SC2086  # a list of words
        join "$of_adapter" $headers
    } >"$folder/typemesh_single_$adapter.hpp"
    rm -f "$of_adapter"
done
