#!/bin/sh
# size: the sizes that it finds, tested with df, and its messages if there is none.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

classroom=$examples/classroom.xml
obstructed=$examples/deep-office-obstructed.xml

# value METHOD OPTIONS FILE: the average, or the value of the only point, by df (%).
value() {
    method=$1
    shift
    "$pepperpot" df --methods "$method" --format csv "$@" | tr -d '\r' |
        awk -F, -v method="$method" '$(NF - 5) == "df" && $(NF - 4) == method { print $(NF - 3) }' |
        case " $* " in
        *" --points "*) head -n 1 ;;
        *) tail -n 1 ;;
        esac
}

# near TARGET SHARE VALUE: the value is within this share of the target, and not below it except
# for rounding.
near() {
    awk -v t="$1" -v s="$2" -v v="$3" \
        'BEGIN { exit !(v >= t * (1 - 1e-6) && v <= t * (1 + s)) }' || {
        echo "$3 for $1"
        return 1
    }
}

# reaches TARGET METHOD FILE OPTIONS: the room written by size reaches the target by df.
reaches() {
    target=$1
    method=$2
    file=$3
    shift 3
    rm -f "$scratch/sized.xml"
    gives size --by-hand --target "$target%" --by "$method" --write "$scratch/sized.xml" "$@" \
        "$file" || return 1
    near "$target" 0.005 "$(value "$method" "$scratch/sized.xml")"
}

check "a width by exact+bre" reaches 2 exact+bre "$deep"
check "shows the element as the file has it" \
    grep -q '<window wall="south" left="0.91.*" sill="0.8" width="1.17.*" height="1.5"' \
    "$scratch/out"
check "and nothing else changes in the file" test \
    "$(diff "$deep" "$scratch/sized.xml" | grep -c '^[<>]')" -eq 2
check "a larger one" reaches 4.5 exact+bre "$deep"
check "a head by brs-table+bre" reaches 3 brs-table+bre "$obstructed" --change head
check "a sill by average-df" reaches 1.8 average-df "$obstructed" --change sill
check "a height by exact+split-flux" \
    reaches 7.9 exact+split-flux "$classroom" --change height
check "one wall of a room lit from two" \
    reaches 5.5 exact+bre "$classroom" --wall north
check "leaves the other wall alone" test \
    "$(diff "$classroom" "$scratch/sized.xml" | grep -c '^>')" -eq 1
check "a rooflit room's slopes by split-flux" reaches 5 exact+split-flux \
    "$examples/workshop.xml" --wall light-1

gives size --by-hand --target 2% "$deep"
check "what it says of the room as it is, df says too" grep -q \
    "^  as it is  *$(printf '%.2f' "$(value exact+bre "$deep")") %\$" "$scratch/out"

# Counting methods: the result is not below the target, and one millimetre less is.
for method in waldram+bre pepper-pot+bre; do
    gives size -t 1.2 -b $method --points 1.5,3.1 --change head -w "$scratch/sized.xml" \
        "$deep"
    height=$(sed -n 's/.*height="\([0-9.]*\)"$/\1/p' "$scratch/sized.xml" | tail -n 1)
    less=$(awk "BEGIN { print $height - 0.001 }")
    sed "s/height=\"$height\"/height=\"$less\"/" "$scratch/sized.xml" >"$scratch/less.xml"
    check "$method: $height m reach it" near 1.2 1 \
        "$(value $method --points 1.5,3.1 "$scratch/sized.xml")"
    check "$method: $less m don't" \
        sh -c "! awk 'BEGIN { exit !($(value $method --points 1.5,3.1 \
            "$scratch/less.xml") >= 1.2) }'"
done

# Simulated, and simulated again with another seed: within three standard errors of the difference.
traced() {
    gives size -t "$1" -b traced --error 2% -w "$scratch/sized.xml" "$deep" || return 1
    "$pepperpot" df --simulate --seed 7 --error 0.5% --methods exact --format csv \
        "$scratch/sized.xml" | tr -d '\r' |
        awk -F, -v t="$1" '$3 == "average" && $10 == "df" && $11 == "traced" {
            off = $12 - t; e = 0.02 * t
            found = 1; bad = off * off > 9 * (e * e + $13 * $13) }
            END { exit !(found && !bad) }'
}
check "a width by the simulation, checked from another seed" traced 2
check "and a larger one" traced 4.5
check "a hand method's answer is checked by the simulation" \
    shows "simulated " size -t 2 --simulate --error 3% "$deep"
