# SPDX-License-Identifier: MIT
#
# The package's own tests, from the tree and as npm packs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
package=$root/examples/web/package
size=$(wc -c <"$package/typemesh.wasm")
[ "$size" -lt 1460000 ] || fail "typemesh.wasm has $size bytes, which are more than 1.46 MB"
(cd "$package" && node --test test/) || fail "the package's tests have failed"
command -v npm >/dev/null 2>&1 || skip "npm is not installed"
packed=$(mktemp -d)
trap 'rm -rf "$packed"' EXIT
(cd "$package" && npm pack --silent --pack-destination "$packed") || fail "npm pack has failed"
tar -xzf "$packed"/typemesh-*.tgz -C "$packed"
for file in typemesh.js typemesh.d.ts typemesh.wasm README.md package.json LICENSE; do
    [ -e "$packed/package/$file" ] || fail "the package has no $file"
done
mkdir -p "$packed/app/node_modules"
mv "$packed/package" "$packed/app/node_modules/typemesh"
(cd "$packed/app" && node --input-type=module -e '
import load from "typemesh";
const typemesh = await load();
if (!/^[0-9]+[.][0-9]+[.][0-9]+$/.test(typemesh.version)) process.exit(1);
') || fail "the packed module cannot be loaded"
