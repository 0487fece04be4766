# SPDX-License-Identifier: MIT
#
# The recipe of docs/engines.md fills an osg::Geometry; OpenSceneGraph measures it and draws it with llvmpipe.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
pkg-config --exists openscenegraph-osgViewer 2>/dev/null || skip "OpenSceneGraph is not installed"
open_display
compile_tests "$scratch/openscenegraph" "$here/openscenegraph.cpp" "$root/tests/compile/openscenegraph_snippets.cpp" \
    $(flags_of openscenegraph-osgViewer openscenegraph-osg)
"$scratch/openscenegraph"
