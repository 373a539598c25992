# page2c.awk - converts text files to entries of the list in page_files.c. The path of an entry is
# the part of the file's path after "page".
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
