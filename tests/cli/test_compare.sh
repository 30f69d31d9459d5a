#!/usr/bin/env bash
# Side by side: a ghost gets the same input, does not affect the scene, and its difference is printed.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh

last() { # last FILE COLUMN: in the last row
    awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i } END { print $c }' "$1"
}

printf '# balloon input 1 tether\n30 key inflate down\n200 key inflate up\n' >"$scratch/log"
alone=$("$balloon" run tether --seconds 0.5 --hash --quiet --input "$scratch/log")
for method in euler newton; do
    ok "a ghost by $method leaves the scene's bits" test "$alone" = "$("$balloon" run tether --seconds 0.5 --hash --quiet \
        --input "$scratch/log" --compare $method --csv "$scratch/$method.csv")"
done
ok "the same method with the same input goes the same way" near "$(last "$scratch/euler.csv" ghost.distance)" 0 0
ok "another does not quite" less 0 "$(last "$scratch/newton.csv" ghost.distance)"
ok "and costs" less 0 "$(last "$scratch/newton.csv" ghost.cost)"

# --- semi-implicit and backward Euler are both of order 1, and so is their difference
for step in 1e-4 5e-5; do
    "$double" run exact-cube --seconds 0.005 --step $step --compare newton --csv "$scratch/$step.csv" --fps 200
done
ok "order 1: half the step, half the distance" near \
    "$(awk -v a="$(last "$scratch/1e-4.csv" ghost.distance)" -v b="$(last "$scratch/5e-5.csv" ghost.distance)" 'BEGIN { print a / b }')" 2 0.1

ok "it is told in the end" grep -q "^newton is [0-9.e-]* off, for [0-9.e+]* ms per second against [0-9.e+]*" \
    <("$balloon" run tether --seconds 0.1 --compare newton)
still() { "$balloon" render fails/xpbd-early --seconds 1 --size 320x180 --quiet "$@"; }
still --out "$scratch/alone.png"
still --out "$scratch/both.png" --compare newton --set solver.iterations=5
ok "it is seen" less 0.005 "$(compare -metric RMSE "$scratch/alone.png" "$scratch/both.png" null: 2>&1 | sed -E 's/.*\((.*)\)/\1/')"
ok "a method that refuses the scene says so" refuses 1 "xpbd|springs" "$balloon" run peak --compare xpbd

finish
