#!/usr/bin/env bash
# The README says what the program says: its keys, and a scene that loads.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh

sed -n '/^<!-- keys/,/^<!-- end of keys/p' README.md | grep '^      ' | sed 's/^    //' >"$scratch/readme"
"$build/balloon" --help | sed -n '/^keys$/,$p' | grep '^  ' >"$scratch/help"
ok "the README has every key" diff "$scratch/readme" "$scratch/help"

awk -v folder="$scratch" '/^```yaml$/ {n++; on = 1; next} /^```$/ {on = 0}
    on {print > (folder "/scene" n ".yaml")}' README.md
for scene in "$scratch"/scene*.yaml; do
    ok "the README's $(basename "$scene") loads and runs" "$build/balloon" run "$scene" --seconds 0.1 --quiet
done
for folder in src/*/; do
    ok "the README names $folder" grep -q "^| $(basename "$folder") |" README.md
done
for picture in $(sed -nE 's/^!\[.*\]\((.*)\)$/\1/p' README.md); do
    ok "the picture $picture is there" test -s "$picture"
done

finish
