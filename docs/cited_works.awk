# cited_works.awk - turns docs/SOURCES.md into the rows of a C initialiser: key and work.
BEGIN { print "/* made by cited_works.awk; do not edit */" }
/^- \*\*\[.*\]\*\* / {
    key = $0
    sub(/^- \*\*\[/, "", key)
    sub(/\].*/, "", key)
    work = $0
    sub(/^- \*\*\[[^]]*\]\*\* /, "", work)
    gsub(/`/, "", work)
    gsub(/["\\]/, "\\\\&", work)
    print "{\"" key "\", \"" work "\"},"
}
