# situations.awk - the table of one room in docs/situations.md, from df --format csv, in per
# cent: direct components (sky and externally reflected together), internally reflected
# components and daylight factors, at the two points of the room and on average. Single
# methods without a figure follow, with the reason. Standard errors below 0.005 are omitted.
BEGIN { FS = "," }

# Only the last field, the reason for a missing figure, may contain commas.
NR > 1 {
    place = $3 == "average" ? "average" : $4 " " $5
    if (!(place in places)) {
        places[place] = ++place_count
        place_of[place_count] = place
    }
    part = $10 == "sc" || $10 == "erc" ? "direct" : $10
    key = part SUBSEP $11
    if (!(key in known)) {
        known[key] = 1
        order[++count] = key
    }
    if ($12 == "") {
        why = $0
        sub(/\r$/, "", why)
        for (i = 1; i <= 14; i++)
            sub(/^[^,]*,/, "", why)
        gsub(/^"|"$/, "", why)
        sub("^" $11 ": ", "", why)
        reason[key] = why
    } else {
        value[key, place] += $12
        variance[key, place] += $13 * $13
        given[key, place]++
        any[key] = 1
    }
}

function figure(key, place,    text) {
    if (given[key, place] < (key ~ /^direct/ ? 2 : 1))
        return "–"
    text = sprintf("%.2f", value[key, place])
    if (variance[key, place] >= 0.005 * 0.005)
        text = text sprintf(" ± %.2f", sqrt(variance[key, place]))
    return text
}

END {
    heads["direct"] = "direct light"
    heads["irc"] = "internally reflected light"
    heads["df"] = "daylight factor"
    line = "| method |"
    rule = "| --- |"
    for (p = 1; p <= place_count; p++) {
        split(place_of[p], at, " ")
        line = line (place_of[p] == "average" ? " average |" \
            : sprintf(" at %.1f m |", at[2]))
        rule = rule " ---: |"
    }
    print "\n" line "\n" rule
    split("direct irc df", parts, " ")
    for (n = 1; n <= 3; n++) {
        printf "| *%s* |", heads[parts[n]]
        for (p = 1; p <= place_count; p++)
            printf " |"
        print ""
        for (i = 1; i <= count; i++) {
            split(order[i], word, SUBSEP)
            # Pairs of methods are shown only if the direct method is exact.
            if (word[1] != parts[n] || !any[order[i]] || word[2] ~ /[a-z]\+/ \
                && word[2] !~ /^exact\+/)
                continue
            printf "| `%s` |", word[2]
            for (p = 1; p <= place_count; p++)
                printf " %s |", figure(order[i], place_of[p])
            print ""
        }
    }
    for (i = 1; i <= count; i++) {
        split(order[i], word, SUBSEP)
        why = reason[order[i]]
        if (any[order[i]] || word[2] ~ /\+/ || word[2] in said)
            continue
        said[word[2]] = 1
        if (!(why in who))
            reasons[++reason_count] = why
        who[why] = who[why] (who[why] ? ", " : "") "`" word[2] "`"
    }
    print ""
    for (i = 1; i <= reason_count; i++)
        print "No figure from " who[reasons[i]] ": " reasons[i] ".\n"
}
