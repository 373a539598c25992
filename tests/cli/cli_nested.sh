#!/bin/sh
# Rooms nested in a coarse model, compared with the complete model, and bad input.
. "$srcdir/tests/lib/tap.sh"
. "$srcdir/tests/lib/cli.sh"

mkdir "$scratch/model"
cd "$scratch/model" || exit 1

# room NAME ATTRIBUTES CHILDREN: writes a room file.
room() {
    printf '<room version="1" name="%s" %s>%s</room>\n' "$1" "$2" "$3" >"$1.xml"
}
points='<point x="2" y="0.5"/><point x="2" y="1.5"/><point x="2" y="3.1"/>'
finishes='<finishes floor="0.2" walls="0.5" ceiling="0.7"/>'
office='<plan width="6" depth="5" height="3"/>'$finishes'<window name="w" wall="south"
    left="0.5" sill="0.8" width="3" height="1.7" glazing="none"/>'$points
atrium='<plan width="6" depth="10" height="9"/>'$finishes
window='<window name="w" wall="north" left="2.5" sill="0.8" width="3" height="1.7"
    glazing="none"/>'
roof='<rooflight x="0.5" y="0.5" width="5" depth="9" glazing="clear-double"
    frame-factor="0.8"/>'
room atrium '' "$atrium$window$roof"
room office 'within="atrium.xml"' "$office"

# The same as one room: an envelope in the form of an L, with a wall of free surfaces.
face() {
    role=$1
    shift
    printf '<face role="%s" name="%s">' "$role" "$1"
    shift
    for v; do
        printf '<vertex x="%s" y="%s" z="%s"/>' ${v}
    done
    printf '</face>'
}
rectangle() { # X1 X2 Z1 Z2 at y = 0
    printf '<surface reflectance="0.5"><vertex x="%s" y="0" z="%s"/>
        <vertex x="%s" y="0" z="%s"/><vertex x="%s" y="0" z="%s"/>
        <vertex x="%s" y="0" z="%s"/></surface>' "$1" "$3" "$2" "$3" "$2" "$4" "$1" "$4"
}
room whole '' "<envelope>$(
    face floor f '0 -10 0' '6 -10 0' '6 5 0' '0 5 0'
    face ceiling roof '0 -10 9' '0 0 9' '6 0 9' '6 -10 9'
    face ceiling low '0 0 3' '0 5 3' '6 5 3' '6 0 3'
    face wall s '0 -10 0' '0 -10 9' '6 -10 9' '6 -10 0'
    face wall n '0 5 0' '6 5 0' '6 5 3' '0 5 3'
    face wall m '0 0 3' '6 0 3' '6 0 9' '0 0 9'
    face wall w '0 -10 0' '0 5 0' '0 5 3' '0 0 3' '0 0 9' '0 -10 9'
    face wall e '6 -10 0' '6 -10 9' '6 0 9' '6 0 3' '6 5 3' '6 5 0'
)</envelope>$finishes<opening glazing='clear-double' frame-factor='0.8'>
    <vertex x='0.5' y='-9.5' z='9'/><vertex x='0.5' y='-0.5' z='9'/>
    <vertex x='5.5' y='-0.5' z='9'/><vertex x='5.5' y='-9.5' z='9'/></opening>$(
    rectangle 0 6 0 0.8
    rectangle 0 6 2.5 3
    rectangle 0 0.5 0.8 2.5
    rectangle 3.5 6 0.8 2.5
)$points"

