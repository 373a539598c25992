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

`bench/compare_radiance.sh`: the same rooms, written by `pepperpot export`, by Radiance's `rtrace`
and by `df --simulate`, each on one processor and in turn, in one run. `rtrace` runs as the
exported script has it (every path to its end, no cache), with paths cut short, with its cache at
settings in common use, and at ones that suit the scene: `-ar` is in terms of the scene's width,
which is that of its ground, so that 256 keeps records metres apart.

The error is that of the points' daylight factors: the root of the mean square of (found -
true)/true. What is true is the mean of eight fine runs of `df --simulate`, whose own noise, by how
far they are apart, is taken off. That all of ours might be off together is asked of a fine run of
`rtrace`: how far both references are apart in the mean stands above each table with its standard
error, and the error against that run, with its noise, beside the other. Equal errors are had by
the law of unbiased estimates, time times the square of the error; a run through the cache is
biased, so that it counts as it is, where its error is no larger. `df` leaves a point at a standard
error of 0.002 % daylight factor whatever is asked: one of 0.14 %, as there are behind leaves, at
1.4 % of it, so that an error of 0.4 % is not what it works for there.
END
# shellcheck disable=SC2086 # several words, or none: all scenes
sh "$here/compare_radiance.sh" "$program" ${SCENES:-}
say compare_rpict.sh
cat <<'END'

## Against rpict

`bench/compare_rpict.sh`: one view of the deep office by `render` and by Radiance's `rpict`, each
on one processor, with `rpict`'s cache at settings in common use and at ones that suit the scene.
END
sh "$here/compare_rpict.sh" "$program"