check "the same with any number of threads" same_by_threads "1 2" \
    size -t 2 -b traced --error 5% --format json "$deep"

check "what the wall has no space for is out of reach" \
    shows "gives only 4.73 %" size -t 6 "$deep"
check "in JSON too" shows '"reached": false' size -t 6 --format json "$deep"
check "then no file is written" refuses 1 "not reached" \
    size -t 6 -w "$scratch/none.xml" -o /dev/null "$deep"
check "none at all" test ! -e "$scratch/none.xml"
check "what the rest of the room has already" shows "exceeded even by the smallest size" \
    size -t 1 --wall north "$classroom"
check "a sill under the plane adds nothing to a point's direct light" \
    shows "this change has no effect" \
    size -t 9 --by exact --points 1.5,3 --change sill "$deep"
check "a number of windows" shows "3 windows instead of 2" \
    size -t 3 --change number "$examples/office.xml"
check "as lines of the file" grep -q "after W2, line" "$scratch/out"
check "of a building each room by itself" shows "Kitchen" size -t 2 \
    "$examples/building.xml"
check "only the room with that window" gives size -t 2 --window 23 \
    "$examples/building.xml"
check "and no other" nothing "$(grep -E 'Kitchen|Bedroom' "$scratch/out")"
sed '/^  <room name="Study">/,/^  <.room>/{/<window/,/>/d}' "$examples/building.xml" \
    >"$scratch/dark.xml"
check "a room without a window says so" shows "none: there is no window or rooflight" \
    size -t 2 "$scratch/dark.xml"
check "and the others are sized" grep -q "a width of" "$scratch/out"
check "in JSON it has a why" sh -c "'$pepperpot' size -t 2 -f json '$scratch/dark.xml' |
    grep -q '\"why\": \"none: there is no window'"
check "alone it is an error" refuses 1 "expected a window or rooflight of any size" \
    size -t 2 --room Study "$scratch/dark.xml"
sed '/<rooflight/,/>/d; /<window/,/>/d' "$examples/studio.xml" >"$scratch/corners.xml"
check "an opening given by its corners keeps its shape" refuses 1 "by their corners" \
    size -t 2 "$scratch/corners.xml"
check "by tracing" gives size -t 4.4 --by traced --error 5% "$deep"
check "the answer has a standard error" grep -Eq 'gives 4[.0-9]* % (±|\+-) 0[.]' \
    "$scratch/out"
check "standard input" sh -c "'$pepperpot' size -t 2 - <'$deep' | grep -q 'a width of'"
check "a simulated check of it" gives size -t 6 --simulate --error 5% "$deep"
check "no line is wider than 80 columns" nothing "$(too_wide)"

# 12.5 % of a floor of 3 m by 9 m with a height of 1.5 m: 2.25 m wide.
check "by a criterion" shows "a width of 2.25 m instead of 2.6 m gives 100.00 %" \
    size --by-hand --for glazing-ratio --write "$scratch/sized.xml" "$deep"
check "which the sized room meets" sh -c "
    '$pepperpot' assess --by-hand -c glazing-ratio '$scratch/sized.xml' | grep -qF '2 met'"
check "windows on a slope too" gives size --by-hand --for glazing-ratio --write "$scratch/sized.xml" \
    "$examples/workshop.xml"
check "which meets it" sh -c "
    '$pepperpot' assess --by-hand -c glazing-ratio '$scratch/sized.xml' | grep -qF '12.5 %'"
check "checked by tracing, and sized again until that agrees" shows '"holds": true' \
    size --for uk-annex:living-room --change height --error 3% -f json "$deep"
check "says the criterion" grep -qF '"criterion": "uk-annex:living-room"' "$scratch/out"
"$pepperpot" size -q --for uk-annex:living-room --change height --error 3% \
    --write "$scratch/sized.xml" "$deep" >/dev/null
