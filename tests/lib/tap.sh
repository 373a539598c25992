# tap.sh - for the tests that are shell scripts: says results in TAP.
#
#     . "$srcdir/tests/lib/tap.sh"
#     check "what holds" command that succeeds if it holds, and prints why not
#     skip "what holds" "why it cannot be looked at here"
#     tap_done

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

# For check: succeeds if there is nothing to say, and says it otherwise.
nothing() {
    [ -z "$1" ] || {
        printf '%s\n' "$1"
        return 1
    }
}
