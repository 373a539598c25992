# sentences.awk - lengths of sentences in Markdown pages: for each page the number of sentences,
# their mean length in words, and the longest; then the sentences that begin with "Of", "What" or
# "How". Headings, code, tables and comments are not counted; a span of code is one word.
#
#    awk -v limit=18 -f sentences.awk PAGE.md ...      exit status 1 over the limit

function sentence(text,    count, parts, word, i) {
    sub(/^[ *_"(]+/, "", text)
    parts = split(text, word, /[ \t]+/)
    if (parts == 0 || text !~ /[A-Za-z]/)
        return
    count = 0
    for (i = 1; i <= parts; i++)
        if (word[i] ~ /[A-Za-z0-9]/) # signs of a formula are none
            count++
    words += count
    sentences++
    if (count > longest)
        longest = count
    if (verbose && count > verbose)
        print page ": " count " words: " text
    if (text ~ /^(Of|What|How) /) {
        print page ": begins with " word[1] ": " text
        failed = 1
    }
}

# Divides a paragraph or list item at full stops, except those of abbreviations, which follow a
# single letter; a colon before a capital also ends a sentence.
function paragraph(    text) {
    text = block
    block = ""
    gsub(/`[^`]*`/, "Code", text)
    gsub(/\]\([^()]*\)/, "]", text)
    gsub(/[\[\]]/, "", text)
    while (match(text, /([^ .][^ .]| %)[.!?][)"*_]* +[^ ]|:[)"*_]* +[A-Z"*(]/)) {
        sentence(substr(text, 1, RSTART + RLENGTH - 2))
        text = substr(text, RSTART + RLENGTH - 1)
    }
    sentence(text)
}

function finish() {
    paragraph()
    if (sentences) {
        mean = words / sentences
        over = mean >= limit && sentences >= 5 # of fewer one long sentence makes the mean
        if (over) {
            failed = 1
            verdict = "  over " limit
        } else
            verdict = ""
        if (over || all)
            printf "%s: %d sentences, mean %.1f words, longest %d%s\n", page, sentences, mean, longest, verdict
    }
    total_words += words
    total_sentences += sentences
    words = sentences = longest = 0
}

FNR == 1 {
    if (page)
        finish()
    page = FILENAME
    fenced = commented = 0
}
/^```/ { paragraph(); fenced = !fenced; next }
fenced { next }
/^<!--/ { paragraph(); commented = 1 }
commented { if (/-->/) commented = 0; next }
/^    / && block == "" { next }
/^(#|\||!\[)/ || /^ *$/ { paragraph(); next }
/^ *([-*]|[0-9]+\.) / {
    paragraph()
    sub(/^ *([-*]|[0-9]+\.) +/, "")
}
{ block = block (block == "" ? "" : " ") $0 }
END {
    finish()
    if (all)
        printf "all: %d words, mean %.1f\n", total_words, total_words / total_sentences
    exit failed
}
