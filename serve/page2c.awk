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
    extension = path
    sub(/.*\./, "", extension)
    type = extension == "html" ? "text/html; charset=utf-8" : \
        extension == "css" ? "text/css; charset=utf-8" : \
        extension == "js" ? "text/javascript; charset=utf-8" : \
        extension == "svg" ? "image/svg+xml" : \
        extension == "json" ? "application/json" : \
        extension == "xml" ? "application/xml" : "text/plain; charset=utf-8"
    print "PAGE_FILE(\"" path "\", \"" type "\","
}
{
    gsub(/\\/, "&&")
    gsub(/"/, "\\\\&")
    gsub(/\?/, "\\\\&") # no trigraphs
    print "\"" $0 "\\n\""
}
END { end_file() }
