#!/usr/bin/env bash
# balloon stability, quick: its files, and that its cells agree with theory.
set -uo pipefail
cd "$(dirname "$0")/../.."
. tests/say.sh

"$balloon" stability --quick --out "$scratch/o" >"$scratch/table"
ok "it measures and draws" test $? = 0
ok "its table has a line for each limit" test "$(wc -l <"$scratch/table")" = "$(wc -l <"$scratch/o/stability.csv")"
ok "limits have their columns" grep -qx "scene,method,damping,step_measured,step_theory,step_bound" \
    <(head -1 "$scratch/o/stability.csv")
ok "maps have theirs" grep -qx "scene,method,step,stiffness,verdict,growth_rate" \
    <(head -1 "$scratch/o/map.csv")
for map in limit-springs limit-rubber; do
    ok "a picture of $map" test -s "$scratch/o/map-$map.svg" -a -s "$scratch/o/map-$map.png"
    ok "and what draws it again" env -C "$scratch/o" gnuplot "map-$map.gp"
done
ok "a panel without cells says why" grep -q "m eq 'xpbd' ? \"takes no force 'membrane'\"" \
    "$scratch/o/map-limit-rubber.gp"

# near its limit a stable mode of an undamped body beats by more than ten times (lab/stability/trial.c)
sides() {
    awk -F, -v cells="$1" 'FNR == 1 { next }
        FILENAME ~ /map-limit/ { theory[$1 $2 $3] = $4; next }
        { limit = theory[$1 $2 $4]; inside = limit == "inf" || $3 < 0.9 * limit
          if (inside && $5 != "stable" || !inside && $3 > 1.02 * limit && $5 == "stable") wrong++
          count++ }
        END { exit !(count > cells && wrong == 0) }' "$scratch/o/map-limit.csv" "$scratch/o/map.csv"
}
ok "cells are stable below the limit and not above it" sides 100
ok "limits are theory's" awk -F, 'NR > 1 && $5 != "inf" && $5 > 0 && ($4 / $5 < 0.98 || $4 / $5 > 1.02) { exit 1 }' \
    "$scratch/o/stability.csv"
ok "no folder is a fault" refuses 1 "cannot be made" "$balloon" stability --quick --out /proc/nothing/here
ok "so is a file" refuses 1 "cannot be written" "$balloon" stability --quick --out "$scratch/o/map.csv"

finish
