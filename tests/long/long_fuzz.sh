#!/bin/sh
# Runs every libFuzzer target of make fuzz for a minute, from its seeds, without a finding.
. "$srcdir/tests/lib/tap.sh"

if ! command -v clang >/dev/null; then
    skip "no reader fails for any bytes" "there is no clang"
    tap_done
    exit
fi
seconds=${FUZZ_SECONDS:-60}
log=long-fuzz.log
check "the targets are built" sh -c "${MAKE:-make} -s fuzz >$log 2>&1 || { tail -n 5 $log; exit 1; }"

# minute COMMAND: runs a command printed by `make fuzz`; prints the end of its output if it fails.
minute() {
    # shellcheck disable=SC2086 # words
    sh -c "$(printf %s "$1" | sed "s/-max_total_time=[0-9]*/-max_total_time=$seconds/")" \
        >"$log.target" 2>&1 || {
        grep -m 3 'ERROR\|runtime error\|SUMMARY' "$log.target"
        return 1
    }
}
sed -n 's/^run it: //p' "$log" >"$log.targets"
while read -r target; do
    name=${target%% *}
    check "${name##*/}" minute "$target" </dev/null
done <"$log.targets"
check "there were targets" test -s "$log.targets"
rm -f "$log" "$log.target" "$log.targets"
tap_done
