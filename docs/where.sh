#!/bin/sh
# where.sh - prints where.md; runs from the top of the sources.
find model formats methods simulate studies charts reports api serve cli tables \
    \( -name '*.[ch]' -o -name '*.csv' \) | LC_ALL=C sort |
    xargs ${AWK:-awk} -f docs/where.awk docs/SOURCES.md
