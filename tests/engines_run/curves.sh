# SPDX-License-Identifier: MIT
#
# Mesa's llvmpipe draws flat_curved's triangles with the shader of docs/curves.md, without a display: each pixel is as the outlines say.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
pkg-config --exists egl gl 2>/dev/null || skip "EGL's or OpenGL's headers are not installed"
export LIBGL_ALWAYS_SOFTWARE=1
compile_tests "$scratch/curves" "$here/curves.cpp" -lEGL -lGL
"$scratch/curves" "$@"
