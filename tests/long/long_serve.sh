#!/bin/sh
# The server under load: many clients, invalid and aborted requests, and slow connections, where node
# is installed. LOAD_REQUESTS sets the requests of each of the 64 clients.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/served.sh"

why_load=
command -v node >/dev/null || why_load="there is no node"
can_serve || why_load=$why_not
if [ -n "$why_load" ]; then
    skip "the server under load" "$why_load"
    tap_done
    exit
fi
serve
node "$srcdir/tests/serve/load_test.mjs" "${address##*:}" "$deep" "${LOAD_REQUESTS:-200}" "$server" 2>&1
