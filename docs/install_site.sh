#!/bin/sh
# install_site.sh SOURCES DOCDIR MANDIR - installs the site and the man pages of the commands,
# from `make docs` or from a tarball; without either there is nothing to do.
set -eu
for site in docs-site "$1/docs"; do
    [ -d "$site/html" ] || continue
    mkdir -p "$2" "$3"
    cp -R "$site/html" "$2"
    cp "$site"/man/pepperpot-*.1 "$3"
    exit 0
done
