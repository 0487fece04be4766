# SPDX-License-Identifier: MIT
#
# Godot 3 imports a text's GLB without a window; a script in GDScript looks at surfaces, materials, counts, normals, winding,
# closedness and boxes.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
command -v godot3-server >/dev/null 2>&1 || skip "godot3-server is not installed"
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
[ -e "$font" ] || skip "DejaVu Sans is not installed"

project=$scratch/project
mkdir -p "$project" "$scratch/home"
printf 'config_version=4\n' >"$project/project.godot"
cp "$here/godot.gd" "$project/check.gd"
"$TYPEMESH_TEXT_TO_MESH" --font "$font" --output "$project/text.glb" --stats -- 'Lå&g' >"$scratch/stats" || fail "text_to_mesh failed"
cp "$project/text.glb" "$project/packed.glb"
# Godot packs normals into bytes unless an option forbids it.
cat >"$project/text.glb.import" <<'END'
[remap]

importer="scene"
type="PackedScene"

[params]

meshes/compress=false
END

count() {  # count NAME: a number that text_to_mesh has printed
    sed -nE "s/.*\"$1\":([0-9]+).*/\1/p" "$scratch/stats"
}
VERTICES=$(count vertices) TRIANGLES=$(sed -nE 's/.*"vertices":[0-9]+,"triangles":([0-9]+).*/\1/p' "$scratch/stats")
FRONT_TRIANGLES=$(sed -nE 's/.*"front":\{"triangles":([0-9]+).*/\1/p' "$scratch/stats")
export VERTICES TRIANGLES FRONT_TRIANGLES HOME=$scratch/home
[ -n "$VERTICES" ] && [ -n "$TRIANGLES" ] && [ -n "$FRONT_TRIANGLES" ] || fail "text_to_mesh printed no counts: $(cat "$scratch/stats")"

# The editor of Godot 3.2 imports and then does not end by itself: it is ended when both imports are there.
godot3-server --path "$project" --editor --quit >"$scratch/import" 2>&1 &
editor=$!
for _ in $(seq 240); do
    [ "$(find "$project/.import" -name '*.md5' 2>/dev/null | grep -c .)" -lt 2 ] || break
    kill -0 $editor 2>/dev/null || break
    sleep 0.5
done
kill -KILL $editor 2>/dev/null
wait $editor 2>/dev/null
[ "$(find "$project/.import" -name '*.md5' | grep -c .)" = 2 ] || fail "Godot has not imported the files: $(cat "$scratch/import")"

godot3-server --path "$project" --script check.gd >"$scratch/words" 2>&1 || fail "Godot has failed"
cat "$scratch/words"
grep -q '^WRONG in all: 0$' "$scratch/words" || fail "Godot finds something wrong"
[ "$failures" = 0 ]
