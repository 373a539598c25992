#!/bin/sh
# bench_page.sh - latency of the drawing board in headless Chromium (bench_page.mjs). From the build's
# folder: PUPPETEER_FOLDER=FOLDER srcdir=.. sh ../bench/bench_page.sh
# Without Chromium, node or puppeteer-core: prints what is missing, exit status 77.
. "$srcdir/tests/lib/tap.sh" >/dev/null
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/served.sh"
modules=${PUPPETEER_FOLDER:-$PWD/npm}/node_modules
CHROMIUM=$(command -v chromium || command -v chromium-browser)
PUPPETEER=$(ls "$modules"/puppeteer-core/lib/esm/puppeteer/puppeteer-core.js \
    "$modules"/puppeteer-core/lib/puppeteer/puppeteer-core.js 2>/dev/null | head -n 1)
export CHROMIUM PUPPETEER
why=
command -v node >/dev/null || why="there is no node"
[ -n "$CHROMIUM" ] || why="there is no chromium"
[ -n "$PUPPETEER" ] || why="there is no puppeteer-core in $modules"
can_serve || why=$why_not
[ -z "$why" ] || { echo "$why"; exit 77; }
serve
node "$srcdir/bench/bench_page.mjs" "$address/"
