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
node "$here/page.mjs" "$root/build/web/site" "$(command -v "$browser")" "$here/pictures" "${TYPEMESH_RENEW_PICTURES:-no}"
