# reference.awk - the reference of the library, from pepperpot.h: sections become headings, comments
# become paragraphs, declarations are copied. make reference writes it to docs/reference.md; a check
# compares them.
function put_comment() {
    if (comment != "") {
        print "\n" comment
        comment = ""
    }
}
function put_code() {
    if (code != "") {
        printf "\n```c\n%s```\n", code
        code = ""
    }
}
BEGIN {
    print "# pepperpot.h, function by function"
    print "\nGenerated from the header by `make reference`; [library.md](library.md) explains their use."
}
/^#ifdef __cplusplus/ { skipping = 1 }
skipping { if (/^#endif/) skipping = 0; next }
/^#(ifndef|define PEPPERPOT_H|include|endif)/ { next }
/^\/\* ---- .* ---- \*\/$/ {
    put_comment()
    put_code()
    sub(/^\/\* ---- /, "")
    sub(/ ---- \*\/$/, "")
    print "\n## " toupper(substr($0, 1, 1)) substr($0, 2)
    next
}
/^\/\*/ && depth == 0 {
    put_comment()
    put_code()
    inside = 1
}
inside {
    line = $0
    last = line ~ /\*\/$/
    sub(/ ?\*\/$/, "", line)
    sub(/^\/\* ?/, "", line)
    sub(/^ \* ?/, "", line)
    if (line != "" || !last)
        comment = comment (comment == "" ? "" : "\n") line
    if (last) {
        inside = 0
        put_comment()
    }
    next
}
/^$/ && depth == 0 { put_code(); next }
{
    code = code $0 "\n"
    opened = gsub(/\{/, "{")
    closed = gsub(/\}/, "}")
    depth += opened - closed
}
END { put_code() }
