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
    [contact]="base mesh body contact contact/skins contact/things"
    [contact/skins]="base mesh body contact contact/skins contact/things" [contact/things]="base mesh body contact/things"
    [solve]="base mesh body force constraint contact solve/multigrid solve"
    [scene]="base mesh body force solve contact scene"
    [world]="base mesh body force solve constraint contact contact/skins scene world"
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
    [show]="base world lab/run lab/truth lab/stability lab/advice lab/bench view draw hud show"
    [cli]="base mesh body force solve scene world lab/run lab/chart lab/stability lab/advice lab/bench lab/peer view show cli"
)
# the folders that may include a library, or the one file of a folder that may
declare -A library=(
    [assimp]="mesh" [yaml.h]="scene" [cglm]="view" [EGL]="draw" [GL/]="draw"
    [imgui]="hud" [GLFW]="show" [X11/]="show/display.c" [png.h]="show" [suitesparse]="solve/factor.c"
    [bt]="contact lab/peer/peer.cpp" [Bullet]="contact lab/peer/peer.cpp"
)

bad=0
for file in $(find src -mindepth 2 -name '*.[ch]' -o -mindepth 2 -name '*.[ch]pp' -o -mindepth 2 -name '*.inc'); do
    folder=$(dirname "${file#src/}")
    if [ -z "${may[$folder]:-}" ]; then
        echo "layers: src/$folder is not in the table"; bad=1; continue
    fi
    while read -r other; do
        case " ${may[$folder]} " in
            *" $other "*) ;;
            *) echo "layers: $file includes $other/, and $folder may include: ${may[$folder]}"; bad=1 ;;
        esac
    done < <(sed -nE 's|^#include "([a-z/]+)/[^/]+"|\1|p' "$file")
    for name in "${!library[@]}"; do
        grep -qE "^#include <$name" "$file" || continue
        case " ${library[$name]} " in
            *" $folder "* | *" ${file#src/} "*) ;;
            *) echo "layers: $file includes $name, which is for ${library[$name]}"; bad=1 ;;
        esac
    done
done
[ $bad = 0 ] && echo "layers: includes point one way"
exit $bad
