#!/usr/bin/env bash
# Speed against accuracy: properties of the chart's numbers.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh

# pick FILE SCENE METHOD SKIN VERTICES STEP COLUMN: of the row in double
pick() {
    awk -F, -v scene="$2" -v method="$3" -v skin="$4" -v vertices="$5" -v step="$6" -v column="$7" '
        NR == 1 { for (i = 1; i <= NF; i++) if ($i == column) c = i }
        $1 == scene && $2 == method && $3 == skin && $5 == vertices && $6 + 0 == step + 0 &&
            $7 == "double" { print $c }' "$1"
}

ratio() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.6g", a / b }'; }

ok "a chart of one scene" "$balloon" chart exact-cube --quick --out "$scratch/cube" >"$scratch/said"
csv=$scratch/cube/chart.csv
ok "its columns" test "$(head -1 "$csv")" = \
    scene,method,skin,law,vertices,step,precision,ms_per_second,measured,truth,error,stable,hash
for file in chart.csv front.csv chart.md exact-cube.gp exact-cube.svg exact-cube.png; do
    ok "it leaves $file" test -s "$scratch/cube/$file"
done
ok "the summary is said too" diff <(tail -n +3 "$scratch/cube/chart.md") "$scratch/said"
ok "the machine is named" grep -q "^Measured on .*\(gcc\|clang\)" "$scratch/cube/chart.md"
ok "what was not tried is said" grep -qE "^Quick: [0-9]+ of the chart's [0-9]+ resolutions were tried" "$scratch/cube/chart.md"
bare=$(grep -cE "\| fell \|" "$scratch/cube/chart.md")
ok "no bare 'fell' of a peer that was tried in part" test "$bare" = 0
rm "$scratch/cube/exact-cube.svg"
ok "its script draws it again" env -C "$scratch/cube" gnuplot exact-cube.gp
ok "to the same file" test -s "$scratch/cube/exact-cube.svg"

# --- order 1 in time: the error halves with the step, but for its square's share of a tenth
for method in euler newton; do
    coarse=$(pick "$csv" exact-cube $method springs 8 1.25e-4 error)
    fine=$(pick "$csv" exact-cube $method springs 8 6.25e-5 error)
    ok "$method is of order 1 in time" near "$(ratio "$coarse" "$fine")" 2 0.2
done

# --- order 2 in space: a quarter at half the edge, but for its square's share
ok "a chart by its letter" "$balloon" chart b --quick --out "$scratch/gas" >/dev/null
csv=$scratch/gas/chart.csv
coarse=$(pick "$csv" sphere-gas euler membrane 162 4e-4 error)
fine=$(pick "$csv" sphere-gas euler membrane 642 2e-4 error)
ok "the membrane is of order 2 in space" near "$(ratio "$coarse" "$fine")" 4 0.3
ok "a step past the limit is marked" test "$(pick "$csv" sphere-gas euler membrane 162 0.02 stable)" = 0
ok "and has a cost" less 0 "$(pick "$csv" sphere-gas euler membrane 162 0.02 ms_per_second)"

# --- the same numbers, but for the times
ok "again" "$balloon" chart exact-cube --quick --out "$scratch/again" >/dev/null
ok "to the last bit" diff <(cut -d, -f 1-7,9- "$scratch/cube/chart.csv") <(cut -d, -f 1-7,9- "$scratch/again/chart.csv")

bad "no such scene" "$balloon" chart party --quick --out "$scratch/none"
bad "cannot be made" "$balloon" chart exact-cube --quick --out /proc/nothing/here
mkdir "$scratch/tools"
ok "without gnuplot the numbers are kept" refuses 1 "need gnuplot" env PATH="$scratch/tools" \
    "$balloon" chart exact-cube --quick --out "$scratch/plain"
ok "all of them" test "$(wc -l <"$scratch/plain/chart.csv")" = "$(wc -l <"$scratch/cube/chart.csv")"

finish
