# SPDX-License-Identifier: MIT
#
# Irrlicht, compiled as C++14, takes a text from a unit of C++20; it runs with the null device. The header between the two is
# plain C++11.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
headers=
for folder in /usr/include /usr/local/include "${HOMEBREW_PREFIX:-/opt/homebrew}/include"; do
    [ ! -e "$folder/irrlicht/irrlicht.h" ] || headers=$folder/irrlicht
done
[ -n "$headers" ] || skip "Irrlicht is not installed"

compile_cpp "$scratch/header.o" c++11 -Werror -pedantic -include engines/irrlicht_text.hpp -x c++ -c /dev/null
compile_cpp "$scratch/scene.o" c++14 -isystem "$headers" -c "$here/irrlicht_scene.cpp"
compile_tests "$scratch/irrlicht" "$here/irrlicht.cpp" "$root/examples/engines/irrlicht_text.cpp" "$scratch/scene.o" -lIrrlicht
"$scratch/irrlicht"
