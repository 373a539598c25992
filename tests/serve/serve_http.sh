#!/bin/sh
# The server of the drawing board: its endpoints return the same results as the command, it rejects
# invalid requests, stops on a signal, and openapi.json describes it.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"
. "$srcdir/tests/lib/served.sh"

if ! can_serve; then
    skip "the server" "$why_not"
    tap_done
    exit
fi
serve "$deep" --jobs "$scratch"

# ---- figures ----

asks "$deep" '{}'
check "df answers" answers 200 df
same_figures() {
    "$pepperpot" df --format json --no-bands "$deep" >"$scratch/wanted" &&
        figures "$scratch/wanted" >"$scratch/a" && figures "$scratch/answer" >"$scratch/b" &&
        [ -s "$scratch/a" ] && cmp "$scratch/a" "$scratch/b"
}
# Figures of an answer, except the grid over the plane, which the library omits.
figures() {
    sed '/^  "\(grid\|model\)"/,$d' "$1" | grep -o '"[a-z+-]*": { "value": [-0-9.e+]*\|"[xyz]": [-0-9.e+]*'
}
check "its figures are the command's" same_figures
asks "$deep" '{"methods":"exact+bre","points":[[1.5,3]],"explain":true}'
check "one point is explained" answers 200 df
check "with the steps of its sum" holds '"symbol":'
asks "$deep" '{"tolerance":0.05}'
check "plan answers" answers 200 plan
check "with contours" holds '"format": "pepperpot-plan-1"'
check "and the geometry" holds '"format": "pepperpot-scene-1"'
check "and the average" holds '"average": [0-9]'
asks "$deep" '{"tolerance":0.1,"average":false}'
check "without the average the plan answers, too" answers 200 plan
check "and has none" holds '"average": null'
for command in assess size availability chart/section report; do
    case $command in
    size) asks "$deep" '{"target":"2%","by-hand":true}' ;;
    report | assess) asks "$deep" '{"by-hand":true}' ;;
    *) asks "$deep" '{}' ;;
    esac
    check "$command answers" answers 200 $command
done
check "the report is a page" holds '<!DOCTYPE html>'

# ---- streams ----

asks "$deep" '{"error":20}'
check "trace answers" answers 200 trace
check "with estimates" holds 'event: estimate'
check "and a result at its end" holds 'event: result'
asks "$deep" '{"size":"64x48"}'
check "render answers" answers 200 render
check "with four pictures, coarse first" test "$(grep -c '^event: picture' "$scratch/answer")" -eq 4

# CPU time of the server in clock ticks; it does not increase while no task is running.
ticks() { awk '{ print $14 + $15 }' "/proc/$server/stat"; }
# stops_work: from 0.2 s after the client has disconnected, half a second uses less than a tenth of
# CPU time.
stops_work() {
    asks "$deep" '{"error":0.1}'
    curl -s -m 1 -H "$json" -d @"$scratch/asked" "$address/api/trace" >"$scratch/answer"
    sleep 0.2
    before=$(ticks)
    sleep 0.5
    [ $(($(ticks) - before)) -le 5 ]
}
check "work stops when the client has gone" stops_work

# A room whose daylight factors take about a second, and its criteria several.
awk 'BEGIN {
    printf "<room version=\"1\"><sky type=\"iso-12\" sun-altitude=\"40\" sun-bearing=\"180\"/>"
    printf "<plan width=\"11\" depth=\"8\" height=\"3\"/>"
    for (i = 0; i < 25; i++)
        printf "<window wall=\"south\" left=\"%.2f\" sill=\"0.9\" width=\"0.3\" height=\"1.2\"/>", i * 0.4 + 0.05
    for (i = 0; i < 80; i++)
        printf "<block x=\"%d\" y=\"%d\" width=\"6\" depth=\"5\" height=\"%d\" rotate=\"%d\"/>", i * 37 % 120 - 60,
            -70 + i * 23 % 58, 5 + i % 20, i % 80
    print "<grid spacing=\"0.4\"/></room>"
}' >"$scratch/large.xml"
asks "$scratch/large.xml" '{}'
# stops_hand_work COMMAND: as stops_work, from 0.1 s after the client has disconnected.
stops_hand_work() {
    curl -s -m 0.4 -H "$json" -d @"$scratch/asked" "$address/api/$1" >"$scratch/answer"
    sleep 0.1
    before=$(ticks)
    sleep 0.5
    [ $(($(ticks) - before)) -le 5 ] && [ ! -s "$scratch/answer" ]
}
for command in df plan; do
    check "so does $command by hand methods" stops_hand_work $command
