#!/bin/sh
# write_performance.sh PROGRAM BENCH ... - docs/PERFORMANCE.md, on standard output: the
# machine, what each of the benchmark programs prints, and the comparisons with Radiance by
# compare_radiance.sh and compare_rpict.sh, which stand beside this script.
# SCENES="NAME ...": these of the former's scenes. Run by make bench.
set -eu
LC_ALL=C
export LC_ALL
program=$1
shift
here=$(cd "$(dirname "$0")" && pwd)

say() {
    echo "bench: $*" >&2
}

# value NAME FILE: what stands behind "NAME :" where it is first.
value() {
    sed -n "s/^$1[[:space:]]*:[[:space:]]*//p" "$2" 2>/dev/null | sed 1q
}

# processor: its name; bare as /proc/cpuinfo has it.
processor() {
    name=$(value 'model name' /proc/cpuinfo)
    mhz=$(value 'cpu MHz' /proc/cpuinfo)
    echo "${name:-$(uname -m)}${mhz:+, $mhz MHz}"
}

memory() {
    value MemTotal /proc/meminfo | awk '{ printf "%.1f GiB", $1 / 1048576 }'
}

# about FILE: the sentence at the head of a program.
about() {
    sed '/\*\//q' "$1" | tr '\n' ' ' |
        sed 's|^/\* *[^ ]* - ||; s| *\*/.*||; s| \* | |g; s|  *| |g' |
        awk '{ print toupper(substr($0, 1, 1)) substr($0, 2) }'
}

cat <<END
# Performance

\`make bench\` writes this page; do not edit. Run the benchmarks on an otherwise idle machine. Rates
and times depend on the machine, ratios less so. Times are processor times of all threads together,
unless marked as clock times. Results are shown next to their target, called \`wanted\`.

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

`bench/compare_radiance.sh` calculates the same rooms, exported by `pepperpot export`, with Radiance
and with `df --simulate`. All runs use one processor, one after the other. Radiance runs in two ways.
First, `rtrace` traces every path to its end without a cache, as in the exported script: points share
nothing, and the results are unbiased. Second, an expert would use these settings: panes in parts of
0.3 m, whose light `mkillum` gathers at low cost; plain materials; the ground beyond 60 m as a glow; an
overture and a second pass with the same ambient file and fine `-ds`. These times include `mkillum` and
both passes. The ambient cache causes a bias.

The error is the root mean square of (found - true)/true over the points. The mean of (found -
true)/true is also given; it is the bias where it exceeds the noise. The true values are the means of
eight fine runs of `df --simulate`; their own noise, from the spread of the runs, is subtracted. A fine
run of `rtrace` tests for a common error of all our runs. Above each table is the mean difference of the
two references with its standard error; the last column is the error against `rtrace`, including its
noise.

Below each table is the ratio of times. An expert run is compared, as measured, with our fastest run of
no larger error. Runs without a cache are compared at equal error, by the law of unbiased estimates: time
times squared error is constant. Such figures are marked as extrapolated. `df` stops at a standard error
of 0.002 % daylight factor. For a point of 0.14 %, as behind leaves, this is 1.4 % of the value, so such
points do not reach an error of 0.4 %.
END
# shellcheck disable=SC2086 # several words, or none: all scenes
sh "$here/compare_radiance.sh" "$program" ${SCENES:-}
say compare_rpict.sh
cat <<'END'

## Against rpict

`bench/compare_rpict.sh` calculates one view of the deep office with `render` and with Radiance's
`rpict`, each on one processor. `rpict` has the expert settings above, with a sixteenth of the pixels in
the overture.
END
sh "$here/compare_rpict.sh" "$program"
