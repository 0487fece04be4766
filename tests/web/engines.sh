# SPDX-License-Identifier: MIT
#
# The package in other people's engines: React-three-fiber and Babylon.js draw its meshes in headless Chromium, and three.js plays
# a morph that text_to_mesh has written. The examples agree with the package's types.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
for browser in chromium chromium-browser google-chrome ''; do ! command -v "$browser" >/dev/null 2>&1 || break; done
[ -n "$browser" ] || skip "Chromium is not installed"
command -v esbuild >/dev/null 2>&1 || skip "esbuild is not installed"
for package in puppeteer-core three react react-dom @react-three/fiber @babylonjs/core; do
    [ -d "${NODE_PATH:-}/$package" ] || skip "npm's $package is not there"
done
font=/usr/share/fonts/truetype/inter-vf/Inter-roman.var.ttf
[ -e "$font" ] || font=/usr/share/fonts/truetype/inter-vf/InterVariable.ttf
[ -e "$font" ] || skip "Inter with its weights is not installed"
[ -x "${TYPEMESH_TEXT_TO_MESH:-}" ] || fail "text_to_mesh is not built"

site=$root/build/web/engines
rm -rf "$site" && mkdir -p "$site"
for example in react_three_fiber.tsx babylon.ts three_morph.js; do
    folder=$site/${example%.*}
    mkdir "$folder"
    esbuild "$root/examples/web/engines/$example" --bundle --minify --format=esm --target=es2022 --jsx=automatic \
        '--define:process.env.NODE_ENV="production"' --outfile="$folder/main.js" --log-level=error \
        "--alias:typemesh=$root/examples/web/package/typemesh.js" '--external:node:*' || fail "$example cannot be bundled"
    cp "$root/examples/web/package/typemesh.wasm" "$folder/"
    cp "$font" "$folder/font.ttf"
done
"$TYPEMESH_TEXT_TO_MESH" 'breathing!\nbreathing!\nbreathing!\nbreathing!' --font "$font" --morph wght=100..900 --depth 0.2 \
    -o "$site/three_morph/text.glb" || fail "text_to_mesh has written no morph"
node "$here/engines.mjs" "$site" "$(command -v "$browser")" "$root/examples/web/package/typemesh.js" || fail "engines.mjs has failed"

# Types, where npm's typescript is there.
tsc=$NODE_PATH/typescript/bin/tsc
[ -e "$tsc" ] || exit 0
cat >"$site/tsconfig.json" <<END
{"compilerOptions": {"strict": true, "noUncheckedIndexedAccess": true, "noEmit": true, "skipLibCheck": true, "target": "es2022", "module": "esnext",
    "moduleResolution": "bundler", "jsx": "react-jsx", "lib": ["es2022", "dom"], "types": [],
    "paths": {"typemesh": ["$root/examples/web/package/typemesh.d.ts"], "*": ["$NODE_PATH/@types/*", "$NODE_PATH/*"]}},
 "files": ["$root/examples/web/engines/react_three_fiber.tsx", "$root/examples/web/engines/babylon.ts"]}
END
node "$tsc" -p "$site/tsconfig.json" || fail "the examples do not agree with typemesh.d.ts"
