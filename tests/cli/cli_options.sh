#!/bin/sh
# Command-line arguments: help, and every kind of error.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

check "the program has help" shows "Commands:" --help
check "help may be asked for by a letter" shows "Commands:" -h
check "the program has a version" shows "pepperpot " --version
check "no command is a wrong command line" refuses 2 "expected a command"
check "an unknown command suggests the nearest" \
    refuses 2 "did you mean chart?" chrat room.xml
check "an unknown word is no command" refuses 2 'no command "zzz"' zzz
check "an unknown first option is named" refuses 2 "--frobnicate" --frobnicate

# One program contains all commands, wherever it is installed.
alone="$scratch/a folder/alone"
mkdir -p "$alone"
cp "$pepperpot" "$alone/pepperpot"
check "a copy of the program elsewhere has daylight factors" "$alone/pepperpot" df "$deep"
check "and charts" "$alone/pepperpot" chart section "$deep" -o "$scratch/alone.svg"

for command in df chart; do
    check "$command has help" shows "Usage: pepperpot $command" $command --help
    check "$command's help wins over what is wrong behind it" \
        shows "Usage:" $command -h --nonsense
    check "$command suggests the nearest option" \
        refuses 2 "did you mean --simulate?" $command --simulat "$deep"
    check "$command wants a file" refuses 2 "expected" $command
    check "$command's help fits in 80 columns" \
        nothing "$("$pepperpot" $command --help | awk 'length > 80')"
done
check "df's help lists the methods" shows "brs-table" df --help

check "a switch takes no value" refuses 2 "takes no value" df --simulate=yes "$deep"
check "an option without its value" refuses 2 "needs a value" df "$deep" --methods
check "an unknown method suggests the nearest" refuses 2 "exact" df -m exat "$deep"
check "an unknown sky" refuses 2 "--sky" df --sky overcst "$deep"
check "an unknown format" refuses 2 "text, json or csv" df --format xml "$deep"
check "an error that is none" refuses 2 "expected a percentage" df -s --error 1,5% "$deep"
check "an error of more than the whole" refuses 2 "up to 100" df -s --error 101% "$deep"
check "an error needs a simulation" refuses 2 "expected --simulate" df --error 1% "$deep"
check "samples are whole" refuses 2 "whole number" df -s --samples 1e3 "$deep"
check "a time has a unit" refuses 2 "such as 10s" df -s --time soon "$deep"
check "error and samples exclude each other" \
    refuses 2 "expected only one of them" df -s --error 1% --samples 64 "$deep"
check "threads are from 1 up" refuses 2 "from 1 to 1024" df --threads 0 "$deep"
check "a seed is not negative" refuses 2 "--seed" df --seed -1 "$deep"
check "points have two coordinates or three" refuses 2 "X,Y" df --points 1.5 "$deep"
check "a point outside the room" refuses 1 "99" df --points 99,1 "$deep"
check "a room of no such name suggests the nearest" \
    refuses 1 "Kitchen" df --room Kitchn "$examples/building.xml"
check "--quiet and -- are taken" shows "Deep office" df --quiet -- "$deep"

# The man page explains all options listed by --help.
unexplained() {
    for command in df chart; do
        "$pepperpot" $command --help | grep -oE -- '(^|[ ,])--[a-z]+' |
            tr -d ' ,' | sort -u
    done | sort -u | while read -r option; do
        name=$(printf '%s' "$option" | sed 's/-/\\\\-/g')
        grep -q -- "$name" "$srcdir/docs/pepperpot.1" || echo "$option"
    done
}
check "the man page explains every option" nothing "$(unexplained)"

options=$("$pepperpot" df --help | grep -cE '^ +(-., )?--[a-z]')
check "the help shows all of df's options" test "$options" -ge 14
check "a short word's value is the next word" refuses 2 "did you mean -aa" \
    render -aa.2 -o "$scratch/x.png" "$deep"
check "a file without a name" refuses 1 "the name of the file is empty" df ""
tap_done
