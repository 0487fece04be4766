# SPDX-License-Identifier: MIT
#
# The WGSL shader of docs/curves.md: Chromium's WebGPU draws with it, by SwiftShader, the same texts as in curves.sh.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
pkg-config --exists egl gl 2>/dev/null || skip "EGL's or OpenGL's headers are not installed"
command -v node >/dev/null 2>&1 || skip "node is not installed"
browser=
for name in chromium chromium-browser google-chrome; do
    [ -n "$browser" ] || browser=$(command -v $name) || true
done
[ -n "$browser" ] || skip "Chromium is not installed"
mkdir -p "$scratch/scenes" "$scratch/home"
compile_tests "$scratch/curves" "$here/curves.cpp" -lEGL -lGL
TYPEMESH_CURVES_SCENES=$scratch/scenes "$scratch/curves" "[scenes]"
sed -n '/^```wgsl$/,/^```$/p' "$root/docs/curves.md" | sed '1d;$d' >"$scratch/curves.wgsl"
[ -s "$scratch/curves.wgsl" ] || { fail "docs/curves.md has no WGSL shader" && exit 1; }
HOME=$scratch/home node "$here/curves_wgsl.mjs" "$browser" "$here/curves_wgsl.html" "$scratch/curves.wgsl" "$scratch/scenes" "$scratch/profile"