done

# ---- mistakes ----

printf '<room version="1"><plan width="3" depth="x" height="3"/>\n<widow/></room>' >"$scratch/wrong.xml"
asks "$scratch/wrong.xml" '{}'
check "check answers of a wrong room, too" answers 200 check
check "with the place of the attribute" holds '"line":1,"column":35,"end-line":1,"end-column":44'
check "and of the element" holds '"line":2,"column":1,"end-line":2,"end-column":9'
check "a wrong room is no room for df" answers 422 df
check "and df says where" holds '"mistakes":\[{"line":1'
printf '<room version="1" name="<script>"><plan width="3" depth="4" height="3"/></room>' >"$scratch/odd.xml"
sed -i 's/<script>/\&lt;script\&gt;/' "$scratch/odd.xml"
asks "$scratch/odd.xml" '{}'
check "a room called <script> is a room" answers 200 df
check "with its name as it is" holds '"room": "<script>"'
asks "$deep" '{"nonsense":1}'
check "an unknown option is refused" answers 400 df
check "of a command, too" answers 400 assess
check "an unknown chart is refused" answers 400 chart/nonsense
asks "$deep" '{"write":"/tmp/x"}'
check "an option that names a file is refused" answers 400 size

# ---- hostile requests ----

printf '<!DOCTYPE r [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]><room version="1">&b;</room>' >"$scratch/bomb.xml"
asks "$scratch/bomb.xml" '{}'
check "entities are refused" answers 422 df
printf '<room version="1"><plan width="3" depth="4" height="3"/><mesh file="/etc/passwd"/></room>' >"$scratch/mesh.xml"
asks "$scratch/mesh.xml" '{}'
for command in df plan check assess report trace; do
    ask $command
    check "$command reads no file that a room names" holds 'the room was not read from a file'
done
printf '<room version="1" within="/etc/passwd"><plan width="3" depth="4" height="3"/></room>' >"$scratch/within.xml"
asks "$scratch/within.xml" '{}'
ask df
check "nor the model that a room is nested in" holds 'the room was not read from a file'
asks "$deep" '{"sky":"picture,/etc/passwd"}'
for command in df plan trace chart/section availability; do
    check "$command takes no photograph as a sky" answers 400 $command
done
printf '<room version="1"><sky type="picture" file="/etc/passwd"/><plan width="3" depth="4" height="3"/></room>' \
    >"$scratch/photo.xml"
asks "$scratch/photo.xml" '{}'
check "nor from the room" answers 422 df
printf '<room version="1"><plan width="300" depth="400" height="3"/><grid spacing="0.3"/></room>' >"$scratch/points.xml"
asks "$scratch/points.xml" '{}'
check "too many points are refused" answers 422 df
head -c 104857600 /dev/zero >"$scratch/large"
check "a body of 100 MiB is refused" test "$(curl -s -o "$scratch/answer" -w '%{http_code}' -H "$json" \
    -H 'Expect:' --data-binary @"$scratch/large" "$address/api/df")" -eq 413
rm -f "$scratch/large"
check "a foreign origin is refused" status_with 403 -H 'Origin: http://evil.example'
check "a foreign host is refused" status_with 421 -H 'Host: evil.example'
check "a form is refused" status_with 415 -H 'Content-Type: application/x-www-form-urlencoded'
check "what is no JSON is refused" test "$(curl -s -o "$scratch/answer" -w '%{http_code}' -H "$json" \
    -d '{' "$address/api/df")" -eq 400
check "deep JSON is refused" test "$(printf '%s' '{"room":"","options":{"a":[[[[[[[[[[1]]]]]]]]]]}}' |
    curl -s -o "$scratch/answer" -w '%{http_code}' -H "$json" -d @- "$address/api/df")" -eq 400
for path in '/../etc/passwd' '/..%2f..%2fetc/passwd' '/serve/page/index.html' '/api/nothing'; do
    check "$path is not there" test "$(curl -s --path-as-is -o "$scratch/answer" -w '%{http_code}' \
        "$address$path")" -eq 404
done
check "a page file takes no POST" test "$(curl -s -o "$scratch/answer" -w '%{http_code}' -X POST "$address/")" -eq 405
check "df takes no GET" test "$(curl -s -o "$scratch/answer" -w '%{http_code}' "$address/api/df")" -eq 405
check "the room of the command line is not for everybody" test "$(curl -s -o "$scratch/answer" \
    -w '%{http_code}' "$address/api/room")" -eq 401
