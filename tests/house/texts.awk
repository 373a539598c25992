# texts.awk - the sentences printed by C sources: string literals of at least six words, with
# adjacent literals joined, divided at full stops before a capital. One line per sentence:
# "FILE:LINE: WORDS: SENTENCE". Formulae, comments and preprocessor lines are excluded.

function put_sentence(text,    parts, word, i, count) {
    gsub(/^[ (]+|[ ]+$/, "", text)
    parts = split(text, word, /[ \t]+/)
    count = 0
    for (i = 1; i <= parts; i++)
        if (word[i] ~ /[A-Za-z0-9]/)
            count++
    if (count >= 6 && text ~ /[a-z][a-z][a-z]* [a-z][a-z]/)
        print file ":" line ": " count ": " text
}

# Line breaks within a paragraph are blanks; empty lines, list items and indented lines separate
# sentences. A single letter or digit before a full stop is an initial or a number.
function put_literal(text) {
    gsub(/\\n\\n|\\n *-|\\n +/, "\001", text)
    gsub(/\\[nt]/, " ", text)
    gsub(/\\"/, "'", text)
    gsub(/\\u[0-9a-f][0-9a-f][0-9a-f][0-9a-f]/, "-", text)
    while (match(text, /([^ .][^ .]|%|[. ][0-9])[.!?][)'`*]* +[^ ]|: +[A-Z]|\001/)) {
        put_sentence(substr(text, 1, RSTART + RLENGTH - 2))
        text = substr(text, RSTART + RLENGTH - (substr(text, RSTART, 1) != "\001"))
    }
    put_sentence(text)
}

function end_literal() {
    if (joined)
        put_literal(literal)
    joined = 0
    literal = ""
}

FNR == 1 {
    end_literal()
    inside = 0
    file = FILENAME
}
/^#include/ { next }
{
    rest = $0
    while (rest != "") {
        if (inside) {
            if (!(end = index(rest, "*/")))
                break
            rest = substr(rest, end + 2)
            inside = 0
        } else if (match(rest, /^[ \t\\]+/)) {
            rest = substr(rest, RLENGTH + 1)
        } else if (match(rest, /^"([^"\\]|\\.)*"/)) {
            if (!joined)
                line = FNR
            literal = literal substr(rest, 2, RLENGTH - 2)
            joined = 1
            rest = substr(rest, RLENGTH + 1)
        } else if (rest ~ /^\/\*/) {
            inside = 1
            rest = substr(rest, 3)
        } else {
            end_literal()
            if (match(rest, /^'([^'\\]|\\.[^']*)'/) || match(rest, /^[^"'\/ \t\\]+/))
                rest = substr(rest, RLENGTH + 1)
            else
                rest = substr(rest, 2)
        }
    }
}
END { end_literal() }
