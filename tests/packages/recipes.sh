# SPDX-License-Identifier: MIT
#
# The recipes of vcpkg, Conan and npm: their versions are the header's, they are well-formed, and where the tools are installed
# they make the package.
. "$TYPEMESH_TEST_DATA/packages/common.bash"
folder=$root/cmake/packaging
version=$(awk '/^#define TYPEMESH_VERSION_/ { v = v dot $3; dot = "." } END { print v }' "$root/include/typemesh/core/version.hpp")
grep -q "\"version-semver\": \"$version\"" "$folder/vcpkg/vcpkg.json" || fail "vcpkg.json has another version than $version"
grep -q "\"version\": \"$version\"" "$root/examples/web/package/package.json" || fail "npm's package.json has another version than $version"
for recipe in vcpkg/vcpkg.json conan/conanfile.py ../../examples/web/package/package.json; do
    grep -q 'license.*MIT.*Unicode-3\.0' "$folder/$recipe" || fail "$recipe does not name both licences of LICENSE"
done
quietly python3 -m json.tool "$folder/vcpkg/vcpkg.json"
! command -v pyflakes3 >/dev/null || quietly pyflakes3 "$folder/conan/conanfile.py" "$folder/conan/test_package/conanfile.py"
tried=
if command -v conan >/dev/null; then
    tried=yes
    quietly conan create "$folder/conan" --build=missing -s compiler.cppstd=20
fi
if command -v vcpkg >/dev/null; then
    tried=yes
    quietly vcpkg install typemesh --overlay-ports="$folder/vcpkg" --x-install-root="$PWD/vcpkg"
fi
[ $failures = 0 ] || exit 1
[ -n "$tried" ] || skip "the recipes are well-formed; neither conan nor vcpkg is installed to try them"