check "so that assess finds it met" sh -c "
    '$pepperpot' assess -q -c uk-annex --error 3% -f csv '$scratch/sized.xml' |
    grep 'living room' | grep -q ',least,met,'"
check "on a grid of one's own, too" shows '"reached": true' \
    size --for uk-annex:living-room --change height --error 3% --spacing 0.5 -f json "$deep"
check "a grid is for a criterion" refuses 2 "expected --for as well" size -t 2 --spacing 0.5 "$deep"
check "a requirement that there is none of" shows 'available: \"minimum: 300 lx over 50 %\",' \
    size --by-hand --for en17037:least -f json "$deep"
check "traced throughout" shows "reach, simulated" \
    size --for uk-annex:kitchen --by traced --error 3% --spacing largest -q "$deep"
check "what compares is not sized by" shows "none: this criterion needs an existing state" \
    size --by-hand --for former-sky "$deep"
check "a criterion by its name" refuses 2 "there is no criterion" size --for en1737 "$deep"
check "or a target" refuses 2 "--target and --for cannot be combined" size --for average -t 2% "$deep"
check "it has figures of its own" refuses 2 "--by and --for cannot be combined" \
    size --for average --by exact+bre "$deep"
check "and points of its own" refuses 2 "--points and --for cannot be combined" \
    size --for average --points 1.5,6 "$deep"
check "a target is wanted" refuses 2 "--target" size "$deep"
check "a room file is wanted" refuses 2 "room file" size -t 2
check "a target of 0 is none" refuses 2 "above 0" size -t 0 "$deep"
check "an unknown change" refuses 2 "width, height, head, sill or number" \
    size -t 2 --change with "$deep"
check "an unknown method" refuses 2 "did you mean" size -t 2 --by exact+bra "$deep"
check "two methods" refuses 2 "one method or pair" size -t 2 --by exact,bre "$deep"
check "no window on that line" refuses 1 "no window on line 3" \
    size -t 2 --window 3 "$deep"
check "no window in that wall" refuses 1 '"nord"' size -t 2 --wall nord "$deep"
check "windows that are not alike have no number" refuses 1 "differ" \
    size -t 2 --change number --room Kitchen "$examples/building.xml"
check "one file to write, two to read" refuses 2 "--write" \
    size -t 2 -w "$scratch/two.xml" "$deep" "$classroom"
check "--error without a simulation" refuses 2 "--by-hand" \
    size -t 2 --by-hand --error 1% "$deep"
check "tracing by hand" refuses 2 "--by traced" size -t 2 --by-hand --by traced "$deep"
check "by hand nothing is traced" nothing \
    "$("$pepperpot" size -t 2 --by-hand --format json "$deep" | grep traced)"
# A window on a shaft of 3 x 4 m, 11 m deep, with white tiles; by hand methods 1 % is easily
# reached.
cat >"$scratch/well.xml" <<EOF
<room version="1"><plan width="3" depth="3.6" height="2.5"/>
<window wall="south" left="0.9" sill="0.95" width="1.2" height="1.2"/>
<block x="-3" y="-5" width="9" depth="1" height="11" reflectance="0.7"/>
<block x="-1" y="-4" width="1" depth="4" height="11" reflectance="0.7"/>
<block x="3" y="-4" width="1" depth="4" height="11" reflectance="0.7"/></room>
EOF
check "what the simulation denies the widest window is out of reach" \
    shows "simulation" size -t 3 --error 3% "$scratch/well.xml"
check "and is called so" grep -q "out of reach: even the widest" "$scratch/out"
check "what it denies the window found does not hold" \
    shows "do not use this size" size -t 0.5 --error 2% "$scratch/well.xml"
check "in JSON too" shows '"holds": false' \
    size -t 0.5 --error 2% --format json "$scratch/well.xml"
check "a method that does not cover the room says so" shows "bre" \
    size -t 2 --by exact+bre --sky uniform "$deep"
check "another does, where none was asked for" shows "by exact+split-flux" \
    size -t 2 --sky uniform "$deep"
check "a component by itself is named" shows "internally reflected component" \
    size -t 0.5 --by bre "$deep"
check "where there is no room for more that is said" shows "no space for more" \
    size -t 9 --change number "$deep"
tap_done
