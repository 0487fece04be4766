#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Writes the recipes as the registries of vcpkg and Conan take them: the sources are a release's archive, by its
# address and hash, and no longer the tree around the recipe.
#
#     registry.sh ARCHIVE ADDRESS HOMEPAGE FOLDER
#
#     ARCHIVE   the release's archive, with one folder in it, as ADDRESS serves it
#     FOLDER    gets ports/typemesh for vcpkg and recipes/typemesh for Conan; must not exist
#
# The version comes from the archive's headers. With `vcpkg x-add-version typemesh` vcpkg's registry then has it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
case ${1-} in -h | --help) sed -n '4,13s/^# \{0,1\}//p' "$0" && exit 0 ;; esac
[ $# = 4 ] || { echo "usage: registry.sh ARCHIVE ADDRESS HOMEPAGE FOLDER" >&2 && exit 2; }
archive=$1 address=$2 homepage=$3 folder=$4
[ ! -e "$folder" ] || { echo "$folder is there already" >&2 && exit 1; }
for text in "$address" "$homepage"; do
    case $text in *[!A-Za-z0-9:/._~%+@?=-]*) echo "$text is no address" >&2 && exit 1 ;; esac
done
version=$(tar xzOf "$archive" --wildcards '*/include/typemesh/core/version.hpp' |
    awk '/^#define TYPEMESH_VERSION_/ { v = v dot $3; dot = "." } END { print v }')
[ -n "$version" ] || { echo "$archive holds no typemesh" >&2 && exit 1; }
hash_of() { "sha$1sum" "$archive" | cut -d' ' -f1; }

port=$folder/ports/typemesh
mkdir -p "$port"
cp "$here/vcpkg/usage" "$port/"
awk -v address="$address" -v version="$version" -v hash="$(hash_of 512)" '
    /^# A port of this source tree/ { next }
    /^set\(source / {
        print "vcpkg_download_distfile(archive"
        print "    URLS \"" address "\""
        print "    FILENAME \"typemesh-" version ".tar.gz\""
        print "    SHA512 " hash ")"
        print "vcpkg_extract_source_archive(source ARCHIVE \"${archive}\")"
        next
    }
    { print }' "$here/vcpkg/portfile.cmake" >"$port/portfile.cmake"
awk -v homepage="$homepage" -v version="$version" '
    /"version-semver"/ { print "  \"version-semver\": \"" version "\","; next }
    { print }
    /"description": "Header-only/ { print "  \"homepage\": \"" homepage "\"," }' "$here/vcpkg/vcpkg.json" >"$port/vcpkg.json"

recipe=$folder/recipes/typemesh
mkdir -p "$recipe/all"
cp -r "$here/conan/test_package" "$recipe/all/"
cp "$here/../../tests/consumer/project/main.cpp" "$recipe/all/test_package/"
sed 's,\.\./.*/main\.cpp,main.cpp,' "$here/conan/test_package/CMakeLists.txt" >"$recipe/all/test_package/CMakeLists.txt"
awk -v homepage="$homepage" '
    /^# A Conan 2 recipe of this source tree/ { next }
    { print }
    /^    license = / { print "    url = \"" homepage "\""; print "    homepage = \"" homepage "\"" }' \
    "$here/conan/conanfile.py" >"$recipe/all/conanfile.py"
cat >"$recipe/config.yml" <<END
versions:
  "$version":
    folder: all
END
cat >"$recipe/all/conandata.yml" <<END
sources:
  "$version":
    url: "$address"
    sha256: "$(hash_of 256)"
END
