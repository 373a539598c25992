# page2c.awk - text files as entries of page_files.c's list. Their paths begin behind "page".
function end_file() {
    if (open)
        print "\"\"),"
}
FNR == 1 {
    end_file()
    open = 1
    path = FILENAME
    if (!sub(/^.*\/page\//, "/", path))
        path = "/" path
    ending = path
    sub(/.*\./, "", ending)
    type = ending == "html" ? "text/html; charset=utf-8" : \
        ending == "css" ? "text/css; charset=utf-8" : \
        ending == "js" ? "text/javascript; charset=utf-8" : \
        ending == "svg" ? "image/svg+xml" : \
        ending == "json" ? "application/json" : \
        ending == "xml" ? "application/xml" : "text/plain; charset=utf-8"
    print "PAGE_FILE(\"" path "\", \"" type "\","
}
{
    gsub(/\\/, "&&")
    gsub(/"/, "\\\\&")
    gsub(/\?/, "\\\\&") # no trigraphs
    print "\"" $0 "\\n\""
}
END { end_file() }
