#!/usr/bin/env bash
# What scenes need: planted unneeded parts are found, and shipped scenes have none without a reason.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh

# unneeded FILE: the parts in needs.csv that are unneeded without a reason
unneeded() { awk -F, 'NR > 1 && $6 == 0 && $7 == "\"\"" { print $2 }' "$1" | sort | paste -sd' '; }

# --- four parts are planted: torsion without an effect, double, a fine mesh, a strain limit that no
# spring reaches
cat >"$scratch/planted.yaml" <<'YAML'
units: paper
step: 0.005
gravity: 0
precision: double
about: [{output: balloon0.volume, at: 1.5, tolerance: 0.01}]
balloons:
  - model: cube-sphere:8
    skin: {springs: {structural: 50, shear: 10, flexion: 10, torsion: 1e-5, law: hooke}}
    mass: {per_particle: 0.001}
    inflation: {law: area, amount: 6}
    strain_limit: {structural: 1}
    damping: {coefficient: 0.004}
YAML
ok "what is planted is said" refuses 1 "unneeded without a reason: torsion, strain_limit, mesh, precision$" \
    "$balloon" needs "$scratch/planted.yaml" --quick --out "$scratch/planted"
csv=$scratch/planted/needs.csv
ok "the columns" test "$(head -1 "$csv")" = scene,part,change,tolerance,cost_share,needed,because
ok "exactly the four" test "$(unneeded "$csv")" = "mesh precision strain_limit torsion"
ok "what the skin needs is needed" grep -qE ",shear,[0-9.]+,0.01,[0-9.]+,1," "$csv"
cut=(--set balloons.0.skin.springs.torsion=0 --set precision=float --set balloons.0.strain_limit=~)
coarse=(--set balloons.0.model=cube-sphere:4 --set balloons.0.mass.per_particle=0.004
    --set balloons.0.damping.coefficient=0.016 --set step=0.0045)
ok "without the others the mesh is named" refuses 1 "reason: mesh$" \
    "$balloon" needs "$scratch/planted.yaml" --quick "${cut[@]}"
ok "without all four nothing is" "$balloon" needs "$scratch/planted.yaml" --quick "${cut[@]}" "${coarse[@]}" >"$scratch/said"
ok "a reason holds" "$balloon" needs "$scratch/planted.yaml" --quick "${cut[@]}" \
    --set 'because=[{part: mesh, reason: it looks round}]' >"$scratch/said"
ok "and is said" grep -q "^mesh .* unneeded, but it looks round$" "$scratch/said"

# --- the shipped scenes
ok "every scene says what it is about" test "$("$balloon" needs | grep -c ' -$')" = 0
ok "failures are about none" test "$("$balloon" needs | grep -c '^fails/.* none: ')" = "$(ls assets/scenes/fails/*.yaml | wc -l)"
# `make bench` measures all of them; here the cheap ones, of every kind of skin
for scene in tether sphere-gas sewn-discs exact-cube; do
    ok "$scene models no more than it needs" "$balloon" needs $scene --quick >"$scratch/said-$scene"
done

# --- the sample in the lab's README equals the program's output, except for the CPU time
untimed() { sed -nE '/^ *tether$/,/^ *$/{ s/^    //; s/ +[0-9-]+ %  / /; /./p }' "$1"; }
ok "the README has the sample" grep -q "^    tether$" src/lab/README.md
ok "the README's sample is the program's" diff <(untimed src/lab/README.md) <(untimed "$scratch/said-tether")

# --- a verdict follows from the numbers beside it: "needed" has one of 1 or more, or a run that ended
follows() {
    awk '/ %  / { verdict = $0; sub(/.* %  /, "", verdict); line = substr($0, 56); sub(/ +[0-9-]+ %  .*/, "", line)
        n = split(line, change, " "); most = 0; none = 0
        for (k = 1; k <= n; k++) { if (change[k] == "-") none = 1; else if (change[k] + 0 > most) most = change[k] + 0 }
        bad = verdict ~ /^needed/ ? !none && most < 1 : verdict ~ /^untried/ ? !none : none || most >= 1
        if (bad) { print; wrong = 1 } lines++ } END { exit wrong || lines < 4 }' "$1"
}
for scene in tether sphere-gas sewn-discs exact-cube; do
    ok "$scene: verdicts follow from the changes" follows "$scratch/said-$scene"
done
ok "a step that the guard splits is untried" grep -qE "^step .* - .* untried: " "$scratch/said-tether"

bad "about none: of the bench" "$balloon" needs limit-springs
bad "does not say what it is about" "$balloon" needs cube
bad "no part 'helum'" "$balloon" needs tether --set 'because=[{part: helum, reason: none}]'
bad "balloon0.lift is no number" "$balloon" needs turtle --quick --set 'about=[{output: balloon0.lift, at: 0.1, tolerance: 0.1}]'
bad "about.0: |a scene is about outputs" "$balloon" run turtle --set 'about=[{output: balloon0.cy}]'
bad "cannot be made" "$balloon" needs tether --quick --out /proc/nothing/here

finish
