#!/bin/sh
# bench_page.sh - latency of the drawing board in headless Chromium (bench_page.mjs). From the build's
# folder: PUPPETEER_FOLDER=FOLDER srcdir=.. sh ../bench/bench_page.sh
. "$srcdir/tests/lib/tap.sh" >/dev/null
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/served.sh"
modules=${PUPPETEER_FOLDER:-$PWD/npm}/node_modules
CHROMIUM=$(command -v chromium || command -v chromium-browser)
PUPPETEER=$(ls "$modules"/puppeteer-core/lib/esm/puppeteer/puppeteer-core.js \
    "$modules"/puppeteer-core/lib/puppeteer/puppeteer-core.js 2>/dev/null | head -n 1)
export CHROMIUM PUPPETEER
can_serve || { echo "$why_not"; exit 1; }
[ -n "$CHROMIUM" ] && [ -n "$PUPPETEER" ] || { echo "there is no chromium or no puppeteer-core"; exit 1; }
serve
node "$srcdir/bench/bench_page.mjs" "$address/"
