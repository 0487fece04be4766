# SPDX-License-Identifier: MIT
#
# The Debian packages, installed and used on a system that has nothing but Debian's base: the README's program is compiled
# against libtypemesh-dev, by pkg-config and by CMake, and text_to_mesh writes a mesh.
. "$TYPEMESH_TEST_DATA/packages/common.bash"
[ "$(id -u)" = 0 ] || skip "a bare system is made by root only (debootstrap)"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
system=$PWD/debian
mirror=$(apt-get indextargets --format '$(SITE) $(RELEASE)' | awk '$2 !~ /-/ { print; exit }')
[ -n "$mirror" ] || skip "apt-get names no release of Debian"
if [ ! -e "$system/made" ]; then
    rm -rf "$system"
    quietly debootstrap --variant=minbase "${mirror#* }" "$system" "${mirror% *}" || exit 1
    touch "$system/made"
fi
rm -rf "$system/try" && mkdir "$system/try"
cp "$packages"/*.deb "$packages"/*.sha256 "$system/try"
write_readme_program "$system/try/main.cpp"
cat >"$system/try/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.20)
project(user LANGUAGES CXX)
find_package(typemesh 0.1 REQUIRED COMPONENTS harfbuzz)
add_executable(user main.cpp)
target_link_libraries(user PRIVATE typemesh::harfbuzz)
CMAKE
inside() { quietly env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive chroot "$system" /bin/sh -c "cd /try && $1"; }
inside "for f in *.deb; do sha256sum -c \$f.sha256; done"
inside "apt-get install -y --no-install-recommends ./text-to-mesh_*.deb fonts-dejavu-core" &&
    inside "text_to_mesh 'Hello world!' --font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --output hello.glb && test -s hello.glb" &&
    inside "test -s /usr/share/doc/text-to-mesh/copyright" &&
    inside "text_to_mesh --help | grep -o -- '^  -[^ ]*' | tr , '\\n' | tr -d ' ' | while read -r o; do tr -d '\\\\' </usr/share/man/man1/text_to_mesh.1 | grep -q -- \"\$o\" || exit 1; done"
[ "$(dpkg-deb -f "$packages"/text-to-mesh_*.deb Description)" != "$(dpkg-deb -f "$packages"/libtypemesh-dev_*.deb Description)" ] ||
    fail "both packages have one description"
inside "apt-get install -y --no-install-recommends ./libtypemesh-dev_*.deb g++ cmake make pkg-config libharfbuzz-dev" &&
    inside "g++ -std=c++20 main.cpp \$(pkg-config --cflags --libs typemesh-harfbuzz) -o main && ./main" &&
    inside "cmake -S . -B build && cmake --build build && build/user" &&
    inside "test -s /usr/share/doc/libtypemesh-dev/copyright"
[ $failures = 0 ]
