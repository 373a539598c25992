# where.awk - lists the places in the program that cite each work of docs/SOURCES.md, one per line,
# with the equation, table or page if it is named.
#
#     awk -f docs/where.awk docs/SOURCES.md FILE...     from the top, in order
BEGIN {
    print "# Where a source is in the program"
    print ""
    print "Made by `make where`: the works of [SOURCES.md](SOURCES.md) that the program cites. Where an"
    print "equation, a table or a page of it is named, and where a formula is data, the line is given,"
    print "else the file, whose head or comments say what is from there."
    print ""
    print "| source | place in it | file and line |"
    print "| --- | --- | --- |"
}

# "eq. 12" after a key: the text up to the first character that is not part of a place.
function place_of(text) {
    if (match(text, /^,? *\(?(eqs?\.|equations?|tables?|figs?\.|p\.|pp\.|section|chapter) *[(]?[0-9A-Za-z][0-9A-Za-z.]*[)]?/)) {
        place = substr(text, RSTART, RLENGTH)
        gsub(/^[, (]+|[.)]+$/, "", place)
        gsub(/\(/, "", place)
        sub(/^equations? */, "eq. ", place)
        return place
    }
    return ""
}

function note(key, place, exact,    where) {
    where = exact || place ? FILENAME ":" FNR : FILENAME
    if (!(key in listed) || (where, key, place) in seen)
        return
    seen[where, key, place] = 1
    rows[key, place] = rows[key, place] (rows[key, place] ? ", " : "") where
}

NR == FNR {
    if (match($0, /^- \*\*\[[A-Za-z0-9]*\]/))
        listed[substr($0, 6, RLENGTH - 6)] = 1
    next
}

{
    rest = $0
    while (match(rest, /\[[A-Z][A-Z0-9]+[A-Za-z]*\]/)) {
        key = substr(rest, RSTART + 1, RLENGTH - 2)
        rest = substr(rest, RSTART + RLENGTH)
        note(key, place_of(rest), 0)
    }
    if (match($0, /\.source = "[^"]*"/)) {
        text = substr($0, RSTART + 11, RLENGTH - 12)
        comma = index(text, ",")
        note(comma ? substr(text, 1, comma - 1) : text, comma ? place_of(substr(text, comma)) : "", 1)
    }
}

END {
    for (row in rows) {
        split(row, parts, SUBSEP)
        print "| [" parts[1] "] | " parts[2] " | " rows[row] " |" | "LC_ALL=C sort"
    }
}
