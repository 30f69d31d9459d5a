#!/usr/bin/env bash
# The state of every scene by every method in both precisions, as a table of hashes: the same input
# gives the same bits with every compiler, kernel and number of threads, and the same as before.
#
#   hashes.sh check BUILD       compare all runs with tests/golden/hashes.csv
#   hashes.sh check-own BUILD   only each scene by its own method
#   hashes.sh touch BUILD       for a build with sanitizers: each scene by its own method in float for
#                               0.05 s, without a table; a sanitizer's message is a failure
#   hashes.sh renew BUILD       write the table anew, after a change of bits on purpose
#
# A scene runs for 1 s by its own method, or 0.3 s by Newton's, whose steps depend on all
# particles of the last one; for 0.02 s by each other method. THREADS: threads of each run, 1; JOBS:
# runs side by side.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=$1
export build=$2 THREADS=${THREADS:-1}
golden=tests/golden/hashes.csv
now=$(mktemp)
trap 'rm -f "$now" "$now".*' EXIT

# one SCENE METHOD PRECISION SECONDS: print its row
one() {
    printf '%s,%s,%s,%s,%s\n' "$1" "$2" "$3" "$4" "$("$build/$3/state_hash" "$1" "$2" "$4" "$THREADS" 2>/dev/null || echo failed)"
}
export -f one

# touch SCENE: the scene may be refused or halt, but without a message of a sanitizer
touch_scene() {
    "$build/balloon" run "$1" --seconds 0.05 --threads 2 --hash --quiet 2>&1 >/dev/null | grep -E -A 20 'Sanitizer|runtime error' || return 0
    echo "hashes: a sanitizer stopped $1"
    return 1
}
export -f touch_scene
if [ "$mode" = touch ]; then
    printf '%s\n' assets/scenes/*.yaml assets/scenes/fails/*.yaml |
        xargs -P "${JOBS:-2}" -n 1 bash -c 'touch_scene "$1"' _
    echo "hashes: no sanitizer stops a scene of $build"
    exit
fi

# every run: SCENE METHOD PRECISION SECONDS
runs() {
    local scene method own precision seconds
    for scene in assets/scenes/*.yaml assets/scenes/fails/*.yaml; do
        own=$(sed -nE 's/^method: *([a-z]+).*/\1/p' "$scene")
        for method in $(sed -nE 's/^    \.name = "([a-z]+)",$/\1/p' src/solve/*.c); do
            [ "$method" != "${own:-euler}" ] && [ "$mode" = check-own ] && continue
            for precision in float double; do
                seconds=0.02
                [ "$method" = "${own:-euler}" ] && seconds=1
                [ "$seconds $method" = "1 newton" ] && seconds=0.3
                echo "$scene $method $precision $seconds"
            done
        done
    done
}

runs | xargs -P "${JOBS:-2}" -L 1 bash -c 'one "$@"' _ | LC_ALL=C sort >"$now"
if [ "$mode" = renew ]; then
    cp "$now" $golden
    echo "hashes: $(wc -l <$golden) rows in $golden"
    exit
fi
if [ "$mode" = check-own ]; then grep -E ',(1|0\.3),[^,]*$' $golden >"$now.golden"; else cp $golden "$now.golden"; fi
if ! diff "$now.golden" "$now"; then
    echo "hashes: $build differs from $golden in the rows above (< golden, > now)"
    exit 1
fi
echo "hashes: $build agrees with $golden on $(wc -l <"$now") runs"
