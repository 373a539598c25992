#!/bin/sh
# The drawing board in Chromium, if node, puppeteer-core and Chromium are installed: in
# PUPPETEER_FOLDER/node_modules, or in npm/ of the build, by
#    npm install --prefix npm puppeteer-core axe-core
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/served.sh"

modules=${PUPPETEER_FOLDER:-$PWD/npm}/node_modules
CHROMIUM=$(command -v chromium || command -v chromium-browser)
PUPPETEER=$(ls "$modules"/puppeteer-core/lib/esm/puppeteer/puppeteer-core.js \
    "$modules"/puppeteer-core/lib/puppeteer/puppeteer-core.js 2>/dev/null | head -n 1)
AXE=$(ls "$modules/axe-core/axe.min.js" 2>/dev/null)
export CHROMIUM PUPPETEER AXE
why_page=
command -v node >/dev/null || why_page="there is no node"
[ -n "$CHROMIUM" ] || why_page="there is no chromium"
[ -n "$PUPPETEER" ] || why_page="there is no puppeteer-core in $modules"
can_serve || why_page=$why_not
if [ -n "$why_page" ]; then
    skip "the page" "$why_page"
    tap_done
    exit
fi
awk -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/year.epw"
serve "$deep"
node "$srcdir/tests/serve/page_test.mjs" "$(cat "$scratch/address")" "$deep" "$scratch/year.epw" 2>&1
