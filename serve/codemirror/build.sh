#!/bin/sh
# build.sh - bundles CodeMirror for the text tab into serve/page/codemirror.js, which is checked in:
# nobody needs npm to build pepperpot. Run it when package.json names other versions.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp "$here/package.json" "$here/editor.js" "$scratch"
cd "$scratch"
npm install --silent --no-audit --no-fund
{
    echo "/* CodeMirror 6 (https://codemirror.net), MIT licence: see serve/codemirror/LICENSE.txt."
    echo " * Made by serve/codemirror/build.sh; do not edit. */"
    # Short lines, since some tools cannot read very long ones.
    ./node_modules/.bin/esbuild editor.js --bundle --format=esm --minify --line-limit=400 \
        --charset=ascii --legal-comments=none
} >"$here/../page/codemirror.js"
{
    for package in codemirror @codemirror/state @lezer/common @marijn/find-cluster-break crelt \
        style-mod w3c-keyname; do
        echo "== $package"
        cat "node_modules/$package/LICENSE"*
        echo
    done
} >"$here/LICENSE.txt"
