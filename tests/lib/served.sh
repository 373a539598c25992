# served.sh - for tests of the server: starts it, sends requests with curl, and stops it at the
# end.
#
# To be sourced after cli.sh. $address is the address of the server, $server its process, $key the
# key under which the page gets the room; $scratch/answer is the last answer.

json='Content-Type: application/json'
server=

can_serve() {
    why_not=
    command -v curl >/dev/null || why_not="there is no curl"
    "$pepperpot" serve --listen 127.0.0.300 2>&1 | grep -q 'without libmicrohttpd' &&
        why_not="built without libmicrohttpd"
    [ -z "$why_not" ]
}

stop_serving() {
    [ -z "$server" ] || { kill "$server" && wait "$server"; } 2>/dev/null
    server=
}

# serve WORDS: starts the server.
serve() {
    stop_serving
    rm -f "$scratch/address"
    "$pepperpot" serve "$@" >"$scratch/address" 2>"$scratch/served.err" &
    server=$!
    trap 'stop_serving; rm -rf "$scratch"' EXIT
    serve_tries=200
    while [ $((serve_tries -= 1)) -gt 0 ] && [ ! -s "$scratch/address" ]; do sleep 0.05; done
    address=$(sed 's|/#.*||; s|/$||' "$scratch/address")
    key=$(sed -n 's/.*#key=//p' "$scratch/address")
}

# json_text FILE: the contents of the file as a JSON string.
json_text() {
    awk 'BEGIN { printf "\"" } { gsub(/\\/, "&&"); gsub(/"/, "\\\\&"); gsub(/\t/, "\\t"); printf "%s\\n", $0 }
        END { printf "\"" }' "$1"
}

# asks ROOM OPTIONS: writes the body of the following requests.
asks() {
    printf '{"room":%s,"options":%s}' "$(json_text "$1")" "$2" >"$scratch/asked"
}

ask() {
    curl -s -o "$scratch/answer" -w '%{http_code}' -H "$json" -d @"$scratch/asked" "$address/api/$1" \
        >"$scratch/status"
}

# answers STATUS ENDPOINT: the request returns this status.
answers() {
    ask "$2"
    [ "$(cat "$scratch/status")" = "$1" ] || {
        echo "status $(cat "$scratch/status")"
        head -c 400 "$scratch/answer"
        return 1
    }
}

# status_with STATUS WORDS: a df request with these arguments of curl returns this status.
status_with() {
    wanted=$1
    shift
    case "$*" in *Content-Type*) ;; *) set -- -H "$json" "$@" ;; esac
    given=$(curl -s -o "$scratch/answer" -w '%{http_code}' "$@" -d @"$scratch/asked" "$address/api/df")
    [ "$given" = "$wanted" ] || { echo "status $given"; return 1; }
}

# holds PATTERN: the last answer contains the pattern.
holds() {
    grep -q -- "$1" "$scratch/answer" || { head -c 400 "$scratch/answer"; return 1; }
}
