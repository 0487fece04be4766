# SPDX-License-Identifier: MIT
#
# The recipes in the form of the registries of vcpkg and Conan: the port is made from the release's archive by CMake with
# vcpkg's functions in a few lines each, its package is used; Conan's recipe names that archive by its address and hash.
. "$TYPEMESH_TEST_DATA/packages/common.bash"
write=$root/cmake/packaging/registry.sh
archive=$(echo "$packages"/typemesh-*[0-9].tar.gz)
home=https://typemesh.example
rm -rf registry downloads made && mkdir -p downloads made
quietly sh "$write" "$archive" "file://$archive" "$home" "$PWD/registry" || exit 1
! sh "$write" "$archive" "file://$archive" "$home" "$PWD/registry" 2>/dev/null || fail "a folder was written over"
! sh "$write" "$archive" 'a"b' "$home" "$PWD/other" 2>/dev/null || fail 'a"b was taken for an address'
port=$PWD/registry/ports/typemesh recipe=$PWD/registry/recipes/typemesh
version=$(basename "$archive" .tar.gz) && version=${version#typemesh-}

quietly python3 - "$port/vcpkg.json" "$recipe" "$version" "$home" "$archive" <<'END' || exit 1
import ast, hashlib, json, sys
manifest, recipe, version, home, archive = sys.argv[1:]
port = json.load(open(manifest))
assert (port["version-semver"], port["homepage"]) == (version, home), port
assert port["license"] == "MIT AND Unicode-3.0", port
lines = open(recipe + "/all/conandata.yml").read().splitlines()
wanted = ["sources:", f'  "{version}":', f'    url: "file://{archive}"',
          f'    sha256: "{hashlib.sha256(open(archive, "rb").read()).hexdigest()}"']
assert lines == wanted, lines
assert open(recipe + "/config.yml").read().split() == ["versions:", f'"{version}":', "folder:", "all"]
body = next(n for n in ast.parse(open(recipe + "/all/conanfile.py").read()).body if isinstance(n, ast.ClassDef)).body
values = {n.targets[0].id: n.value for n in body if isinstance(n, ast.Assign)}
assert ast.literal_eval(values["homepage"]) == home and ast.literal_eval(values["url"]) == home
assert ast.literal_eval(values["license"]) == ("MIT", "Unicode-3.0")
END

# What vcpkg gives to a port.
cat >vcpkg.cmake <<'END'
set(PORT typemesh)
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_QUIET)
    if(failed)
        message(FATAL_ERROR "${ARGN}")
    endif()
endfunction()
function(vcpkg_download_distfile result)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "FILENAME;SHA512" "URLS")
    file(DOWNLOAD ${arg_URLS} ${DOWNLOADS}/${arg_FILENAME} EXPECTED_HASH SHA512=${arg_SHA512})
    set(${result} ${DOWNLOADS}/${arg_FILENAME} PARENT_SCOPE)
endfunction()
function(vcpkg_extract_source_archive result)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "ARCHIVE" "")
    file(ARCHIVE_EXTRACT INPUT ${arg_ARCHIVE} DESTINATION ${DOWNLOADS}/sources)
    file(GLOB folder ${DOWNLOADS}/sources/*)
    set(${result} ${folder} PARENT_SCOPE)
endfunction()
function(vcpkg_cmake_configure)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
    run(${CMAKE_COMMAND} -S ${arg_SOURCE_PATH} -B ${DOWNLOADS}/build -DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR} "${arg_OPTIONS}")
endfunction()
function(vcpkg_cmake_install)
    run(${CMAKE_COMMAND} --install ${DOWNLOADS}/build)
endfunction()
function(vcpkg_cmake_config_fixup)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "CONFIG_PATH" "")
    file(RENAME ${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH} ${CURRENT_PACKAGES_DIR}/share/typemesh)
endfunction()
function(vcpkg_fixup_pkgconfig)
endfunction()
function(vcpkg_install_copyright)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
    file(COPY_FILE ${arg_FILE_LIST} ${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright)
endfunction()
include(${PORTFILE})
END
make_port() {  # make_port FEATURE...
    rm -rf made downloads && mkdir downloads
    cmake "-DFEATURES=core$(printf ';%s' "$@")" -DPORTFILE="$port/portfile.cmake" -DDOWNLOADS="$PWD/downloads" \
        -DCURRENT_PACKAGES_DIR="$PWD/made" -P vcpkg.cmake
}
quietly make_port harfbuzz freetype || exit 1
quietly diff -r "$root/include/typemesh" made/include/typemesh
quietly cmp "$root/LICENSE" made/share/typemesh/copyright
[ -f made/share/typemesh/usage ] && [ -f made/share/typemesh/typemesh-config.cmake ] || fail "the port lacks a file"
! make_port harfbuzz no_such_adapter >made.log 2>&1 || fail "a feature whose library is missing was no error"
grep -q "no typemesh::no_such_adapter" made.log || fail "the port's error does not name the adapter: $(cat made.log)"
[ $failures = 0 ]
