#!/usr/bin/env bash
# CPU time of the scenes' steps, without drawing: median of three after a warm-up, one thread.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build}
echo "machine: $(sed -nE 's/^model name.*: //p' /proc/cpuinfo | head -1)"
printf '%-24s %-7s %10s %16s %10s\n' scene state particles "ms per second" "x real time"
for scene in assets/scenes/*.yaml; do
    for program in balloon balloon-double; do
        "$build/$program" run "$scene" --seconds 0.5 --quiet >/dev/null
        ms=$(for _ in 1 2 3; do
            "$build/$program" run "$scene" --seconds 2 --time --quiet |
                sed -nE 's/.*: ([0-9.]+) ms per simulated second/\1/p'
        done | sort -n | sed -n 2p)
        particles=$("$build/$program" run "$scene" --seconds 0.001 --mesh /dev/stdout --quiet | grep -c '^v ')
        awk -v scene="$(basename "$scene" .yaml)" -v state="${program#balloon}" -v n="$particles" -v ms="$ms" \
            'BEGIN { printf "%-24s %-7s %10d %16.3f %10.1f\n", scene, state == "" ? "float" : "double", n, ms, 1000 / ms }'
    done
done
# all timed benches, compared with the figures stored on this machine
"$build/balloon" bench --out out
# unneeded parts of every shipped scene
"$build/balloon" needs --all --quick --out out
# time of an advice for every shipped scene that names outputs: at most two minutes
printf '%-24s %8s  %s\n' scene "advice s" "within 8 ms a frame"
for scene in $("$build/balloon" needs | sed -nE 's/^([a-z][^ ]*) .* at .*/\1/p'); do
    start=$(date +%s)
    advice=$("$build/balloon" advise "$scene" --budget 8ms --fresh --report 2>&1 | sed -nE 's/^(says|balloon:) //p' | tail -1)
    printf '%-24s %8d  %s\n' "$scene" $(($(date +%s) - start)) "$advice"
done
