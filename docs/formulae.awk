# formulae.awk - updates the formulae on a page: the lines between "<!-- formulae of METHOD -->" and
# "<!-- end of formulae -->" are replaced by the output of `pepperpot df --list-formulas`.
#
#     pepperpot df --list-formulas | awk -f docs/formulae.awk - docs/methods/bre.md

# The list: a method in the first column, its formulae in the third.
NR == FNR {
    if ($0 ~ /^[a-z][a-z-]*  \[/)
        method = $1
    else if ($0 ~ /^  [^ ]/ && method) {
        line = substr($0, 3)
        source = ""
        if ((at = index(line, "  [")) > 0) {
            source = substr(line, at + 2)
            line = substr(line, 1, at - 1)
        }
        line = sprintf("    %-66s", line) " " source
        sub(/ *$/, "", line)
        formulae[method] = formulae[method] line "\n"
    }
    next
}

/^<!-- formulae of / {
    print
    print ""
    printf "%s", formulae[$4]
    print ""
    left_out = 1
}
/^<!-- end of formulae -->/ { left_out = 0 }
!left_out { print }
