# SPDX-License-Identifier: MIT
#
# Khronos' glTF validator finds no error and no warning in the GLB of any text, its letters instanced, numbered, apart or not, nor
# in what the recipe examples/engines/gltf.hpp writes.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
command -v node >/dev/null 2>&1 || { echo "node is not installed"; exit 77; }
node -e 'require("gltf-validator")' 2>/dev/null || { echo "the npm package gltf-validator is not installed"; exit 77; }

count=0
write() {  # write FONT TEXT OPTION...
    count=$((count + 1))
    local option
    for option in "" --instances --letters --per-letter; do
        # shellcheck disable=SC2086  # a word or none
        "$TYPEMESH_TEXT_TO_MESH" --font "$1" --output "$scratch/$count$option.glb" $option "${@:3}" -- "$2" >/dev/null 2>"$scratch/losses" ||
            fail "text_to_mesh failed: $*: $(cat "$scratch/losses")"
    done
}
kinds=0
write_glb() {
    write_kind "$scratch/$1.glb" "$@" && kinds=$((kinds + 1))
}
for_every_kind write_glb
write_glb inlay /usr/share/fonts/truetype/liberation/LiberationSerif-Bold.ttf "Rag 8&" --plate 0.2 --inlay --bevel 0.01 --colour red
for_every_text write
for_every_bevel write
if [ -x "${TYPEMESH_TEST_ENGINES:-}" ]; then
    TYPEMESH_KEEP_GLB=$scratch "$TYPEMESH_TEST_ENGINES" "a quantised glTF file*" >"$scratch/recipes" || fail "$(cat "$scratch/recipes")"
fi
cat >"$scratch/validate.js" <<'END'
const fs = require('fs'), validator = require('gltf-validator');
(async () => {
    let bad = 0;
    for (const file of process.argv.slice(2)) {
        const { issues } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
        if (issues.numErrors + issues.numWarnings === 0) continue;
        console.log(file, JSON.stringify(issues.messages.slice(0, 3)));
        bad = 1;
    }
    process.exit(bad);
})();
END
node "$scratch/validate.js" "$scratch"/*.glb || fail "gltf-validator complains"
echo "$count texts, $kinds other kinds"
[ "$failures" = 0 ] && [ "$count" -gt 90 ] && [ "$kinds" -ge 26 ] || exit 1
[ -x "${TYPEMESH_TEST_ENGINES:-}" ] || { echo "all texts pass, but the recipe was not tried: typemesh_test_engines is not built"; exit 77; }
