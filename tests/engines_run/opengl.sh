# SPDX-License-Identifier: MIT
#
# Mesa's llvmpipe draws texts from mapped buffers under Xvfb: no back face is seen, the pixels inside the outlines are covered.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
pkg-config --exists gl x11 2>/dev/null || skip "OpenGL's or X11's headers are not installed"
open_display
compile_tests "$scratch/opengl" "$here/opengl.cpp" "$here/opengl_context.cpp" -lGL -lX11
"$scratch/opengl"
