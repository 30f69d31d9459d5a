#!/usr/bin/env bash
# The command line: verbs, numbers, files, and one sentence for each kind of bad input.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh
is_double=0

column() { # column FILE NAME ROW: a CSV's value
    awk -F, -v name="$2" -v row="$3" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i }
        NR == row + 2 { print $c }' "$1"
}

usage() { ok "refuses usage: $*" refuses 2 "$1" "${@:2}"; }

# --- the doctor
for n in 2 3 7 12; do
    out=$("$balloon" check cube-sphere:$n)
    ok "cube-sphere of $n: structural springs" grep -qx "structural springs: $((12 * n * n))" <<<"$out"
    ok "cube-sphere of $n: shear springs" grep -qx "shear springs: $((12 * n * n))" <<<"$out"
    ok "cube-sphere of $n: flexion springs" grep -qx "flexion springs: $((12 * n * n - 12))" <<<"$out"
done
if [ -f ../shared/meshes/spot_quads.obj ]; then
    out=$("$balloon" check ../shared/meshes/spot_quads.obj)
    ok "spot has 2930 vertices" grep -qx "vertices: 2930" <<<"$out"
    ok "spot has 2928 quads" grep -q "^faces: 2928 (2928 quads, 0 triangles)" <<<"$out"
    ok "spot is closed" grep -qx "boundary edges: 0" <<<"$out"
fi
for model in assets/models/*.obj; do
    out=$("$balloon" check "$model")
    ok "$model is closed and all quads" grep -qE "^faces: ([0-9]+) \(\1 quads, 0 triangles\)" <<<"$out"
    ok "$model has no rim" grep -qx "boundary edges: 0" <<<"$out"
    quads=$(sed -nE 's/^faces: ([0-9]+) .*/\1/p' <<<"$out")
    # the largest of the thin-shell paper's has 15,505 vertices
    ok "$model has 400 to 16,000 quads" test "$quads" -ge 400 -a "$quads" -le 16000
done
ok "one model has 11,000 quads" test "$(for m in assets/models/*.obj; do "$balloon" check "$m"; done |
    sed -nE 's/^faces: ([0-9]+) .*/\1/p' | sort -n | tail -1)" -ge 10900

# --- the exact cube: corner radius r from the volume (2 r / sqrt 3)^3
radius() { awk -v v="$1" 'BEGIN { printf "%.17g", v ^ (1 / 3) * sqrt(3) / 2 }'; }
"$double" run exact-cube --csv "$scratch/cube.csv" --fps 200
r=$(radius "$(column "$scratch/cube.csv" balloon0.volume 40)")
ok "exact cube after 2,000 steps" near "$r" 1.77769353863185 1e-12
for case in "2e-4 1.8610e-3" "1e-4 9.2498e-4" "5e-5 4.6116e-4"; do
    set -- $case
    "$double" run exact-cube --step "$1" --csv "$scratch/cube.csv" --fps 200 --seconds 0.005
    r=$(radius "$(column "$scratch/cube.csv" balloon0.volume 1)")
    error=$(awk -v r="$r" 'BEGIN { e = r - sqrt(3) - 0.0647575094287; print e < 0 ? -e : e }')
    ok "exact cube's error at step $1" near "$error" "$2" 6e-8
done
"$balloon" run exact-cube --csv "$scratch/cube.csv" --fps 200
r=$(radius "$(column "$scratch/cube.csv" balloon0.volume 40)")
ok "exact cube in float, 2,000 roundings of 6e-8" near "$r" 1.77769353863185 2e-5
ok "precision hands over to the sibling" test "$("$balloon" run exact-cube --precision double --hash)" \
    = "$("$double" run exact-cube --hash)"

# --- CSV, OBJ, hash
"$balloon" run tether --csv "$scratch/t.csv" --seconds 1 --fps 7 --mesh "$scratch/t.obj"
ok "a row a frame and one for the start" test "$(wc -l <"$scratch/t.csv")" = 9
ok "row k is after floor(k / (fps step)) steps" near "$(column "$scratch/t.csv" t 3)" 0.428 1e-12
ok "the OBJ has the model's vertices" test "$(grep -c '^v ' "$scratch/t.obj")" = 386
ok "the OBJ is a mesh again" grep -qx "vertices: 386" <("$balloon" check "$scratch/t.obj")