check "but for who has the address" test "$(curl -s -o "$scratch/answer" -w '%{http_code}' \
    -H "Authorization: Bearer $key" "$address/api/room")" -eq 200
policy() {
    curl -s -D - -o /dev/null "$address/" | tr -d '\r' >"$scratch/answer"
    holds "^Content-Security-Policy: default-src 'none'" && ! grep -q 'unsafe' "$scratch/answer"
}
check "the page's content policy has nothing unsafe" policy

# ---- weather and jobs ----

weather=$srcdir/tests/formats/epw/four-days.epw
keeps_weather() {
    curl -s -H 'Content-Type: application/octet-stream' --data-binary @"$weather" \
        "$address/api/weather" >"$scratch/answer"
    holds "$(sha256sum "$weather" | cut -d ' ' -f 1)"
}
check "a weather file is named by its hash" keeps_weather
asks "$deep" '{}'
check "annual says that it needs a weather file" answers 400 annual
hash=$(sha256sum "$weather" | cut -d ' ' -f 1)
asks "$deep" "{\"weather\":\"$hash\",\"lighting\":[\"dimmed,power=8\",\"manual\"]}"
check "annual accepts controls of light, and needs a whole year" answers 422 annual
check "the year is what is missing" holds 8760
asks "$deep" "{\"weather\":\"$hash\",\"lighting\":\"dimmed,steps=2\"}"
check "a wrong control is refused" answers 400 annual
check "with the keys that it has" holds residual-light
asks "$deep" "{\"weather\":\"$hash\",\"lighting\":[null]}"
check "nor is null a control" answers 400 annual
asks "$deep" "{\"weather\":\"$hash\",\"methods\":[\"doe2\",\"df-global\"],\"df\":\"iso-1\"}"
check "annual accepts hand methods, and needs a whole year" answers 422 annual
asks "$deep" "{\"weather\":\"$hash\",\"methods\":\"doe3\"}"
check "a wrong hand method is refused" answers 400 annual
check "with the nearest one" holds doe2
awk -f "$srcdir/tests/lib/clear_year.awk" >"$scratch/year.epw"
weather=$scratch/year.epw
check "a whole year is kept" keeps_weather
hash=$(sha256sum "$weather" | cut -d ' ' -f 1)
asks "$deep" "{\"weather\":\"$hash\",\"points\":[[1.5,2]],\"error\":30}"
check "annual streams" answers 200 annual
annual_stream() {
    [ "$(grep -c '^event: estimate' "$scratch/answer")" -eq 3 ] && grep -q '^event: result' "$scratch/answer" &&
        grep -q '"progress":1.0' "$scratch/answer" && [ "$(grep -c '"average_lux"' "$scratch/answer")" -eq 3 ]
}
check "coarse first, with all hours, and the result at its end" annual_stream
same_annual() {
    sed -n '/^event: result/,$s/^data: //p' "$scratch/answer" | grep -o '"year-klxh":{"value":[0-9.]*' | head -n 1 >"$scratch/a"
    "$pepperpot" annual -q -w "$weather" --points 1.5,2 --samples 128 --format json "$deep" |
        grep -o '"year-klxh": { "value": [0-9.]*' | head -n 1 | tr -d ' ' >"$scratch/b"
    [ -s "$scratch/a" ] && cmp "$scratch/a" "$scratch/b"
}
check "which is the command's" same_annual
# The command runs as a child; 0.2 s after the client has gone there is none.
children() { cat /proc/"$server"/task/*/children 2>/dev/null; }
stops_year() {
    asks "$deep" "{\"weather\":\"$hash\",\"error\":0.1}"
    curl -s -H "$json" -d @"$scratch/asked" "$address/api/annual" >"$scratch/answer" &
    tries=100
    while [ $((tries -= 1)) -gt 0 ] && [ -z "$(children)" ]; do sleep 0.05; done
    begun=$(children)
    kill $!
    sleep 0.2
    [ -n "$begun" ] && [ -z "$(children)" ]
}
check "the year stops when the client has gone" stops_year
asks "$examples/building.xml" "{\"weather\":\"$hash\",\"samples\":1,\"points\":[[1,1]]}"
check "of a building, annual streams the first room" answers 200 annual
check "by its name" holds '"annual":{.*"room":"Living room"'
asks "$deep" "{\"weather\":\"$hash\",\"samples\":3}"
check "a number of paths that annual does not accept is refused" answers 400 annual
asks "$deep" "{\"weather\":\"$hash\",\"samples\":16,\"points\":[[1.5,2]],\"format\":\"json\"}"
check "with a format, annual answers once" answers 200 annual
check "with its output" holds '"format": "pepperpot-annual-1"'
asks "$deep" '{"points":[null]}'
check "nor null a point" answers 400 df
asks "$deep" "{\"weather\":\"$(printf '%064d' 0)\"}"
check "an unknown hash is refused" answers 404 availability
finishes_job() {
    printf '{"command":"df","room":%s}' "$(json_text "$deep")" |
        curl -s -H "$json" -d @- "$address/api/jobs" >"$scratch/answer"
    job=$(sed -n 's/.*"job":"\([0-9a-f]*\)".*/\1/p' "$scratch/answer")
    tries=100
    while [ $((tries -= 1)) -gt 0 ] && [ ! -e "$scratch/$job.result" ]; do sleep 0.1; done
    sleep 0.2
    [ "$(curl -s -o "$scratch/answer" -w '%{http_code}' "$address/api/jobs/$job")" -eq 200 ] &&
        holds pepperpot-df-1
}
check "a job's result is fetched later" finishes_job
check "a job that is none is not there" test "$(curl -s -o "$scratch/answer" -w '%{http_code}' \
    "$address/api/jobs/0123456789abcdef0123456789abcde")" -eq 404