# factors FILE [OPTIONS]: daylight factor and standard error at each point.
factors() {
    "$pepperpot" df -s --methods exact --error 1.5% --format csv "$@" 2>/dev/null |
        awk -F, '$3 == "point" && $10 == "df" && $11 != "exact" { print $12, $13 }'
}
# agree A B: the lists agree within 2 % or within 3 standard errors.
agree() {
    paste "$1" "$2" | awk '
        function away(d) { return d < 0 ? -d : d }
        { d = away($1 - $3); n++
          bad += !(d < 0.02 * $3) && !(d < 3 * sqrt($2 ^ 2 + $4 ^ 2)) }
        END { if (bad || n != 3) exit 1 }' || { paste "$1" "$2"; return 1; }
}
factors whole.xml >whole
factors office.xml >nested
check "an office off an atrium gets the light of the whole model" agree nested whole
factors --engine cache office.xml >cached
check "also by the irradiance cache" agree cached whole
factors --engine photons --error 1.5% office.xml >photons
check "and by photons" agree photons whole
factors --plain --error 1.5% office.xml >plain
check "and by the plain code" agree plain whole
check "any number of threads gives the same" same_by_threads "1 2" \
    df -s --samples 16 --methods exact --format csv office.xml
check "radiosity refuses panes before the windows" refuses 1 \
    "has panes between the room and the sky" df -s --engine radiosity office.xml
check "hand methods refuse them" shows \
    "exact: does not cover rooms nested within a model that has glass" df office.xml
check "but the formula for rooms off a well gives an average" sh -c \
    "'$pepperpot' df --methods average-df-well --format csv office.xml |
        grep -q 'average,.*df,average-df-well,[0-9]'"
check "and its assumptions" shows "depth of the window's middle below the roof" \
    df --methods average-df-well --explain --points 2,1 office.xml
check "the report names the model" shows \
    "within         atrium, in front of the windows; 20 surfaces, 1 pane" df office.xml

"$pepperpot" chart section -s --error 10% office.xml -o section.pdf 2>/dev/null
check "the section shows the line of sight to the edge of the roof" says section.pdf \
    "line of sight 38"

# Rotated by 90 degrees, the wall of the atrium named north faces west.
room turned 'north="-90"' "$(printf %s "$atrium$window$roof" | sed 's/"north"/"east"/
    s/width="6" depth="10"/width="10" depth="6"/
    s/x="0.5" y="0.5" width="5" depth="9"/x="0.5" y="0.5" width="9" depth="5"/')"
room office-turned 'within="turned.xml"' "$office"
factors office-turned.xml >turned
check "a model drawn in other axes is turned by its bearing of north" agree turned whole

# No light passes through the joint between the two models.
room dark '' "$atrium$window"
room office-dark 'within="dark.xml"' "$office"
factors office-dark.xml >dark
check "a room off a closed atrium has less than 0.002 % of light" awk \
    '!($1 < 0.002) || NR > 3 { exit 1 }' dark

# A street: the coarse model is a room in the same place, with its surroundings.
outside='<site ground-level="-1.2" ground-reflectance="0.15"/>
    <facade wall="south" left="17" right="17" up="7.8" down="1.2" reflectance="0.35"/>
    <block x="-17" y="-20" width="40" depth="8" base="-1.2" height="12"/>'
room street-whole '' "$office$outside"
room street '' "$(echo "$office$outside" | sed 's/walls="0.5"/walls="0.8"/')"
room street-office 'within="street.xml"' "$office<site ground-reflectance='0.15'/>"
factors street-whole.xml >whole
factors street-office.xml >nested
check "an office in a street gets the light of the whole model" agree nested whole

# In a lane with bright fronts the wall around the window matters, also where the coarse room is
# larger than the office: the facade in its plane has no gap there.
lane='<site ground-level="-1.2" ground-reflectance="0.15"/>
    <block x="-17" y="-10" width="40" depth="8" base="-1.2" height="8" reflectance="0.9"/>'
small=$(echo "$office" | sed 's/width="6" depth="5" height="3"/width="4" depth="5" height="2.8"/')
room lane-whole '' "$small$lane"'
    <facade wall="south" left="17" right="19" up="4" down="1.2" reflectance="0.9"/>'
room lane '' "$office$lane"'
    <facade wall="south" left="17" right="17" up="3.8" down="1.2" reflectance="0.9"/>'
room lane-office 'within="lane.xml"' "$small<site ground-reflectance='0.15'/>"
factors lane-whole.xml --error 0.8% >whole
factors lane-office.xml --error 0.8% >nested
check "the wall around its window reflects like the facade" agree nested whole

