# tap.sh - for tests that are shell scripts: prints results in TAP.
#
#    . "$srcdir/tests/lib/tap.sh"
#    check "fact" command that succeeds if the fact is true, and prints the reason if not
#    skip "fact" "reason why it cannot be tested here"
#    tap_done

tap_count=0

check() {
    tap_count=$((tap_count + 1))
    tap_what=$1
    shift
    if tap_said=$("$@" 2>&1); then
        echo "ok $tap_count - $tap_what"
    else
        echo "not ok $tap_count - $tap_what"
        printf '%s\n' "$tap_said" | sed 's/^/# /'
    fi
}

skip() {
    tap_count=$((tap_count + 1))
    echo "ok $tap_count - $1 # SKIP $2"
}

tap_done() {
    echo "1..$tap_count"
}

# nothing TEXT: for check: succeeds if the text is empty, otherwise prints it.
nothing() {
    [ -z "$1" ] || {
        printf '%s\n' "$1"
        return 1
    }
}
