#!/bin/sh
# write_performance.sh PROGRAM BENCH ... - prints docs/PERFORMANCE.md: the machine, the output of
# each benchmark program, the comparisons with Radiance by compare_radiance.sh and compare_rpict.sh,
# and the latency of the drawing board by bench_page.sh in the folder of this script. SCENES="NAME ...": scenes of compare_radiance.sh
# (default: all). Run by make bench.
set -eu
LC_ALL=C
export LC_ALL
program=$1
shift
here=$(cd "$(dirname "$0")" && pwd)

say() {
    echo "bench: $*" >&2
}

# value NAME FILE: the text after the first "NAME :".
value() {
    sed -n "s/^$1[[:space:]]*:[[:space:]]*//p" "$2" 2>/dev/null | sed 1q
}

# processor: name and clock rate of the processor, from /proc/cpuinfo.
processor() {
    name=$(value 'model name' /proc/cpuinfo)
    mhz=$(value 'cpu MHz' /proc/cpuinfo)
    echo "${name:-$(uname -m)}${mhz:+, $mhz MHz}"
}

memory() {
    value MemTotal /proc/meminfo | awk '{ printf "%.1f GiB", $1 / 1048576 }'
}

# about FILE: the text of a program's first comment.
about() {
    sed '/\*\//q' "$1" | tr '\n' ' ' |
        sed 's|^/\* *[^ ]* - ||; s| *\*/.*||; s| \* | |g; s|  *| |g' |
        awk '{ print toupper(substr($0, 1, 1)) substr($0, 2) }'
}

cat <<END
# Performance

\`make bench\` writes this page; do not edit it by hand. Run the benchmarks on an otherwise idle machine.
Rates and times depend on the machine; ratios depend on it less. Times are the processor times of all
threads together, unless they are marked as clock times. Where a result has a target, the target is given
in brackets after the result.

| | |
| --- | --- |
| date | $(date -u '+%Y-%m-%d') |
| program | $("$program" --version | sed 1q) |
| processor | $(processor) |
| processors | $(getconf _NPROCESSORS_ONLN) |
| memory | $(memory) |
| system | $(uname -s) $(uname -r), $(uname -m) |
| compiler | $(${CC:-cc} --version 2>/dev/null | sed 1q) |
| Radiance | $( (rtrace -version 2>/dev/null || echo 'not installed') | sed 1q) |
| load before | $(cut -d' ' -f1-3 /proc/loadavg 2>/dev/null || echo unknown) |
END
for bench; do
    say "$bench"
    name=$(basename "$bench")
    printf '\n## %s\n\n' "$name"
    about "$here/$name.c" | fold -s -w 96 | sed 's/ *$//'
    printf '\n\n```\n'
    "./$bench"
    printf '```\n'
done
say compare_radiance.sh
cat <<'END'

## Against Radiance

`bench/compare_radiance.sh` calculates the same rooms with `df --simulate` and with Radiance, to which
`pepperpot export` exports them. All runs use one processor, one after the other. Radiance is run in two
ways:

- *Without a cache.* `rtrace` follows every path to its end without an ambient cache, as in the exported
  script. Each point is calculated independently, and the results are unbiased.
- *With the settings of an expert.* The panes are divided into parts of at most 0.3 m, and `mkillum`
  calculates the light that enters through each part. Two-sided materials (`mixfunc`) are replaced by
  plain ones, and the ground beyond 60 m is a `glow`. A first pass (the overture) fills an ambient file.
  A second pass with the same file and a fine `-ds` gives the results. The times include `mkillum` and
  both passes. The ambient cache causes a bias. The coarse, usual and fine runs differ in these settings.

The error is the root mean square of (result - reference)/reference over the points. The mean error is
the mean of the same ratio; if it exceeds the noise, it shows a bias. The reference values are the means
of eight accurate runs of `df --simulate`. The noise of these means is estimated from the spread of the
eight runs, and subtracted from the errors. A second reference, an accurate run of `rtrace`, would reveal
an error common to all runs of `df`. The text above each table gives the mean difference between the two
references, with its standard error. The last column of the table is the error relative to the `rtrace`
reference, including the noise of this reference.

The lines below each table compare the times of Radiance and `df`. Each expert run is compared with the
fastest run of `df` whose error is no larger; both times were measured. Runs without a cache are compared
at equal error. Their times are extrapolated from measured runs, since for unbiased estimates the
product of time and squared error is constant. `df` also stops when the standard error falls to 0.002 %
daylight factor. At a point behind the leaves of a tree, with a daylight factor of 0.14 %, this is 1.4 % of
the value, so such points do not reach an error of 0.4 %.
END
# shellcheck disable=SC2086 # several words, or none: all scenes
sh "$here/compare_radiance.sh" "$program" ${SCENES:-}
say compare_rpict.sh
cat <<'END'

## Against rpict

`bench/compare_rpict.sh` calculates one view of the deep office with `render` and with Radiance's
`rpict`, each on one processor. `rpict` uses the expert settings described above; its overture (first
pass) calculates a sixteenth of the pixels.
END
sh "$here/compare_rpict.sh" "$program"
say bench_page.sh
cat <<'END'

## The drawing board

`bench/bench_page.sh` drags a window of each example room in the page of `pepperpot serve`, in headless
Chromium, which draws by software. Clock times in milliseconds, from a pointer event to the updated
contours [median 50, 95th percentile 100]; with the parts that the server, the transfer and the drawing
take. Then, from a change to the first simulated estimate [150] and until the target of 1 % is reached at
all points [1000].

END
if board=$(sh "$here/bench_page.sh"); then
    printf '```\n%s\n```\n' "$board"
else
    echo "Not measured: $board."
fi
