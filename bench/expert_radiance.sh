# expert_radiance.sh - Radiance as experts run it, for compare_radiance.sh and compare_rpict.sh:
# mkillum gathers the light on the panes, which are divided into parts; a first pass (the overture)
# fills an ambient file; a second pass with the same file gives the figures. In both passes the
# panes are sources.
# shellcheck shell=sh disable=SC2034 # variables are the other scripts'

expert_runs='coarse usual fine'
# expert RUN: sets $samples and $outside, the numbers of samples and the options of mkillum, and
# $inside, the options of both passes. $more: bounces outside that the scene needs beyond the usual
# ones (default: 0).
expert() {
    more=${more:-0}
    case $1 in
    coarse)
        samples='d=32 s=8' outside="-ab $((1 + more)) -ad 128 -aa 0.2 -ar 300"
        inside='-ab 5 -ad 512 -as 0 -aa 0.2 -ar 1000 -ds 0.05'
        ;;
    usual)
        samples='d=48 s=32' outside="-ab $((2 + more)) -ad 256 -aa 0.2 -ar 500"
        inside='-ab 6 -ad 1500 -as 0 -aa 0.2 -ar 2000 -ds 0.05'
        ;;
    fine)
        samples='d=64 s=64' outside="-ab $((3 + more)) -ad 512 -aa 0.15 -ar 1000"
        inside='-ab 8 -ad 4096 -as 0 -aa 0.2 -ar 4000 -ds 0.03'
        ;;
    esac
}

# divided FILE: the panes (parallelograms), divided into parts of at most 0.3 m.
divided() {
    awk -v size=0.3 '
        function corner(s, t, c) {
            return v[c] + s * (v[3 + c] - v[c]) + t * (v[9 + c] - v[c])
        }
        function parts(from, c, square) {
            for (c = 0; c < 3; c++) square += (v[from + c] - v[c]) ^ 2
            return int(sqrt(square) / size + 0.999)
        }
        $2 == "polygon" {
            material = $1; name = $3; k = 0
            getline; getline; getline
            for (count = $1; k < count;) {
                getline
                for (i = 1; i <= NF; i++) v[k++] = $i
            }
            m = parts(3); n = parts(9)
            for (i = 0; i < m; i++)
                for (j = 0; j < n; j++) {
                    printf "%s polygon %s.%d.%d\n0\n0\n12\n", material, name, i, j
                    for (q = 0; q < 4; q++) {
                        s = (i + (q == 1 || q == 2)) / m
                        t = (j + (q >= 2)) / n
                        printf " %.9g %.9g %.9g\n", corner(s, t, 0), corner(s, t, 1), corner(s, t, 2)
                    }
                }
        }' "$1"
}

# without WORD FILE: the file without the primitives of that type, which have four lines each.
without() {
    awk -v word="$1" '$2 == word { left_out = 4 } left_out-- > 0 { next } { print }' "$2"
}

# near_ground FILE: the ground as a disc with a radius of 60 m around the room, on which shadows
# fall; beyond the disc is the glow of the ground in the sky file. The distance of ambient records
# is proportional to the size of the scene: with a ground of 1,200 m there would be few records.
near_ground() {
    awk '$2 == "ring" { line = NR } line && NR == line + 3 { $NF = 60 } { print }' "$1"
}

# expert_scene: makes plain.oct of an exported scene, in its folder: plain materials, the far ground
# a glow, panes in parts; and to_illum.rad, the panes for mkillum.
expert_scene() {
    without mixfunc materials.rad >plain.rad
    sed 's/_sides / /' room.rad >plain_room.rad
    near_ground outside.rad >plain_outside.rad
    divided glazing.rad >panes.rad
    oconv plain.rad plain_room.rad panes.rad plain_outside.rad sky.rad >plain.oct
    { echo "#@mkillum m=window $samples"; cat panes.rad; } >to_illum.rad
    rm -f ambient
}

# expert_octree: makes illum.oct, with the panes that mkillum wrote to illum.rad.
expert_octree() {
    oconv plain.rad plain_room.rad illum.rad plain_outside.rad sky.rad >illum.oct
}
