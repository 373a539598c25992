# csv2c.awk - turns a published table into the rows of a C initialiser.
#
# Comment lines start with #. The first other line is the header: it is left out, unless all its
# fields but the first are numbers (a table of two arguments), when it becomes a first row {NAN,
# ...}. Numbers stay as printed, inf becomes INFINITY, an empty field NAN, anything else a string.
# Fields contain no commas.
BEGIN { FS = ","; print "/* made by csv2c.awk; do not edit */" }
function is_number(s) { return s ~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/ }
function c_value(s)
{
    if (s == "inf") return "INFINITY"
    if (s == "") return "NAN"
    if (is_number(s)) return s
    gsub(/["\\]/, "\\\\&", s)
    return "\"" s "\""
}
function row(first,    i, line)
{
    line = "{" first
    for (i = 2; i <= NF; i++) line = line ", " c_value($i)
    return line "},"
}
{ sub(/\r$/, "") }
/^#/ || /^$/ { next }
!header {
    header = 1
    columns = NF
    for (i = 2; i <= NF; i++) if (!is_number($i) && $i != "inf") next
    if (NF > 1) print row("NAN")
    next
}
NF != columns {
    printf "%s:%d: %d fields, expected %d\n", FILENAME, FNR, NF, columns > "/dev/stderr"
    exit 1
}
{ print row(c_value($1)) }
