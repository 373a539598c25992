# libpepperpot.awk HEADER ... - the names of the functions that headers declare, one per line, for
# the exports of the shared library. Comments, preprocessor lines and bodies are left out. In the
# rest, a declaration is the text before a semicolon, and its name is the word before the first
# parenthesis. Static functions and typedefs are left out.

function declared(statement,    name) {
    gsub(/[ \t]+/, " ", statement)
    sub(/^ /, "", statement)
    if (statement ~ /^(static|typedef) / || !match(statement, /[A-Za-z_0-9]+ ?\(/))
        return
    name = substr(statement, RSTART, RLENGTH)
    gsub(/[ (]/, "", name)
    if (name != "" && name !~ /^__/)
        print name
}

# Lines for C++ only: the braces of extern "C".
/^#ifdef __cplusplus/ { cplusplus = 1 }
cplusplus { if (/^#endif/) cplusplus = 0; next }

FNR == 1 { comment = 0; depth = 0; continued = 0; statement = "" }

!comment && (continued || /^[ \t]*#/) {
    continued = /\\$/
    next
}

{
    line = $0 " "
    while (line != "") {
        if (comment) {
            if (!(end = index(line, "*/")))
                break
            line = substr(line, end + 2)
            comment = 0
        } else if (line ~ /^\/\*/) {
            comment = 1
            line = substr(line, 3)
        } else {
            c = substr(line, 1, 1)
            line = substr(line, 2)
            if (c == "{")
                depth++
            else if (c == "}") {
                # An inline function's body ends its declaration, a struct's does not.
                if (--depth == 0 && statement ~ /^[ \t]*static /)
                    statement = ""
            } else if (depth == 0 && c == ";") {
                declared(statement)
                statement = ""
            } else if (depth == 0)
                statement = statement c
        }
    }
}