# Two facades in one plane, on the wings of a U: the wall of the room, in the left wing, reflects
# like the facade of that wing, whichever comes first.
u='<plan height="3"><vertex x="0" y="0"/><vertex x="4" y="0"/><vertex x="4" y="2"/>
    <vertex x="6" y="2"/><vertex x="6" y="0"/><vertex x="10" y="0"/><vertex x="10" y="5"/>
    <vertex x="0" y="5"/></plan><window name="w" wall="1" left="1" sill="0.9" width="2"
    height="1.5" glazing="none"/><block x="-17" y="-10" width="40" depth="8" height="8"
    reflectance="0.9"/>'
left='<facade wall="1" left="17" right="0" up="3" down="0" reflectance="0.9"/>'
right='<facade wall="5" left="0" right="13" up="3" down="0" reflectance="0.1"/>'
wing='<plan width="4" depth="5" height="3"/><window name="w" wall="south" left="1" sill="0.9"
    width="2" height="1.5" glazing="none"/>'$points
room left-right '' "$u$left$right"
room right-left '' "$u$right$left"
room wing 'within="left-right.xml"' "$wing"
factors wing.xml --error 3% >one
room wing 'within="right-left.xml"' "$wing"
factors wing.xml --error 3% >other
check "the order of facades does not matter" sh -c "test -s one && cmp one other"

# A recess and a bay of the room in the plane of the facade, each with its own window.
room front '' "<plan width='10' depth='5' height='3'/><window name='w' wall='south' left='7'
    sill='0.9' width='2' height='1.5' glazing='none'/>
    <facade wall='south' left='5' right='5' up='3' down='0' reflectance='0.5'/>"
stepped() { # Y of the step
    echo "<plan height='3'><vertex x='0' y='0'/><vertex x='3' y='0'/><vertex x='3' y='$1'/>
        <vertex x='6' y='$1'/><vertex x='6' y='0'/><vertex x='10' y='0'/><vertex x='10' y='5'/>
        <vertex x='0' y='5'/></plan><window name='w' wall='5' left='1' sill='0.9' width='2'
        height='1.5' glazing='none'/><window name='own' wall='3' left='0.5' sill='0.9' width='2'
        height='1.5' glazing='none'/><point x='4.5' y='2'/>"
}
room recess 'within="front.xml"' "$(stepped 1)"
room bay 'within="front.xml"' "$(stepped -1.5)"
room recess-alone '' "$(stepped 1)"
room bay-alone '' "$(stepped -1.5)"
open_front() { # NAME LEAST
    { factors "$1-alone.xml"; factors "$1.xml"; } | awk -v least="$2" '
        { print; df[NR] = $1 } END { exit !(NR == 2 && df[2] > least * df[1] && df[2] < df[1]) }'
}
check "the facade leaves the front of a recess open" open_front recess 0.7
check "and does not cut a bay" open_front bay 0.9

check "a street is no well" shows "average-df-well: the coarse model is in the place" \
    df --methods average-df-well street-office.xml

# The street as a room without a roof, in front of the windows.
room canyon '' '<plan width="40" depth="12" height="12"/>
    <finishes floor="0.15" walls="0.35" ceiling="0"/>
    <rooflight x="0" y="0" width="40" depth="12" glazing="none"/>
    <window wall="east" left="0" sill="0" width="12" height="12" glazing="none"/>
    <window wall="west" left="0" sill="0" width="12" height="12" glazing="none"/>
    <window name="w" wall="north" left="19.5" sill="2" width="3" height="1.7"
        glazing="none"/>'
room canyon-office 'within="canyon.xml"' "$office<site ground-reflectance='0.15'/>"
room canyon-whole '' "$office"'<site ground-level="-1.2" ground-reflectance="0.15"/>
    <facade wall="south" left="17" right="17" up="7.8" down="1.2" reflectance="0.35"/>
    <block x="-17" y="-20" width="40" depth="8" base="-1.2" height="12"
        reflectance="0.35"/>'
