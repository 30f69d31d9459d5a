#!/usr/bin/env bash
# Runs the tests of a build folder in both precisions and adds up their results; with a WORD, those
# that have it in their name. JOBS programs run side by side, each one's output stays together.
# A test program is cmocka's, or a script that ends in "N passed, N failed".
#
#   run.sh BUILD [WORD]
#
# SHORT=1 omits tests that a slow build would only repeat (tests/README.md); PRECISIONS: float, double or
# both, as by default; JOBS: programs side by side.
set -uo pipefail
cd "$(dirname "$0")/.."
build=${1:-build}
word=${2:-}
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
export logs

# one NAME COMMAND…: run a test program; its log, status and CPU seconds stay in files
one() {
    local name=$1 file=$logs/${1//[ \/]/_} TIMEFORMAT='%U %S'
    shift
    { time "$@" >"$file.log" 2>&1 </dev/null; } 2>"$file.cpu"
    echo $? >"$file.status"
    tell "$name" "$file" "$(awk '{ printf "%.1f", $1 + $2 }' "$file.cpu")"
}

# tell NAME FILE CPU_SECONDS: print one line, or all of the test's output if anything failed
tell() {
    local ok bad status
    status=$(cat "$2.status")
    ok=$(sed -nE 's/^\[  PASSED  \] ([0-9]+) test.*/\1/p; s/^([0-9]+) passed, [0-9]+ failed$/\1/p' "$2.log" | tail -1)
    bad=$(sed -nE 's/^\[  FAILED  \] ([0-9]+) test.*/\1/p; s/^[0-9]+ passed, ([0-9]+) failed$/\1/p' "$2.log" | tail -1)
    ok=${ok:-0} bad=${bad:-0}
    {
        if [ "$status" != 0 ] || [ "$bad" != 0 ]; then
            cat "$2.log"
            [ "$bad" != 0 ] || bad=1
            echo "FAILED $1"
        elif [ "$ok" = 0 ]; then
            cat "$2.log"
            echo "FAILED $1: it ran no test"
            bad=1
        else
            echo "passed $1: $ok"
        fi
    } >"$2.said"
    echo "$ok $bad $3 $1" >"$2.sum"
    flock "$logs" cat "$2.said"
}
export -f one tell

# omitted by SHORT: long runs of code that other tests reach too
is_left_out() {
    [ -n "${SHORT:-}" ] || return 1
    case $1 in
        */test_scenes | */test_encounters | tests/cli/test_chart.sh | tests/cli/test_stability.sh) ;;
        *) return 1 ;;
    esac
    echo "left out $1: SHORT" | tee -a "$logs/left_out" >&2
}

shopt -s nullglob
{
    # the longest first, so that none runs alone at the end
    for script in tests/window/*"$word"*.sh tests/cli/*"$word"*.sh; do
        is_left_out "$script" || echo "$script bash $script $build"
    done
    for precision in ${PRECISIONS:-float double}; do
        for source in tests/unit/test_*"$word"*.c; do
            name=$(basename "$source" .c)
            is_left_out "$precision/$name" || echo "$precision/$name $build/$precision/tests/$name"
        done
    done
} | xargs -r -P "${JOBS:-2}" -L 1 bash -c 'one "$@"' _

echo "the longest, in CPU seconds of $(cat /dev/null "$logs"/*.sum | awk '{ s += $3 } END { printf "%.0f", s }'):"
sort -k3,3nr /dev/null "$logs"/*.sum | head -8 | awk '{ printf "  %6.1f  %s\n", $3, $4 }'
read -r passed failed < <(cat /dev/null "$logs"/*.sum | awk '{p += $1; f += $2} END {print p + 0, f + 0}')
if [ "$passed" = 0 ] && [ "$failed" = 0 ] && [ ! -e "$logs/left_out" ]; then
    echo "no test has '$word' in its name"
    failed=1
fi
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
