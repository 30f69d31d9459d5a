#!/usr/bin/env bash
# Includes point one way: who may include whom, by the folders of src/. Judged on direct includes.
set -euo pipefail
cd "$(dirname "$0")/.."

declare -A may=(
    [base]="base"
    [mesh]="base mesh"
    [body]="base mesh body"
    [force]="base mesh body force"
    [solve]="base mesh body force solve"
    [correct]="base mesh body force correct"
    [collide]="base mesh body collide"
    [world]="base mesh body force solve correct collide world"
    [lab]="base mesh body force solve correct collide world lab"
    [view]="base mesh body world view"
    [draw]="base view draw"
    [hud]="base view hud"
    [show]="base world lab view draw hud show"
    [cli]="base mesh body force solve world lab view show cli"
)
# a library's folders, or the one file of a folder that may see it
declare -A library=(
    [assimp]="mesh" [cyaml]="world" [yaml.h]="world" [cglm]="view" [EGL]="draw" [GL/]="draw"
    [imgui]="hud" [GLFW]="show" [png.h]="show" [suitesparse]="solve/factor.c"
    [bt]="collide lab/peer.cpp" [Bullet]="collide lab/peer.cpp"
)

bad=0
for file in src/*/*.[ch] src/*/*.[ch]pp; do
    folder=$(basename "$(dirname "$file")")
    if [ -z "${may[$folder]:-}" ]; then
        echo "layers: src/$folder is not in the table"; bad=1; continue
    fi
    while read -r other; do
        case " ${may[$folder]} " in
            *" $other "*) ;;
            *) echo "layers: $file includes $other/, and $folder may include: ${may[$folder]}"; bad=1 ;;
        esac
    done < <(sed -nE 's|^#include "([a-z]+)/.*|\1|p' "$file")
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
