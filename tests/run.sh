#!/usr/bin/env bash
# Runs all tests of a build folder, both precisions, and adds up what they say.
# Each test program is cmocka's, or a script that ends in "N passed, N failed".
set -uo pipefail
cd "$(dirname "$0")/.."
build=${1:-build}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
passed=0 failed=0

# one: run a command, count its tests, show all it said if any failed
one() {
    local name=$1 ok bad status
    shift
    "$@" >"$log" 2>&1
    status=$?
    ok=$(sed -nE 's/^\[  PASSED  \] ([0-9]+) test.*/\1/p; s/^([0-9]+) passed, [0-9]+ failed$/\1/p' "$log" | tail -1)
    bad=$(sed -nE 's/^\[  FAILED  \] ([0-9]+) test.*/\1/p; s/^[0-9]+ passed, ([0-9]+) failed$/\1/p' "$log" | tail -1)
    ok=${ok:-0} bad=${bad:-0}
    if [ "$status" != 0 ] || [ "$bad" != 0 ]; then
        cat "$log"
        [ "$bad" != 0 ] || bad=1
        echo "FAILED $name"
    elif [ "$ok" = 0 ]; then
        cat "$log"
        echo "FAILED $name: it ran no test"
        bad=1
    else
        echo "passed $name: $ok"
    fi
    passed=$((passed + ok)) failed=$((failed + bad))
}

shopt -s nullglob
for precision in float double; do
    for source in tests/unit/test_*.c; do
        name=$(basename "$source" .c)
        one "$precision $name" "$build/$precision/tests/$name"
    done
done
for script in tests/cli/*.sh tests/window/*.sh; do
    one "$script" bash "$script" "$build"
done

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
