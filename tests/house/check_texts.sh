#!/bin/sh
# Texts printed by the program read as plain English: no sentence begins with "Of", "What", "How"
# or "Which", few are long, and the mean length is small in every folder.
. "$srcdir/tests/lib/tap.sh"

folders="model formats methods simulate studies charts reports api serve cli"
mean=15    # words in a sentence
longest=32 # words in a sentence

# Literals in another language: functions of Radiance, a style sheet, names of options, headings of
# tables for programs.
code="formats/radiance/rad_functions.c reports/page/html.c reports/atlas/atlas_bands_csv.c
    serve/work/program_words.c"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$srcdir" || exit 1

find $folders -name '*.c' | LC_ALL=C sort >"$scratch/files"
printf '%s\n' $code >"$scratch/code"
grep -vxF -f "$scratch/code" "$scratch/files" | xargs ${AWK:-awk} -f tests/house/texts.awk \
    >"$scratch/texts"

check "sentences are found" test "$(wc -l <"$scratch/texts")" -gt 1000
check "no sentence begins with Of, What, How or Which" \
    nothing "$(grep -E '^[^:]*:[0-9]+: [0-9]+: (Of|What|How|Which) ' "$scratch/texts")"
check "no sentence has more than $longest words" \
    nothing "$(${AWK:-awk} -F: -v most="$longest" '$3 > most' "$scratch/texts")"
check "the mean of each folder is under $mean words" nothing "$(${AWK:-awk} -F: -v most="$mean" '
    {
        split($1, part, "/")
        count[part[1]]++
        words[part[1]] += $3
    }
    END {
        for (folder in count)
            if (words[folder] >= most * count[folder])
                printf "%s: %.1f words\n", folder, words[folder] / count[folder]
    }' "$scratch/texts")"
tap_done
