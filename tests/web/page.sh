# SPDX-License-Identifier: MIT
#
# The page in headless Chromium: page.mjs does what a user would. Its pictures are beside it, and written anew with
# TYPEMESH_RENEW_PICTURES=yes; figures go to build/web/figures.txt.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
node "$here/fonts.mjs" "$root/examples/web/page/fonts.js" || fail "fonts.mjs has failed"
for browser in chromium chromium-browser google-chrome ''; do ! command -v "$browser" >/dev/null 2>&1 || break; done
[ -n "$browser" ] || skip "Chromium is not installed"
[ -d "${NODE_PATH:-}/puppeteer-core" ] || skip "npm's puppeteer-core is not there"
"$root/examples/web/run.sh" --build || fail "the page could not be built"
node "$here/page.mjs" "$root/build/web/site" "$(command -v "$browser")" "$here/pictures" "${TYPEMESH_RENEW_PICTURES:-no}" || fail "page.mjs has failed"

# What arrives before the first letter. Without brotli files are larger.
command -v brotli >/dev/null 2>&1 && command -v esbuild >/dev/null 2>&1 || exit 0
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
python3 "$root/examples/web/serve.py" "$root/build/web/site" "$port" &
server=$!
trap 'kill "$server"' EXIT
node "$here/arrival.mjs" "$(command -v "$browser")" "http://127.0.0.1:$port/" >"$root/build/web/arrival.txt" || fail "$(cat "$root/build/web/arrival.txt")"
tee -a "$root/build/web/figures.txt" <"$root/build/web/arrival.txt"
