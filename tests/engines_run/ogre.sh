# SPDX-License-Identifier: MIT
#
# The recipe of docs/engines.md fills OGRE's buffers; OGRE finds the mesh closed.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
pkg-config --exists OGRE 2>/dev/null || skip "OGRE is not installed"
compile_tests "$scratch/ogre" "$here/ogre.cpp" "$root/tests/compile/ogre_snippets.cpp" $(flags_of OGRE)
"$scratch/ogre"
