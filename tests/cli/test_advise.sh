#!/usr/bin/env bash
# Advice: points are cached, a request is met or refused, and the result is a scene.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh
export XDG_CACHE_HOME=$scratch/cache

# --- the exact cube: its corners swing out to r(0.02), 35.105218866e-3 beyond sqrt(3); V = (2 r/sqrt 3)^3
truth=$(awk 'BEGIN { printf "%.17g", ((sqrt(3) + 0.035105218866) * 2 / sqrt(3)) ^ 3 }')
for error in 1% 0.1%; do
    ok "advice for $error" "$balloon" advise exact-cube --error $error --out "$scratch/cube.yaml"
    ok "says what is expected" grep -qE "^# .* at most [0-9.e-]+ % off, for [0-9.e-]+ ms" "$scratch/cube.yaml"
    got=$("$balloon" run "$scratch/cube.yaml" | sed -nE 's/^balloon0.volume at 0.02 s: //p')
    ok "is a scene within $error of the truth" near "$got" "$truth" "$(awk -v v="$truth" -v e="${error%\%}" 'BEGIN { print v * e / 100 }')"
done
ok "and keeps what it says of itself" grep -q "^title: The exact cube$" "$scratch/cube.yaml"
kept=$(ls "$scratch"/cache/balloon/advice-*.csv)
ok "one file is kept" test "$(wc -l <<<"$kept")" = 1
sum=$(md5sum <"$kept")
ok "numbers a little off are the same scene" "$balloon" advise exact-cube --budget 4ms --set balloons.0.inflation.amount=1.1 >/dev/null
ok "and measure nothing" test "$(md5sum <"$kept")" = "$sum"
if [ -z "${SHORT:-}" ]; then
    ok "--fresh measures again" "$balloon" advise exact-cube --budget 4ms --fresh >/dev/null
    ok "and keeps it" test "$(md5sum <"$kept")" != "$sum"
    ok "no cache, no harm" env -u HOME -u XDG_CACHE_HOME "$balloon" advise exact-cube --error 1% >/dev/null
fi
ok "--auto takes the advice" grep -q "volume at 0.02 s" <("$balloon" run exact-cube --auto --error 1% 2>/dev/null)

ok "--auto without an advice runs the scene as it is" test \
    "$("$balloon" run limit-springs --auto --seconds 0.01 --hash 2>"$scratch/said")" = "$("$balloon" run limit-springs --seconds 0.01 --hash)"
ok "and says why" grep -q "no advice: .*not about outputs" "$scratch/said"
bad "the best here is [0-9.e-]+ %, for [0-9.e-]+ ms" "$balloon" advise exact-cube --error 1e-12
bad "the best here is [0-9.e-]+ %, for [0-9.e-]+ ms" "$balloon" advise exact-cube --budget 1e-9ms
bad "not about outputs" "$balloon" advise limit-springs --error 1%
bad "what you ask for" "$balloon" advise exact-cube
bad "is not a number above 0, as in 4%" "$balloon" advise exact-cube --error lots
bad "cannot be written" "$balloon" advise exact-cube --error 1% --out /proc/nothing/here
ok "a program is told what to set" test "$("$balloon" advise exact-cube --error 1% --report | sed -n 's/^set \(method\|step\)=.*/\1/p' | paste -sd' ')" = "method step"
ok "and takes what comes nearest" grep -q "^says .* % off" <("$balloon" advise exact-cube --error 1e-12 --report)

# --- without a writable cache nothing is stored, and advice is given
env XDG_CACHE_HOME=/proc/nothing "$balloon" advise exact-cube --error 1% >"$scratch/unkept.yaml" 2>"$scratch/said"
ok "the answer is given" grep -q "^title: The exact cube$" "$scratch/unkept.yaml"
ok "and the reason is said" grep -q "not kept, and measured again next time" "$scratch/said"

# --- processes of an advice end with it, by any signal
for signal in TERM KILL; do
    "$balloon" advise party --budget 4ms --fresh >/dev/null 2>&1 &
    parent=$!
    child=
    while [ -z "$child" ] && kill -0 $parent 2>/dev/null; do child=$(pgrep -P $parent); done
    kill -$signal $parent
    wait $parent 2>/dev/null
    while [ -n "$child" ] && grep -q '^State:.[RSDT]' "/proc/$child/status" 2>/dev/null; do sleep 0.01; done
    ok "no run outlives it ($signal)" test -n "$child"
done

finish
