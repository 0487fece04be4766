# SPDX-License-Identifier: MIT
#
# three.js in Chromium, drawn by SwiftShader, loads a text's GLB: counts, materials, closedness, and the same picture whether
# back faces are culled or not.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
browser=
for name in chromium chromium-browser google-chrome; do
    [ -n "$browser" ] || browser=$(command -v $name) || true
done
[ -n "$browser" ] || skip "Chromium is not installed"
command -v node >/dev/null 2>&1 || skip "node is not installed"
[ -d "$NODE_PATH/three" ] || skip "the npm package three is not installed"
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
[ -e "$font" ] || skip "DejaVu Sans is not installed"

site=$scratch/site
mkdir -p "$site" "$scratch/home"
ln -s "$NODE_PATH/three" "$site/three"
cp "$here/three.html" "$site/index.html"
for name in text instances; do
    option=
    [ $name = text ] || option=--instances
    # shellcheck disable=SC2086  # a word or none
    "$TYPEMESH_TEXT_TO_MESH" --font "$font" --output "$site/$name.glb" $option --stats -- 'Lå&g' >"$scratch/stats" ||
        fail "text_to_mesh failed"
done
triangles=$(sed -nE 's/.*"vertices":[0-9]+,"triangles":([0-9]+).*/\1/p' "$scratch/stats")
front=$(sed -nE 's/.*"front":\{"triangles":([0-9]+).*/\1/p' "$scratch/stats")
[ -n "$triangles" ] && [ -n "$front" ] || fail "text_to_mesh printed no counts: $(cat "$scratch/stats")"

node "$here/three_serve.js" "$site" >"$scratch/port" &
# shellcheck disable=SC2064  # this process
trap "kill $! 2>/dev/null; rm -rf '$scratch'" EXIT
for _ in $(seq 40); do
    [ ! -s "$scratch/port" ] || break
    sleep 0.25
done
HOME=$scratch/home timeout 120 "$browser" --headless=new --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader \
    --user-data-dir="$scratch/profile" --virtual-time-budget=60000 --dump-dom \
    "http://127.0.0.1:$(cat "$scratch/port")/index.html?triangles=$triangles&front=$front" >"$scratch/page" 2>"$scratch/chromium"
sed -n '/<pre/,/<\/pre>/p' "$scratch/page" | sed 's/<[^>]*>//g'
if [ -n "${TYPEMESH_KEEP_PICTURES:-}" ]; then
    sed -nE 's/.*src="data:image\/png;base64,([^"]+)".*/\1/p' "$scratch/page" | base64 -d >"$TYPEMESH_KEEP_PICTURES/three.png"
fi
grep -q 'WRONG in all: 0$' "$scratch/page" || fail "three.js finds something wrong: $(tail -n 5 "$scratch/chromium")"
[ "$failures" = 0 ]
