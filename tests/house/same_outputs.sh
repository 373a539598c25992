#!/bin/sh
# same_outputs.sh BEFORE AFTER - runs two builds of the program side by side: every command for
# every example room, in every format, and the messages and exit status of every wrong call. Prints
# each file in which they differ. For changes that move and rename code without changing results;
# takes minutes and is not part of make check. AFTER must be in its build folder with
# test_wrong_rooms (make check), which writes the wrong rooms.
set -eu
case $#:${1-} in
2:/* | 2:./* | 2:*/*) ;;
*)
    echo "usage: same_outputs.sh BEFORE AFTER   (paths of two programs)" >&2
    exit 2
    ;;
esac
source=$(cd "$(dirname "$0")/../.." && pwd)
before=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
after=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
writer=$(dirname "$after")/tests/model/room/read/test_wrong_rooms
[ -x "$writer" ] || {
    echo "same_outputs.sh: $writer is not built: make tests/model/room/read/test_wrong_rooms" >&2
    exit 2
}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# said FILE ARGUMENT ...: output, messages and exit status of a call.
said() {
    file=$1
    shift
    status=0
    "$program" "$@" >"$file.out" 2>"$file.err" || status=$?
    echo "$status" >>"$file.err"
}

few='--samples 2 --seed 7 --threads 2 --quiet'

# tables ROOM NAME: text output for a room file.
tables() {
    for format in text json csv; do
        said "$2.df-$format" df -m all $few --simulate --format $format "$1"
        said "$2.validate-$format" validate $few --format $format "$1"
        said "$2.availability-$format" availability -m exact+split-flux --latitude 51 \
            --hours 9-17 --quiet --format $format "$1"
    done
    for format in text json; do
        said "$2.explain-$format" df -m all --explain --points 1.4,1.5 --quiet --room 1 \
            --format $format "$1"
        said "$2.explain-all-$format" df -m all --explain --points 1.4,1.5 --quiet \
            --format $format "$1"
        said "$2.assess-$format" assess --quiet --by-hand --format $format "$1"
        said "$2.assess-traced-$format" assess $few --simulate --format $format "$1"
        said "$2.size-$format" size --target 2.5% --by-hand --quiet --format $format "$1"
        said "$2.size-head-$format" size --target 2% --change head --by average-df --by-hand --quiet \
            --format $format -w "$2.sized-$format.xml" "$1"
    done
    said "$2.cache" df --simulate --engine path,cache -ad 128 -as 32 $few "$1"
    said "$2.sky" df --sky iso-12,40,180 -m exact --quiet --external 5000 "$1"
}

# charts ROOM NAME: every chart of a room file, in every format.
charts() {
    for format in pdf svg png; do
        said "$2.$format.section" chart section -o "$2-section.$format" --dpi 60 "$1"
        said "$2.$format.log" chart section --log --simulate $few -o "$2-log.$format" --dpi 60 "$1"
        said "$2.$format.plan" chart plan -o "$2-plan.$format" --dpi 60 "$1"
        said "$2.$format.availability" chart availability --latitude 51 \
            -o "$2-availability.$format" --dpi 60 "$1"
        for kind in waldram pepper-pot protractor; do
            said "$2.$format.$kind" chart $kind --points 1.4,1.5 -o "$2-$kind.$format" \
                --dpi 60 "$1"
        done
        for which in average minimum rooflight; do
            said "$2.$format.$which" chart nomogram --which $which \
                -o "$2-nomogram-$which.$format" --dpi 60 "$1"
        done
    done
}

# pictures ROOM NAME: pictures of a room file, and its exports.
pictures() {
    for format in hdr pfm png; do
        said "$2.$format.picture" render --size 48x36 --samples 2 --quiet --threads 2 \
            -ad 64 -as 16 -o "$2-picture.$format" "$1"
    done
    said "$2.fisheye" render --size 40x40 --samples 2 --quiet -ad 64 -as 16 --view plan \
        --quantity df --false-colour --paper a5 --dpi 60 -o "$2-fisheye.png" "$1"
    said "$2.export" export "$1" --to radiance -o "$2-radiance"
    [ ! -f "$2-radiance/sky.rad" ] || said "$2.import" import "$2-radiance"/materials.rad "$2-radiance"/[!m]*.rad \
        --points-file "$2-radiance/points.pts" --quiet --samples 2
}

blanks() {
    for kind in waldram pepper-pot protractor nomogram brs-table vertical-sky skylight-indicator \
        overlay availability; do
        for format in pdf svg png; do
            said "blank.$kind.$format" chart $kind -o "blank-$kind.$format" --latitude 51
            said "blank.$kind.$format" chart $kind -o "blank-$kind.$format"
        done
    done
    said blank.fine chart pepper-pot --fine -o blank-fine.pdf
    said blank.uniform chart waldram --glazed no --sky uniform -o blank-uniform.pdf
    said known validate
    said known-json validate --format json
}

words() {
    said help --help
    said version --version
    said nothing
    said unknown sissors
    for command in df chart assess availability size validate render export import; do
        said "help.$command" $command --help
        said "bare.$command" $command
        said "option.$command" $command --sampels 3
        said "missing.$command" $command no-such-file.xml
    done
    said list chart --list
    for room in "$rooms"/wrong/*.xml; do
        said "wrong.$(basename "$room")" df --quiet "$room"
    done
}

for side in before after; do
    eval program=\$$side
    mkdir "$scratch/$side"
    cd "$scratch/$side"
    # With the same file names for both builds, since messages contain them.
    mkdir -p rooms/wrong
    cp "$source"/examples/*.xml rooms
    srcdir=$source "$writer" --write-all rooms/wrong
    rooms=rooms
    words
    blanks
    for room in rooms/*.xml; do
        name=$(basename "$room" .xml)
        tables "$room" "$name"
        charts "$room" "$name"
        pictures "$room" "$name"
    done
done

cd "$scratch"
echo "$(find before -type f | wc -l) files compared"
diff -rq before after && echo "all the same"
