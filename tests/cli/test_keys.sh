#!/usr/bin/env bash
# The scene reference equals the program's output, and its examples are valid scenes.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh

guide=assets/scenes/README.md
"$balloon" keys >"$scratch/printed"
sed '1,/^<!-- keys: made by balloon keys -->$/d; /^<!-- end of keys -->$/,$d' "$guide" >"$scratch/kept"
ok "the reference is what balloon keys prints; make reference writes it" \
    diff "$scratch/kept" "$scratch/printed"
ok "both programs print the same" diff "$scratch/printed" <("$double" keys)
ok "each row of a table has as many columns as its head" awk -F'|' '
    !/^\|/ {columns = 0; next} !columns {columns = NF} NF != columns {print; bad = 1}
    END {exit bad}' "$scratch/printed"
ok "no row is without a sentence" awk '/^\|.*\|  \|$/ {print; bad = 1} END {exit bad}' "$scratch/printed"

awk -v folder="$scratch" '/^```yaml$/ {n++; on = 1; next} /^```$/ {on = 0}
    on {print > (folder "/scene" n ".yaml")}' "$guide"
ok "there are two examples" test -s "$scratch/scene2.yaml"
for scene in "$scratch"/scene*.yaml; do
    ok "the guide's $(basename "$scene") loads and runs" "$balloon" run "$scene" --seconds 0.1 --quiet
done

# a wrong value for each key: the sentence names the option, and no line of the scene
elsewhere=0
for key in $(sed '/^### Outputs/,$d' "$scratch/printed" | sed -nE 's/^\| `([^`]+)`.*/\1/p' | sed 's/\*/0/g'); do
    said=$("$balloon" run tether --seconds 1e-9 --quiet --set gravity=9 --set "$key=[[x]]" 2>&1 >/dev/null)
    case $said in
        "balloon: --set $key=[[x]]: "*) ;;
        *) elsewhere=$((elsewhere + 1)); echo "  $key: $said" ;;
    esac
done
ok "the refusal of an override names the override" test $elsewhere = 0

finish
