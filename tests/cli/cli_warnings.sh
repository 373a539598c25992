#!/bin/sh
# Valid but doubtful input: a result and a warning, or an error with --strict.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

cat >"$scratch/loss.xml" <<'END'
<room version="1" name="Room">
  <plan width="4.2" depth="5" height="2.7"/>
  <window name="W1" wall="south" left="1" sill="0.9" width="2" height="1.5" maintenance="0.1"/>
</room>
END
warning="$scratch/loss.xml:3: warning: W1: maintenance is the share of light that passes through the dirt; 0.1 looks like the loss (maintenance would be 0.9)"

# warns WORDS: a result, and only this warning.
warns() {
    run "$@"
    [ $status -eq 0 ] && [ -s "$scratch/out" ] && [ "$(cat "$scratch/err")" = "$warning" ] || told
}

check "df warns beside its result" warns df -m exact+bre "$scratch/loss.xml"
check "so does assess" warns assess --by-hand "$scratch/loss.xml"
check "and size" warns size -t 0.2% --by-hand "$scratch/loss.xml"
for command in df assess "size -t 0.2%"; do
    # shellcheck disable=SC2086
    run $command --format json --by-hand "$scratch/loss.xml" || :
    [ "$command" != df ] || run df --format json "$scratch/loss.xml"
    check "JSON of $command has the warning" grep -q '"text": "W1: maintenance' "$scratch/out"
    check "and its line" grep -q '"line": 3' "$scratch/out"
done
check "with --strict it is an error" refuses 1 "loss.xml:3: W1: maintenance is the share" \
    df --strict "$scratch/loss.xml"
check "and no warning" nothing "$(grep warning: "$scratch/err")"
check "a value that is set has no longer a warning" \
    gives df --strict --set window.W1.maintenance=0.9 "$scratch/loss.xml"
check "JSON without warnings has no list of them" \
    nothing "$("$pepperpot" df -f json "$examples/office.xml" | grep warnings)"

# A warning that applies to two rooms is printed once.
cat >"$scratch/two.xml" <<'END'
<building version="1" name="House"><site latitude="-0.1" longitude="51.5" country="GB"/>
<room name="A"><plan width="4.2" depth="5" height="2.7"/>
<window wall="south" left="1" sill="0.9" width="2" height="1.5"/></room>
<room name="B"><plan width="4.2" depth="5" height="2.7"/>
<window wall="south" left="1" sill="0.9" width="2" height="1.5"/></room></building>
END
run df "$scratch/two.xml"
check "a warning about the site is said once" test "$(grep -c swapped "$scratch/err")" -eq 1
check "and standard error has nothing else" test "$(wc -l <"$scratch/err")" -eq 1
for example in "$examples"/*.xml "$examples"/*/*.xml; do
    grep -qE '<(room|building)' "$example" || continue # a pane's data
    check "$(basename "$example") has no warning" gives df --strict --no-bands -m exact+split-flux "$example"
done

tap_done
