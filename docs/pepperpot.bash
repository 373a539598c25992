# pepperpot - completion for bash: commands, options, files. Commands and options
# are read from the program's own --help.
_pepperpot()
{
    local program=$1 word=$2 previous=$3 command=${COMP_WORDS[1]}
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        local commands
        commands=$("$program" --help 2>/dev/null | sed -n 's/^  \([a-z][a-z]*\) .*/\1/p')
        mapfile -t COMPREPLY < <(compgen -W "$commands --help --version" -- "$word")
    elif [ "$COMP_CWORD" -eq 2 ] && [ "$command" = new ]; then
        mapfile -t COMPREPLY < <(compgen -W 'office flat classroom attic' -- "$word")
    elif [ "$previous" = --format ] || [ "$previous" = -f ]; then
        local formats='text json csv'
        [ "$command" != compare ] || formats='text json'
        [ "$command" != chart ] || formats='pdf svg png'
        [ "$command" != report ] || formats='html pdf'
        [ "$command" != render ] || formats='hdr pfm png pdf svg'
        mapfile -t COMPREPLY < <(compgen -W "$formats" -- "$word")
    elif [ "$previous" = --to ] || [ "$previous" = --against ] ||
        { [ "$command" = export ] && [ "$previous" = -t ]; }; then
        mapfile -t COMPREPLY < <(compgen -W radiance -- "$word")
    elif [ "$command" = serve ] && [ "$previous" = --jobs ]; then
        mapfile -t COMPREPLY < <(compgen -d -- "$word")
    elif [ "$previous" = --which ]; then
        mapfile -t COMPREPLY < <(compgen -W 'average minimum rooflight' -- "$word")
    elif [ "$command" = size ] && { [ "$previous" = --change ] || [ "$previous" = -c ]; }; then
        mapfile -t COMPREPLY < <(compgen -W "width height head sill number" -- "$word")
    elif [ "$command" = render ] && { [ "$previous" = --view ] || [ "$previous" = -v ]; }; then
        local views='perspective parallel plan section hemispherical angular'
        mapfile -t COMPREPLY < <(compgen -W "$views" -- "$word")
    elif [ "$command" = render ] && [ "$previous" = --quantity ]; then
        mapfile -t COMPREPLY < <(compgen -W 'luminance illuminance df' -- "$word")
    elif [ "$command" = render ] && [ "$previous" = --exposure ]; then
        mapfile -t COMPREPLY < <(compgen -W 'auto human' -- "$word")
    elif [ "$previous" = --engine ]; then
        local engines='cache path plain'
        [ "$command" = render ] || engines='cache path path,cache path,plain photons plain radiosity'
        mapfile -t COMPREPLY < <(compgen -W "$engines" -- "$word")
    elif [ "$command" = render ] && [ "$previous" = --windows ]; then
        mapfile -t COMPREPLY < <(compgen -W 'stored aimed chance' -- "$word")
    elif [ "$command" = import ] && [ "$previous" = --lamps ]; then
        mapfile -t COMPREPLY < <(compgen -W 'aimed chance' -- "$word")
    elif [ "$command" = render ] && [ "$previous" = --filter ]; then
        mapfile -t COMPREPLY < <(compgen -W 'box gauss' -- "$word")
    elif [ "$command" = chart ] && [ "$previous" = --fill ]; then
        mapfile -t COMPREPLY < <(compgen -W 'none colour grey' -- "$word")
    elif [ "$previous" = --paper ]; then
        mapfile -t COMPREPLY < <(compgen -W 'a5 a4 a3 a2' -- "$word")
    elif [ "$previous" = --methods ] || [ "$previous" = -m ]; then
        local methods
        methods=$("$program" df --help 2>/dev/null |
            sed -n '/^Methods:/,$s/^  \([a-z][a-z-]*\) .*/\1/p')
        mapfile -t COMPREPLY < <(compgen -W "$methods" -- "$word")
    elif [ "$command" = assess ] && [ "$previous" = --for ]; then
        local profiles='uk-planning br209-2022 en17037 uk-dwellings breeam leed-v4.1 rights-of-light de-dwelling'
        profiles+=" $("$program" assess --rules -f csv 2>/dev/null | sed '1d; s/,.*//' | uniq | tr '\n' ' ')"
        mapfile -t COMPREPLY < <(compgen -W "$profiles" -- "$word")
    elif [ "$previous" = --state ]; then
        mapfile -t COMPREPLY < <(compgen -W 'existing proposed cumulative' -- "$word")
    elif [ "$previous" = --sky ]; then
        local skies
        skies="overcast uniform picture, $(printf 'iso-%d ' {1..15})"
        mapfile -t COMPREPLY < <(compgen -W "$skies" -- "$word")
    elif [ "$command" = assess ] && { [ "$previous" = --criteria ] || [ "$previous" = -c ]; }; then
        local criteria
        criteria=$("$program" assess --help 2>/dev/null |
            sed -n '/^Criteria:/,$s/^  \([a-z][a-z0-9-]*\) .*/\1/p')
        mapfile -t COMPREPLY < <(compgen -W "$criteria" -- "$word")
    elif [ "${word:0:1}" = - ]; then
        local options
        options=$("$program" "$command" --help 2>/dev/null |
            sed -n 's/^  \(-[a-z]*, \)* *\(--[a-z-]*\).*/\1\2/p' | tr ',' ' ')
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
    elif [ "$command" = chart ] && [ "$COMP_CWORD" -eq 2 ]; then
        local kinds
        kinds=$("$program" chart --list 2>/dev/null | sed -n 's/^  \([a-z][a-z-]*\) .*/\1/p')
        mapfile -t COMPREPLY < <(compgen -W "$kinds" -- "$word")
    fi
}
complete -o default -o filenames -F _pepperpot pepperpot