# --- earlier names of keys and options: read, with a sentence
sed -e 's/strain_limit:/correction:/' -e 's/max:/most:/' assets/scenes/turtle-corrected.yaml >"$scratch/old.yaml"
ok "a scene with earlier names is the same to the bit" test "$("$balloon" run "$scratch/old.yaml" --seconds 0.1 --hash 2>"$scratch/said")" \
    = "$("$balloon" run turtle-corrected --seconds 0.1 --hash)"
ok "and the present names are said in one line" test "$(cat "$scratch/said")" \
    = "balloon: $scratch/old.yaml: keys have new names: most is now max, correction is now strain_limit"
ok "an option's earlier name is read" refuses 0 "^balloon: --obj is now --mesh$" \
    "$balloon" run tether --seconds 0.01 --quiet --obj "$scratch/old.obj"
ok "and does the same" test -s "$scratch/old.obj"

a=$("$balloon" run party --seconds 1 --hash)
ok "same input, same bits" test "$a" = "$("$balloon" run party --seconds 1 --hash --fps 13 --quiet)"
ok "other input, other bits" test "$a" != "$("$balloon" run party --seconds 1 --hash --set balloons.0.inflation.amount=3)"
printf '# balloon input 1 party\n30 key inflate down\n200 key inflate up\n210 key reset down\n' >"$scratch/log"
ok "a log replays" test "$("$balloon" run party --seconds 1 --input "$scratch/log" --hash)" = \
    "$("$balloon" run party --seconds 1 --input "$scratch/log" --hash)"
ok "a log's reset starts again" test "$("$balloon" run party --seconds 0.62 --input "$scratch/log" --hash)" = \
    "$("$balloon" run party --seconds 0.2 --hash)"
ok "a session's log is written" "$balloon" run party --seconds 1 --input "$scratch/log" --record "$scratch/log2" --quiet
ok "and holds the same events" diff <(grep -v '^#' "$scratch/log") <(grep -v '^#' "$scratch/log2")
ok "rendering keeps the bits" test "$("$balloon" render party --seconds 0.2 --size 64x36 --out "$scratch/a.png" --hash --quiet | tail -1)" = \
    "$("$balloon" run party --seconds 0.2 --hash)"
