# SPDX-License-Identifier: MIT
#
# The archives: the sources are configured and installed from the archive alone, and hold what git holds.
. "$TYPEMESH_TEST_DATA/packages/common.bash"
(cd "$packages" && for f in *.tar.gz; do quietly sha256sum -c "$f.sha256"; done) || failures=1
rm -rf sources prefix && mkdir sources
quietly tar xzf "$packages"/typemesh-*[0-9].tar.gz -C sources --strip-components=1
if git -C "$root" rev-parse >/dev/null 2>&1; then
    (cd "$root" && git ls-files | LC_ALL=C sort) >kept
    (cd sources && find . -type f | sed 's,^[.]/,,' | LC_ALL=C sort) >packed
    quietly diff kept packed
fi
quietly cmake -S sources -B sources/build -DTYPEMESH_BUILD_TESTS=OFF -DTYPEMESH_BUILD_BENCH=OFF -DTYPEMESH_BUILD_EXAMPLES=OFF
quietly cmake --install sources/build --prefix "$PWD/prefix"
quietly diff -r "$root/include/typemesh" prefix/include/typemesh
quietly cmp "$root/LICENSE" prefix/share/doc/typemesh/LICENSE
[ $failures = 0 ]
