# streets.sh - for tests of skylines with a distance: a room opposite a skyline, and opposite the
# long block in its place.

# street KIND WALL DISTANCE ANGLE REFLECTANCE UP MORE: KIND is skyline or block, south of the room;
# WALL is the wall of the window; UP is the height of the room's own south façade above the room,
# 60 m to either side (-: none); MORE are further elements.
street() {
    awk -v kind="$1" -v wall="$2" -v distance="$3" -v angle="$4" -v reflectance="$5" \
        -v up="$6" -v more="$7" 'BEGIN {
        print "<room version=\"1\" name=\"Street\"><plan width=\"3.6\" depth=\"5.1\" height=\"2.7\"/>"
        print "<finishes floor=\"0.25\" walls=\"0.6\" ceiling=\"0.8\"/>"
        printf "<window wall=\"%s\" left=\"0.8\" sill=\"0.9\" width=\"2\" height=\"1.5\"/>\n", wall
        if (up != "-")
            printf "<facade wall=\"south\" left=\"60\" right=\"60\" up=\"%s\" reflectance=\"%s\"/>\n", \
                up, reflectance
        if (kind == "skyline")
            printf "<skyline wall=\"south\" angle=\"%s\" distance=\"%s\" reflectance=\"%s\"/>\n", \
                angle, distance, reflectance
        else { # the angle is seen from the middle of the window, or of a wall without one
            radians = angle * atan2(0, -1) / 180
            level = match(more, /ground-level=.[-0-9.]*/) ? substr(more, RSTART + 14, RLENGTH - 14) : 0
            printf "<block x=\"-9000\" y=\"%.15g\" width=\"18000\" depth=\"11\" height=\"%.15g\" reflectance=\"%s\"/>\n", \
                -distance - 11, (wall == "south" ? 1.65 : 1.35) - level + distance * sin(radians) / cos(radians), reflectance
        }
        print more
        print "<point x=\"1.9\" y=\"1.4\"/><point x=\"1.7\" y=\"4.1\"/></room>"
    }'
}

# factors ENGINES ERROR FILE: engine, place, daylight factor and standard error in per cent, one
# line for each point and the average.
factors() {
    "$pepperpot" df -q --methods exact --simulate --engine "$1" --error "$2" --format csv "$3" |
        awk -F, '$10 == "df" && $12 != "" { print $11, $3 $4 $5, $12, $13 }'
}

# agree A B SHARE: the lines of factors agree: within SHARE of the value in B, or within three
# standard errors of the difference if one such error is less than SHARE of that value, or less
# than a daylight factor of 0.003 %.
agree() {
    paste -d' ' "$1" "$2" | awk -v share="$3" '
    NF == 8 && $1 == $5 && $2 == $6 {
        off = $3 - $7; error = sqrt($4 * $4 + $8 * $8)
        printf "%-10s %-12s %8.4f +- %.4f %8.4f +- %.4f  %+6.2f %%\n", $1, $2, $3, $4, $7, $8, 100 * off / $7
        if (off < 0) off = -off
        good += off < share * $7 || (off < 3 * error && (error < share * $7 || error < 0.003))
    }
    END { exit !(NR > 0 && good == NR) }'
}
