# links.awk - the links of Markdown pages that lead nowhere: to a file that is not there or to
# a heading that a page does not have.
#
#     awk -f links.awk PAGE.md ...          from the top of the sources

# "docs/a/../b.md" is docs/b.md.
function plain(path,    part, n, kept, i, text) {
    n = split(path, part, "/")
    kept = 0
    for (i = 1; i <= n; i++)
        if (part[i] == ".." && kept > 0 && out[kept] != "..")
            kept--
        else if (part[i] != "." && part[i] != "")
            out[++kept] = part[i]
    text = ""
    for (i = 1; i <= kept; i++)
        text = text (i > 1 ? "/" : "") out[i]
    return text
}

# The anchor of a heading, as GitHub and MyST make it.
function slug(text) {
    text = tolower(text)
    gsub(/[`*]/, "", text)
    gsub(/[^a-z0-9_ -]/, "", text)
    gsub(/ /, "-", text)
    return text
}

function is_there(path,    line, status) {
    if (path !~ /\.[A-Za-z0-9]*$/) # a folder
        return 1
    status = (getline line < path)
    close(path)
    return status >= 0
}

FNR == 1 { inside = 0 }
/^```/ { inside = !inside; next }
inside || /^    / { next }
/^##* / {
    text = $0
    sub(/^#+ /, "", text)
    heading[FILENAME, slug(text)] = 1
    next
}
{
    rest = $0
    gsub(/`[^`]*`/, "", rest)
    while (match(rest, /\]\([^() ]+\)/)) {
        to = substr(rest, RSTART + 2, RLENGTH - 3)
        rest = substr(rest, RSTART + RLENGTH)
        if (to ~ /^[a-z]+:/)
            continue
        count++
        place[count] = FILENAME ":" FNR
        shown[count] = to
        anchor[count] = ""
        if ((at = index(to, "#")) > 0) {
            anchor[count] = substr(to, at + 1)
            to = substr(to, 1, at - 1)
        }
        folder = FILENAME
        if (!sub(/\/[^\/]*$/, "", folder))
            folder = "."
        file[count] = to == "" ? FILENAME : plain(folder "/" to)
    }
}
END {
    for (i = 1; i <= count; i++)
        if (file[i] !~ /where\.md$/ && (!is_there(file[i]) || \
            (anchor[i] != "" && !((file[i], anchor[i]) in heading))))
            print place[i] ": " shown[i]
}
