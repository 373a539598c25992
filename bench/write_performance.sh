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

Written by \`make bench\`, which wants a machine that does nothing else; do not edit. A rate or a
time says little elsewhere, a ratio more. Times are of the processor, all threads together,
unless they are said to be by the clock. What is \`wanted\` stands beside what was found.

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

`bench/compare_radiance.sh`: the same rooms, written by `pepperpot export`, by Radiance and by `df
--simulate`, each on one processor and in turn, in one run. Radiance runs in two ways. `rtrace`
follows every path to its end without a cache, as the exported script has it: nothing is shared
between points, and nothing is biased. And as an expert would run it: panes in parts of 0.3 m, whose
light `mkillum` gathers at low cost; plain materials; the ground beyond 60 m a glow; an overture and a
second pass with the same ambient file, with fine `-ds`. Its seconds are those of `mkillum` and of both
passes. Its cache is biased.

The error is that of the points' daylight factors: the root of the mean square of (found -
true)/true; beside it stands the mean of (found - true)/true, the bias where it is larger than the
noise. What is true is the mean of eight fine runs of `df --simulate`, whose own noise, by how
far they are apart, is taken off. That all of ours might be off together is asked of a fine run of
`rtrace`: how far both references are apart in the mean stands above each table with its standard
error, and the error against that run, with its noise, beside the other.

Below each table stands how many times as long Radiance takes. An expert's run counts as it was
measured, against the cheapest of ours that was measured with no larger an error. For runs without a
cache equal errors are had by the law of unbiased estimates, time times the square of the error; such
figures are marked as extrapolated, and from where. `df` leaves a point at a standard error of 0.002 %
daylight factor whatever is asked: one of 0.14 %, as there are behind leaves, at 1.4 % of it, so that an
error of 0.4 % is not what it works for there.
END
# shellcheck disable=SC2086 # several words, or none: all scenes
sh "$here/compare_radiance.sh" "$program" ${SCENES:-}
say compare_rpict.sh
cat <<'END'

## Against rpict

`bench/compare_rpict.sh`: one view of the deep office by `render` and by Radiance's `rpict`, each
on one processor, with `rpict` as an expert would run it (above), the overture with a sixteenth of the
pixels.
END
sh "$here/compare_rpict.sh" "$program"
