# SPDX-License-Identifier: MIT
#
# The HLSL shader of docs/curves.md: glslang compiles it to SPIR-V, spirv-cross translates that to GLSL, and Mesa draws with it the
# same texts as in curves.sh. Microsoft's compiler is untested.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
pkg-config --exists egl gl 2>/dev/null || skip "EGL's or OpenGL's headers are not installed"
for program in glslangValidator spirv-cross; do command -v $program >/dev/null 2>&1 || skip "$program is not installed"; done
sed -n '/^```hlsl$/,/^```$/p' "$root/docs/curves.md" | sed '1d;$d' >"$scratch/curves.hlsl"
[ -s "$scratch/curves.hlsl" ] || { fail "docs/curves.md has no HLSL shader" && exit 1; }
glslangValidator -D -V -S frag -e main -o "$scratch/curves.spv" "$scratch/curves.hlsl" || { fail "the shader does not compile" && exit 1; }
spirv-cross --version 330 --no-es --flatten-ubo --rename-interface-variable in 0 curve --output "$scratch/curves.glsl" \
    "$scratch/curves.spv" || { fail "the shader cannot be translated" && exit 1; }
export LIBGL_ALWAYS_SOFTWARE=1 TYPEMESH_CURVES_SHADER=$scratch/curves.glsl
compile_tests "$scratch/curves" "$here/curves.cpp" -lEGL -lGL
"$scratch/curves" "$@"
