# code_blocks.awk - updates the pieces of source code in a document. In the source, a piece is
# between the comments `theory: NAME` and `theory: end`; in the document it is the block after the
# line
#
#     <!-- code: FILE, NAME -->
#
#     awk -v top=DIR -f code_blocks.awk docs/theory.md        top: where FILE begins
#
# Exit status 1 if a source has no such piece.

# piece(FILE, NAME): prints the lines of the piece.
function piece(file, name,    line, inside, found) {
    while ((getline line < (top "/" file)) > 0) {
        if (line ~ "^/\\* theory: end \\*/")
            inside = 0
        if (inside)
            print line
        if (line == "/* theory: " name " */")
            inside = found = 1
    }
    close(top "/" file)
    if (!found) {
        print FILENAME ":" FNR ": " file " has no piece called " name > "/dev/stderr"
        failed = 1
    }
}

/^<!-- code: .*, .* -->$/ {
    print
    match($0, /: .*,/)
    file = substr($0, RSTART + 2, RLENGTH - 3)
    name = substr($0, RSTART + RLENGTH + 1)
    sub(/ -->$/, "", name)
    print "```c"
    piece(file, name)
    print "```"
    skipping = 1 # the block of the document
    next
}
skipping && /^```$/ { skipping = 0; next }
!skipping { print }
END { exit failed }
