#!/usr/bin/env bash
# Same input, same bits: two builds give the same state on every scene, in both precisions; the one
# with the kernels for this machine and one thread, the other with those for the plainest of its
# kind and two threads.
set -uo pipefail
cd "$(dirname "$0")/.."
one=$1 other=$2
bad=0 count=0
for scene in assets/scenes/*.yaml assets/scenes/fails/*.yaml; do
    for program in balloon balloon-double; do
        # the hash, or of a state that went bad the sentence: its step, particle and bound
        a=$("$one/$program" run "$scene" --seconds 1 --hash --quiet 2>&1 | tail -1)
        b=$(BALLOON_CPU=baseline "$other/$program" run "$scene" --seconds 1 --hash --quiet \
            --threads 2 2>&1 | tail -1)
        count=$((count + 1))
        if [ -z "$a" ] || [ "$a" != "$b" ]; then
            echo "bits: $program on $scene: $one says $a, $other says $b"
            bad=1
        fi
    done
done
[ $bad = 0 ] && echo "bits: $one and $other agree on $count runs"
exit $bad
