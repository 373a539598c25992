#!/bin/sh
# build_site.sh SOURCES OUT VERSION BUILDER ... - the manual by Sphinx: html and man (a page for
# each command), latexpdf; check: dead links and headings that do not exist are errors.
set -eu
sources=$1
out=$2
version=$3
shift 3
if [ -z "${SPHINX_BUILD-}" ]; then
    echo "make docs needs Sphinx, MyST and Furo, then configure again. On Debian:" >&2
    echo "    apt-get install python3-sphinx python3-myst-parser furo" >&2
    exit 1
fi

# Sphinx reads one folder: the pages, where.md, and the two pages that lie above them. Their
# links to examples and tables lead from there as they do in the sources.
rm -rf "$out/source"
mkdir -p "$out/source/docs"
for folder in commands cookbook elements gallery lesson methods tutorial; do
    cp -R "$sources/docs/$folder" "$out/source/docs"
done
cp "$sources"/docs/*.md "$sources/docs/conf.py" "$sources/docs/site.css" "$sources/docs/room.rng" \
    "$sources/docs/openapi.json" "$out/source/docs"
cp -R "$sources/examples" "$sources/tables" "$out/source"
chmod -R u+w "$out/source"
for page in ARCHITECTURE.md CONTRIBUTING.md; do
    sed 's|](docs/|](|g' "$sources/$page" >"$out/source/docs/$page"
done
stage=$(cd "$out/source/docs" && pwd)
(cd "$sources" && sh docs/where.sh) >"$stage/where.md"
PEPPERPOT_VERSION=$version
export PEPPERPOT_VERSION

# mend_furo HTML: Debian's Furo 2022.12 has its script as an unbundled module, no dark colours by the
# reader's preference, and asks a server for normalize.css. Others pass through unchanged.
mend_furo() {
    script=$1/_static/scripts style=$1/_static/styles/furo.css
    if grep -q '^import Gumshoe' "$script/furo.js"; then
        sed 's/^export default.*//' "$script/gumshoe-patched.js" >"$script/bundled"
        sed '/^import Gumshoe/d' "$script/furo.js" >>"$script/bundled"
        mv "$script/bundled" "$script/furo.js"
    fi
    if ! grep -q prefers-color-scheme "$style"; then
        ${AWK:-awk} '
            /^ *body\[data-theme="dark"\] \{/ { inside = 1; sub(/\[.*\]/, ":not([data-theme=\"light\"])") }
            inside { dark = dark $0 "\n" }
            inside && /\}/ { exit }
            END { printf "@media screen and (prefers-color-scheme: dark) {\n%s}\n", dark }' \
            "$style" >"$style.dark"
        {
            cat "$style.dark"
            echo 'body { margin: 0; } code, kbd, pre { font-size: 1em; } img { border-style: none; }'
        } >>"$style"
        rm "$style.dark"
    fi
    sed '/^@import url(\/javascript/d' "$style" >"$style.tmp" && mv "$style.tmp" "$style"
}

for builder; do
    case $builder in
    check)
        "$SPHINX_BUILD" -q -n -W --keep-going -b html -d "$out/trees-check" \
            "$out/source/docs" "$out/check"
        ;;
    latexpdf) "$SPHINX_BUILD" -M latexpdf "$out/source/docs" "$out/pdf" ;;
    *)
        "$SPHINX_BUILD" -q -b "$builder" -d "$out/trees" "$out/source/docs" "$out/$builder"
        [ "$builder" != html ] || mend_furo "$out/html"
        echo "$out/$builder"
        ;;
    esac
done
rm -f "$out/html/.buildinfo"