ok "another working folder finds scenes and models" env -C / "$balloon" run party --seconds 0.01
ok "list names every scene" test "$("$balloon" list | grep -c -E "$(ls -1 assets/scenes/*.yaml | xargs -n1 basename -s .yaml | paste -sd'|')")" -ge "$(ls assets/scenes/*.yaml | wc -l)"
ok "help walks the keys" grep -q "inflate while held" <("$balloon" --help)
ok "version says the precision" grep -q double <("$double" --version)

# folder for the figures that benches store
export XDG_CACHE_HOME=$scratch/cache
ok "a bench counts what passes through" grep -qE "^ +384 +1[0-9] +0 +0 .* of +1[0-9]$" <("$balloon" bench contacts --quick)
ok "a bench times what contacts cost" grep -qE "^16 touching +\| +16 " <("$balloon" bench contact-cost --quick --out "$scratch/bench")
"$balloon" bench speed --quick --out "$scratch/bench" >"$scratch/speed"
ok "a bench says what a step costs" grep -qE "^membrane +11096  per triangle +[0-9.]+ " "$scratch/speed"
ok "and writes it down" grep -qE "^springs,11096,step,us,[0-9.]+,[0-9.]+,0$" "$scratch/bench/bench-speed.csv"
if [ -z "${SHORT:-}" ]; then
    ok "and keeps it to compare with" grep -qE "^springs +11096  touched .* 1.000$" \
        <("$balloon" bench speed --quick --out "$scratch/bench")
    ok "a bench makes a row of the paper's table" grep -qE "^holes.obj +5896  to 1e-6 +[0-9.]+ " \
        <("$balloon" bench table1 --quick --only holes --out "$scratch/bench")
    ok "no step of a scene is wrong under the guard" grep -qE "^[0-9]+ cells, 0 of them WRONG$" <("$balloon" bench guard --quick)
    ok "a bench says where a frame's time goes" grep -qE "^party +9850  resolve +[0-9.]+ " \
        <("$balloon" bench frame --quick --out "$scratch/bench")
    ok "a bench plays at random, the same twice" grep -qE "^party +2 +[0-9]+ +[1-9]" <("$balloon" bench soak --quick --only party --out "$scratch/bench")
fi
ok "no value of a scene makes it end wrongly" grep -qE "^[0-9]+ scenes: .* 0 WRONG$" <("$balloon" bench scenes --quick)
ok "and a scene of the storm can be seen alone" grep -qE "^  balloon run .* --set=" <("$balloon" bench scenes --only 2)
ok "rubber without area has a volume" test "$("$balloon" run fails/stvk-collapse --set balloons.0.skin.membrane.young=4.3e-6 --seconds 0.3 --fps 10 --quiet --csv - | grep -c nan)" = 0
bad "coordinates are at most" "$balloon" run launch-1 --set balloons.0.scale=7e16
bad "is not a seed" "$balloon" bench scenes --only x
bad "no such bench" "$balloon" bench nothing

# --- an install
make -s -o all BUILD="$build" PREFIX="$scratch/usr" install >/dev/null
ok "an installed program finds its scenes" env -C / "$scratch/usr/bin/balloon" run party --seconds 0.01

# --- bad input: one sentence, exit 1 (2 for wrong usage), nothing half-written
cube='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n'
: >"$scratch/empty.obj"
head -c 3000 /dev/urandom >"$scratch/binary.obj"
printf "${cube}v 1 nan 0\nf 1 2 3 4\n" >"$scratch/nan.obj"
printf "${cube}v 1 inf 0\nf 1 2 3 4\n" >"$scratch/inf.obj"
printf "${cube}f 1 2 3 9\n" >"$scratch/index.obj"
printf "${cube}f 1\n" >"$scratch/one.obj"
printf "${cube}f 1 2\n" >"$scratch/two.obj"
printf "${cube}v 0 2 0\nf 1 2 3 4 5\n" >"$scratch/five.obj"
# two tetrahedra, one through the other; the fourth face of the first crosses the first of the second
printf 'v %s\n' '0 0 0' '1 0 0' '0 1 0' '0 0 1' '0.2 0.2 -0.5' '1.2 0.2 -0.5' '0.2 1.2 -0.5' '0.2 0.2 0.5' >"$scratch/through.obj"
printf 'f %s\n' '1 3 2' '1 2 4' '1 4 3' '2 3 4' '5 7 6' '5 6 8' '5 8 7' '6 7 8' >>"$scratch/through.obj"
ok "check counts and names the triangles that cross" grep -qE "^crossing pairs of triangles: [1-9][0-9]*, the first of faces [1-4] and [5-8]$" <("$balloon" check "$scratch/through.obj")
ok "a shape crosses nothing" grep -qx "crossing pairs of triangles: 0" <("$balloon" check torus:24x12)
bad "nowhere.obj" "$balloon" check "$scratch/nowhere.obj"
bad "empty.obj.*empty" "$balloon" check "$scratch/empty.obj"
bad "binary.obj" "$balloon" check "$scratch/binary.obj"
bad "nan.obj:5: " "$balloon" check "$scratch/nan.obj"
bad "inf.obj:5: " "$balloon" check "$scratch/inf.obj"
bad "index.obj:5: " "$balloon" check "$scratch/index.obj"
bad "one.obj:5: " "$balloon" check "$scratch/one.obj"
bad "two.obj:5: " "$balloon" check "$scratch/two.obj"
bad "five.obj:6: .*5 corners" "$balloon" check "$scratch/five.obj"
mkdir "$scratch/folder.obj"
bad "folder.obj" "$balloon" check "$scratch/folder.obj"
if [ "$(id -u)" != 0 ]; then
    cp assets/models/pillow.obj "$scratch/closed.obj"
    chmod 0 "$scratch/closed.obj"
    bad "closed.obj" "$balloon" check "$scratch/closed.obj"
fi
bad "grid.* is open.*needs a closed" "$balloon" run grid --set balloons.0.inflation.law=gas
bad "helum" "$balloon" run party --set balloons.0.helum=3
bad "no method|method 'magic'" "$balloon" run party --method magic
bad "step" "$balloon" run party --step -1
bad "step" "$balloon" run party --step nan
bad "per_particle" "$balloon" run party --set balloons.0.mass.per_particle=0
bad "nowhere" "$balloon" run nowhere
printf 'units: paper\nstep: 0.002\nballoons:\n  - model: cube\n    helum: 3\n' >"$scratch/key.yaml"
bad "key.yaml:5: .*helum" "$balloon" run "$scratch/key.yaml"
printf 'units: paper\nstep: 0.002\nballoons:\n  - model: cube\n    mass: {per_particle: -1}\n' >"$scratch/range.yaml"
bad "range.yaml:5: " "$balloon" run "$scratch/range.yaml"
printf 'units: paper\nstep: [\n' >"$scratch/yaml.yaml"
bad "yaml.yaml:[0-9]+: " "$balloon" run "$scratch/yaml.yaml"
printf '# balloon input 1 party\n30 key dance down\n' >"$scratch/bad.log"
bad "bad.log:2: " "$balloon" run party --input "$scratch/bad.log"
# what a world cannot set is found before the first step, whenever it is due
while read -r set words; do
    printf '# balloon input 1 party\n0 set gravity 1\n99999999 set %s\n' "${set/=/ }" >"$scratch/bad.log"
    bad "bad.log:3: ${set%=*}: $words" "$balloon" run party --seconds 0.01 --input "$scratch/bad.log"
done <<'END'
gravity=much 'much' is not a number
gravity=nan 'nan' is not a number
gravity=1e39 1e39 is out of range
balloons.77.damping.rate=1 there are balloons 0 to
balloons.-1.damping.rate=1 there are balloons 0 to
balloons.0.damping.rate=-1 must be
damping.rate=-1 must be
balloons.0.model=1 cannot be set while a scene runs
step=1 cannot be set while a scene runs
END
bad "cannot be written" "$balloon" run party --csv /proc/nothing/here.csv
bad "cannot be written" "$balloon" run party --seconds 0.1 --mesh /proc/nothing/here.obj
bad "/proc/nothing" "$balloon" render party --out /proc/nothing/here
bad "number" "$balloon" run party --seconds soon
bad "size" "$balloon" render party --size 12by9
bad "mode" "$balloon" render party --mode x-ray --out "$scratch/m"
bad "display" env -u DISPLAY -u WAYLAND_DISPLAY "$balloon" party
bad "EGL" env __EGL_VENDOR_LIBRARY_DIRS=/nonexistent "$balloon" render party --seconds 0.1 --out "$scratch/e"
usage "no such option" "$balloon" run party --color red
usage "needs a value" "$balloon" run party --seconds
usage "^balloon: --csv: needs a value: FILE" "$balloon" run party --csv ""
usage "if 'rendr' is to be a verb, there is none" "$balloon" rendr party
bad "'8x8' is not a size .*; each side is 16 to 16384" "$balloon" render party --size 8x8
usage "only one" "$balloon" run party tether
bad "went bad in step" "$balloon" run fails/long-step
# --- numbers out of the state's range, and counts out of an integer's
bad "^balloon: --set .*young is 1e39, which is out of range in a state of float" \
    "$balloon" run pear --set balloons.0.skin.membrane.young=1e39
bad "per_particle is 1e-50, which is out of range" "$balloon" run party --set balloons.0.mass.per_particle=1e-50
bad "radius is 1e-20, which is out of range in a state of float" "$balloon" run launch-1 --set spheres.0.radius=1e-20
bad "floor is 1e30, which is out of range in a state of float" "$balloon" run party --set floor=1e30
bad "mass is 3.4e38, which is out of range in a state of float" "$balloon" run launch-1 --set spheres.0.mass=3.4e38
ok "double holds them" "$balloon" run party --seconds 0.002 --precision double --quiet --set balloons.0.inflation.rate=1e39
bad "at 1e\+06 m a state of float resolves 0.12 m" "$balloon" run pear --set 'balloons.0.position=[1e6,0,0]'
for bound in "--seconds 1e30" "--fps 1e30" "--seconds 1e12 --fps 1e12" "--set seconds=1e18"; do
    bad "more (steps .*)?than can be counted" "$balloon" run cube $bound
done

# --- bytes that are not UTF-8: paths are bytes, scenes are text
latin=$(printf '\xe4')
cp assets/models/pillow.obj "$scratch/$latin.obj"
cp assets/scenes/tether.yaml "$scratch/$latin.yaml"
ok "a mesh with such a name" "$balloon" run "$scratch/$latin.obj" --seconds 0.01 --quiet
ok "a scene with such a name" "$balloon" run "$scratch/$latin.yaml" --seconds 0.01 --quiet
bad "there is no such scene or mesh" "$balloon" run "$latin"
bad "no key '$latin'" "$balloon" run cube --set "$latin=1"
bad "not YAML" "$balloon" run cube --set "gravity=$latin"
bad "cannot be written as YAML" "$balloon" advise "$scratch/$latin.obj" --error 10%

# --- a fault of an override names the override, and not a line that the user did not write
bad "^balloon: --set balloons.0.inflation.law=gas: .*grid is open" \
    "$balloon" run grid --set gravity=1 --set balloons.0.inflation.law=gas --set floor=-9
bad "^balloon: --compare foo: no method 'foo'" "$balloon" run tether --compare foo
bad "^balloon: --step -1: " "$balloon" run tether --step=-1
bad "^balloon: --method xpbd: " "$balloon" run pear --method xpbd
sed 's/step: .*/step: 5/' assets/scenes/tether.yaml >"$scratch/step.yaml"
bad "step.yaml:[0-9]+: step must be" "$balloon" run "$scratch/step.yaml" --set gravity=1

# --- other files are replaced only with --overwrite
kept() { test "$(cat "$1")" = kept; }
for file in kept.csv kept.obj kept.log kept.png kept.mp4; do echo kept >"$scratch/$file"; done
bad "kept.csv is there and not made by balloon" "$balloon" run cube --csv "$scratch/kept.csv"
bad "kept.obj is there and not made by balloon" "$balloon" run cube --mesh "$scratch/kept.obj"
bad "kept.log is there and not made by balloon" "$balloon" run cube --record "$scratch/kept.log"
for file in kept.png kept.mp4; do
    bad "$file is there and not made by balloon" "$balloon" render cube --out "$scratch/$file"
done
for file in kept.csv kept.obj kept.log kept.png kept.mp4; do ok "$file stays" kept "$scratch/$file"; done
small=(--seconds 0.05 --size 32x18 --quiet)
for file in kept.png kept.mp4 own.gif own.webm own; do
    ok "$file with --overwrite" "$balloon" render cube "${small[@]}" --out "$scratch/$file" --overwrite
    ok "its own $file without" "$balloon" render cube "${small[@]}" --out "$scratch/$file"
done
echo kept >"$scratch/own/frame-00001.png"
bad "frame-00001.png is there" "$balloon" render cube --out "$scratch/own"
mkdir "$scratch/results"
for file in needs.csv chart.csv stability.csv map.csv bench-contacts.csv; do echo kept >"$scratch/results/$file"; done
for verb in "needs tether" "chart --quick" "stability --quick" "bench contacts --quick"; do
    bad "results/[a-z-]+.csv: is there and not made by balloon" "$balloon" $verb --out "$scratch/results"
done
bad "kept.log is there and not made by balloon" "$balloon" advise tether --error 1% --out "$scratch/kept.log"
ok "results of others stay" test "$(cat "$scratch"/results/* | sort -u)" = kept
rm -r "$scratch/results"
bad "log is read by this command" "$balloon" run party --input "$scratch/log" --record "$scratch/log"
bad "^balloon: --record: .*/both is written by --csv, too" "$balloon" run cube --csv "$scratch/both" --record "$scratch/./both"
bad "^balloon: --out: .*/both.png is written by --record, too" "$balloon" render cube --record "$scratch/both.png" --out "$scratch/both.png"
ok "two results to a device" "$balloon" run cube "${small[@]::2}" --csv /dev/null --mesh /dev/null
bad "t.obj is read by this command" "$balloon" run "$scratch/t.obj" --mesh "$scratch/t.obj"

# --- a run of a scene without outputs says that it ended, unless an output was requested
ok "a run says that it ended" grep -qE "^cube: 0.01 s simulated; --report, " <("$balloon" run cube --seconds 0.01)
ok "so does one that ends before its outputs" grep -q "^assets/scenes/tether.yaml: 0.01 s simulated; " <("$balloon" run tether --seconds 0.01)
ok "and nothing else beside a result" test "$("$balloon" run cube --seconds 0.01 --hash | wc -l)" = 1

# the guard's substeps: one message for people, a number for programs
"$balloon" run tether --seconds 0.1 --step 0.02 --report >"$scratch/report" 2>"$scratch/said"
ok "the guard says into how many parts" grep -qE "step 0.02 s is above the largest stable one, [0-9.]+ s: each is made in 8 parts$" "$scratch/said"
ok "and reports them" grep -qE "^report ended=1 steps=5 .* substeps=8 hash=[0-9a-f]{16}" "$scratch/report"
ok "nothing was half-written" test ! -e "$scratch/m" -a ! -e "$scratch/e"
"$balloon" run fails/long-step --csv "$scratch/f.csv" 2>/dev/null
ok "rows up to the bad state are kept" test "$(wc -l <"$scratch/f.csv")" -ge 2

finish
