# Common to the script tests: paths, counts of passed and failed checks, messages. Sourced from the
# root with the script's arguments, a build folder or none.
build=$(realpath "${1:-build}")
balloon=$build/balloon double=$build/balloon-double
scratch=$(mktemp -d)
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT
passed=0 failed=0

ok() { # ok "law" command…: the command succeeds
    local law=$1
    shift
    if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: $law"; fi
}

# near GOT WANT TOLERANCE
near() {
    awk -v got="$1" -v want="$2" -v tolerance="$3" 'BEGIN {
        off = got - want; if (off < 0) off = -off
        if (got == "" || !(off <= tolerance)) {
            printf "  got %.17g, want %.17g, tolerance %g\n", got, want, tolerance; exit 1 } }'
}

less() { # less A B: A < B
    awk -v a="$1" -v b="$2" 'BEGIN { if (!(a + 0 < b + 0)) { print "  " a " is not less than " b; exit 1 } }'
}

# refuses CODE "pattern" command…: exit CODE and exactly one line on stderr that matches
refuses() {
    local code=$1 pattern=$2 said status
    shift 2
    said=$("$@" 2>&1 >/dev/null </dev/null)
    status=$?
    if [ "$status" != "$code" ] || [ "$(printf '%s\n' "$said" | wc -l)" != 1 ] ||
        ! printf '%s' "$said" | grep -qE -- "$pattern"; then
        echo "  $*: exit $status, said: $said"
        return 1
    fi
}

bad() { ok "refuses: $*" refuses 1 "$1" "${@:2}"; } # bad "pattern" command…

finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" = 0 ]
}