factors canyon-whole.xml >whole
factors canyon-office.xml >nested
check "also if the street is a room without a roof" agree nested whole
check "it is no well, since its ends are open" shows \
    "average-df-well: the coarse model has a window in" \
    df --methods average-df-well canyon-office.xml
check "where hand methods apply" sh -c \
    "'$pepperpot' df --format csv canyon-office.xml | grep -q 'sc,exact,[0-9]'"

# The export contains the atrium and its roof: the import of the scene gives the same figures.
check "export writes the coarse model" "$pepperpot" export --to radiance office.xml -o scene
(cd scene && "$pepperpot" import --points-file points.pts --error 1% --format csv \
    materials.rad room.rad glazing.rad outside.rad sky.rad 2>/dev/null) >imported
factors office.xml >nested
awk -F, 'NR > 1 { print $15, $16 }' imported >list
check "with the same light" agree list nested

# ---- bad input ----
warns() { # TEXT WORDS
    text=$1
    shift
    run "$@"
    [ $status -eq 0 ] && grep -qF -- "$text" "$scratch/err" || told
}
bad() { # NAME ATTRIBUTES TEXT
    room bad "$2" "$office"
    check "$1" refuses 1 "$3" df bad.xml
}
bad "a missing file is named" 'within="none.xml"' "bad.xml:1: room: within: none.xml"
bad "standard input is no model" 'within="-"' "bad.xml:1: room: within: -"
bad "a cycle is refused" 'within="bad.xml"' "is itself nested in another model"
bad "so is a model within a model" 'within="office.xml"' "is itself nested"
bad "window needs within" 'window="w"' "window is given without within"
bad "a missing window is named" 'within="atrium.xml" window="v"' \
    'there is no window "v"; expected w'
room nameless '' "$atrium$roof"
bad "a model without names is refused" 'within="nameless.xml"' "expected a window with a name"
room wide '' "$(echo "$atrium$window$roof" | sed 's/width="3"/width="3.2"/')"
bad "windows must have the same size" 'within="wide.xml"' \
    'are 3 m x 1.7 m and 3.2 m x 1.7 m; expected the same size'
room askew 'north="30"' "$atrium$window$roof"
bad "and bearings that agree" 'within="askew.xml"' "face bearings of 180 and 30 degrees"
room faulty '' '<plan width="6" depth="10"/>'
bad "mistakes in the model name its line" 'within="faulty.xml"' 'within "faulty.xml", line 1: plan'
room sunk '' "<site ground-level='2'/>$atrium$window$roof"
bad "its floor is not below ground" 'within="sunk.xml"' "below the ground outside"
echo '<building version="1"><room name="a"/><room name="b"/></building>' >two.xml
bad "the model is one room" 'within="two.xml"' 'within "two.xml"'
room bad 'within="atrium.xml"' "$office<skyline wall='south' angle='20'/>"
check "the outside belongs to the model" refuses 1 \
    "skyline: the room is nested within another model" df bad.xml
room bad 'within="atrium.xml"' "$office<window wall='north' left='1' sill='1' width='1' height='1'/>"
room floored '' "$(echo "$atrium$roof")<opening name='w' glazing='none'>
    <vertex x='1' y='1' z='0'/><vertex x='2' y='1' z='0'/><vertex x='2' y='2' z='0'/>
    <vertex x='1' y='2' z='0'/></opening>"
room below 'within="floored.xml"' '<plan width="6" depth="5" height="3"/>
    <finishes floor="0.2" walls="0.5" ceiling="0.7"/>
    <rooflight name="w" x="1" y="1" width="1" depth="1" glazing="none"/>'
check "a rooflight in the floor of an atrium is no window off a well" shows \
    "is not vertical" df --methods average-df-well below.xml
check "a window without a counterpart gives a warning" warns \
    "W1 has no counterpart in the coarse model" df bad.xml
tap_done
