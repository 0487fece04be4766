# SPDX-License-Identifier: MIT
#
# The single headers: each compiles without warnings, also in two units of one program, and the README's program prints the
# same with them as with the separate headers.
. "$TYPEMESH_TEST_DATA/packages/common.bash"
quietly sh "$root/cmake/packaging/single_header.sh" single || exit 1
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
libraries=$(pkg-config --cflags --libs harfbuzz freetype2 icu-uc fontconfig | sed 's, -I\([^ ]*\), -isystem \1,g; s,^-I,-isystem ,')
write_readme_program separate.cpp
sed 's,<typemesh/typemesh.hpp>,"typemesh_single.hpp",; s,<typemesh/adapt/\([a-z]*\).hpp>,"typemesh_single_\1.hpp",' separate.cpp >single.cpp
! cmp -s separate.cpp single.cpp || fail "The README's program includes no header of typemesh"
for adapter in harfbuzz freetype icu fontconfig glm threads; do printf '#include "typemesh_single_%s.hpp"\n' $adapter; done >all.cpp
# shellcheck disable=SC2086  # lists of words
quietly g++ -std=c++20 $warnings -Isingle single.cpp all.cpp $libraries -o single_program
# shellcheck disable=SC2086
quietly g++ -std=c++20 $warnings -I"$root/include" separate.cpp $libraries -o separate_program
[ "$(./single_program)" = "$(./separate_program)" ] || fail "The single headers make another mesh"
[ -n "$(./single_program)" ] || fail "The README's program prints nothing"
[ $failures = 0 ]
