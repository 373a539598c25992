# draw_mutants.awk - deliberate errors in sources, drawn at random, in the format of mutants.txt:
# one line each, with the file and a sed command that changes one of its lines. A quarter each of
#
#  constants   a number with a decimal point, times 1.02 (none below 1e-4: tolerances)
#  signs       + replaced by -, - by +
#  comparisons < replaced by >, <= by >=, and the reverse
#  terms       a factor, divisor or summand that is a single name is removed
#
# Comments, strings, loops, preprocessor lines and memory sizes are excluded.
#
# Use: awk -v count=60 -v seed=1 -f draw_mutants.awk FILE...

BEGIN {
    state = (seed % 100000 * 1103515245 + 12345) % 2147483646 + 1 # streams of near seeds differ
    quota = int((count + 3) / 4)
}

# Integer from 0 to n - 1, by Lehmer's generator: the same in every awk.
function below(n) {
    state = state * 16807 % 2147483647
    return int(n * (state - 1) / 2147483646)
}

# The line with strings, characters and comments replaced by blanks, with the same length.
function code_of(line,    code, i, c, mark) {
    code = ""
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        if (comment) {
            if (c == "*" && substr(line, i + 1, 1) == "/") {
                comment = 0
                i++
                code = code " "
            }
            c = " "
        } else if (mark != "") {
            if (c == "\\") {
                i++
                code = code " "
            } else if (c == mark)
                mark = ""
            c = " "
        } else if (c == "/" && substr(line, i + 1, 1) == "*") {
            comment = 1
            i++
            c = "  "
        } else if (c == "\"" || c == "'") {
            mark = c
            c = " "
        }
        code = code c
    }
    return code
}

# Escapes special characters for the left side of sed's s, or ("&") for its right side.
function escaped(text, special,    i, c, out) {
    for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1)
        out = out (index("\\/" special, c) ? "\\" : "") c
    }
    return out
}

# A position where `new` could replace `old` in the line; kept with equal probability (reservoir
# sampling). sed needs the number of earlier occurrences.
function offer(kind, at, old, new,    k, from, found) {
    k = 1
    for (from = 1; (found = index(substr($0, from), old)) && from + found - 1 < at; k++)
        from += found - 1 + length(old)
    seen[kind]++
    place = seen[kind] <= quota ? seen[kind] : 1 + below(seen[kind])
    if (place <= quota)
        drawn[kind, place] = FILENAME " " FNR "s/" escaped(old, ".*[]^$") "/" \
            escaped(new, "&") "/" k
}

# Offers all matches of a pattern in the code.
function offer_all(kind, code, pattern,    at, from, old, new, value) {
    for (from = 1; match(substr(code, from), pattern); from = at + RLENGTH) {
        at = from + RSTART - 1
        old = substr(code, at, RLENGTH)
        new = ""
        if (kind == "constant") {
            value = old * 1.02
            if (old + 0 < 1e-4)
                continue
            new = sprintf("%.12g", value)
            if (new !~ /[.e]/)
                new = new ".0"
        } else if (kind == "sign")
            new = old == " + " ? " - " : " + "
        else if (kind == "comparison")
            new = old ~ /</ ? " >" substr(old, 3) : " <" substr(old, 3)
        else {
            # The text after the name must not be part of it.
            if (substr(code, at + RLENGTH, 1) ~ /[A-Za-z0-9_.(\[>-]/)
                continue
        }
        offer(kind, at, old, new)
    }
}

FNR == 1 { comment = 0 }
{ code = code_of($0) }
code ~ /^#|for \(|alloc\(|sizeof|snprintf|assert/ { next }
{
    offer_all("constant", code, "[0-9]+[.][0-9]+(e[-+]?[0-9]+)?")
    offer_all("sign", code, " [-+] ")
    offer_all("comparison", code, " [<>]=? ")
    offer_all("term", code, " [*/+] [A-Za-z_][A-Za-z0-9_]*([.]|->)?[A-Za-z0-9_]*")
}

END {
    split("constant sign comparison term", kinds, " ")
    for (i = 1; i <= count; i++) {
        kind = kinds[1 + (i - 1) % 4]
        place = 1 + int((i - 1) / 4)
        if ((kind, place) in drawn)
            print drawn[kind, place]
    }
}
