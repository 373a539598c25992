# text2c.awk - the lines of a text as C string literals, to be included in an initialiser.
{
    gsub(/\\/, "&&")
    gsub(/"/, "\\\\&")
    print "\"" $0 "\\n\""
}