# ---- openapi.json ----

paths_of_code() {
    sed -n 's/.*JSON_POST("\([a-z]*\/*\)".*/post \/api\/\1/p; s/.*{"GET", "\([^"]*\)".*/get \1/p;
        s/.*{"POST", "\([^"]*\)".*/post \1/p' "$srcdir/serve/endpoint.c" | LC_ALL=C sort
}
paths_of_document() {
    awk '/^    "\/api/ { path = $1; gsub(/[":]/, "", path); sub(/\{[a-z]*\}/, "", path) }
        /^      "(get|post)"/ { method = $1; gsub(/[":]/, "", method); print method, path }' \
        "$srcdir/docs/openapi.json" | LC_ALL=C sort
}
same_paths() {
    paths_of_code >"$scratch/a"
    paths_of_document >"$scratch/b"
    [ -s "$scratch/a" ] && diff "$scratch/a" "$scratch/b"
}
check "openapi.json has the endpoints of the server" same_paths
statuses() {
    paths_of_document | while read -r method path; do
        case $path in */) path=${path}nothing ;; esac
        status=$(curl -s -m 5 -o /dev/null -w '%{http_code}' -X "$(echo "$method" | tr a-z A-Z)" "$address$path" -H "$json" -d '{}')
        [ "$method" = get ] && status=$(curl -s -o /dev/null -w '%{http_code}' "$address$path")
        case $status in 405 | 000) echo "$method $path: $status" ;; esac
    done
}
check "and the server answers each" nothing "$(statuses)"

# ---- the end ----

asks "$deep" '{"error":0.1}'
curl -s -H "$json" -d @"$scratch/asked" "$address/api/trace" >/dev/null &
asks "$scratch/large.xml" '{}'
curl -s -H "$json" -d @"$scratch/asked" -o "$scratch/answer" -w '%{http_code}' "$address/api/assess" >"$scratch/status" &
waiting=$!
sleep 0.5
began=$(date +%s%N)
kill -TERM "$server"
wait "$server"
ended=$?
took=$((($(date +%s%N) - began) / 1000000))
check "it ends with status 0 while it works" test $ended -eq 0
check "in less than 2 s ($took ms)" test $took -lt 2000
wait $waiting
check "and answers the request that it could not finish" test "$(cat "$scratch/status")" -eq 503
server=

serve --token-file "$srcdir/tests/serve/token.txt"
check "with a token, nobody else is answered" test "$(curl -s -o "$scratch/answer" -w '%{http_code}' \
    "$address/api/about")" -eq 401
check "who has it is" test "$(curl -s -o "$scratch/answer" -w '%{http_code}' \
    -H "Authorization: Bearer $(cat "$srcdir/tests/serve/token.txt")" "$address/api/about")" -eq 200
stop_serving
check "an open address needs a token" refuses 2 'expected --token-file' serve --listen 0.0.0.0
check "a short token is refused" refuses 1 'expected 16 or more' serve --token short
check "an address is a number" refuses 1 'is not an IP address' serve --listen there --token 0123456789abcdef
check "a port is one" refuses 2 'a port from 1' serve --port 70000
check "a file that is not there is refused" refuses 1 'nothing.xml' serve "$scratch/nothing.xml"
check "there is one file at most" refuses 2 'expected at most one' serve "$deep" "$deep"
tap_done
