#!/usr/bin/env bash
# Includes point one way: which folder of src/ may include which. Direct includes are checked.
set -euo pipefail
cd "$(dirname "$0")/.."

declare -A may=(
    [base]="base"
    [mesh]="base mesh mesh/shapes" [mesh/shapes]="base mesh mesh/shapes"
    [body]="base mesh body"
    [force]="base mesh body force"
    [solve/multigrid]="base mesh force solve/multigrid"
    [constraint]="base mesh body force constraint"
    [contact/bullet]="base contact contact/bullet"
    [contact]="base mesh body contact contact/bullet contact/skins contact/things"
    [contact/skins]="base mesh body contact contact/bullet contact/skins contact/things" [contact/things]="base mesh body contact/things"
    [solve]="base mesh body force constraint contact solve/multigrid solve/joints solve/batch solve"
    [solve/batch]="base mesh body solve/batch"
    [solve/joints]="base mesh body contact contact/things solve solve/joints"
    [scene]="base mesh body force solve contact scene" [scene/keys]="base force solve scene"
    [world]="base mesh body force solve constraint contact contact/skins scene world world/guard world/things world/knots"
    [world/guard]="base mesh body force solve scene world world/guard"
    [world/things]="base mesh force contact contact/skins contact/things scene world world/things"
    [world/knots]="base scene world world/things world/knots"
    [lab/run]="base mesh scene world lab/run"
    [lab/truth]="base mesh force world lab/truth"
    [lab/peer]="base mesh force contact world lab/run lab/peer"
    [lab/chart]="base mesh body solve world lab/run lab/truth lab/chart"
    [lab/stability]="base force world lab/run lab/stability"
    [lab/advice]="base mesh force scene world lab/run lab/advice"
    [lab/bench]="base body force solve contact scene world lab/run lab/truth lab/peer lab/advice lab/bench"
    [view]="base mesh body force scene world view"
    [draw]="base view draw"
    [hud]="base view hud"
    [show]="base world lab/run lab/truth lab/stability lab/advice lab/bench view draw hud show show/film"
    [show/film]="base show/film"
    [cli]="base mesh body force contact/skins solve scene world lab/run lab/chart lab/stability lab/advice lab/bench lab/peer view show show/film cli"
)
# the folders that may include a library, or the one file of a folder that may
declare -A library=(
    [assimp]="mesh" [yaml.h]="scene" [cglm]="view" [EGL]="draw" [GL/]="draw"
    [imgui]="hud" [GLFW]="show" [X11/]="show/display.c" [png.h]="show/film" [suitesparse]="solve/factor.c"
    [bt]="contact/bullet lab/peer/peer.cpp" [Bullet]="contact/bullet lab/peer/peer.cpp"
)

# may_include FILE FOLDER OTHER
may_include() {
    case " ${may[$2]:-} " in
        *" $3 "*) ;;
        *) echo "layers: $1 includes $3/, and $2 may include: ${may[$2]:-}"; bad=1 ;;
    esac
}

# may_see FILE FOLDER HEADER: a library's header, or the C library's
may_see() {
    local name
    for name in "${!library[@]}"; do
        [[ $3 == "$name"* ]] || continue
        case " ${library[$name]} " in
            *" $2 "* | *" ${1#src/} "*) ;;
            *) echo "layers: $1 includes $name, which is for ${library[$name]}"; bad=1 ;;
        esac
    done
}

bad=0
for folder in $(find src -mindepth 2 \( -name '*.[ch]' -o -name '*.[ch]pp' -o -name '*.inc' \) -printf '%P\n' |
    sed 's|^src/||; s|/[^/]*$||' | sort -u); do
    [ -n "${may[$folder]:-}" ] || { echo "layers: src/$folder is not in the table"; bad=1; }
done
while IFS=: read -r file line; do
    folder=${file#src/}
    folder=${folder%/*}
    if [[ $line =~ ^\#include\ \"([a-z/]+)/[^/]+\" ]]; then
        may_include "$file" "$folder" "${BASH_REMATCH[1]}"
    elif [[ $line =~ ^\#include\ \<([^\>]+)\> ]]; then
        may_see "$file" "$folder" "${BASH_REMATCH[1]}"
    fi
done < <(find src -mindepth 2 \( -name '*.[ch]' -o -name '*.[ch]pp' -o -name '*.inc' \) -exec grep -H '^#include' {} +)
[ $bad = 0 ] && echo "layers: includes point one way"
exit $bad
