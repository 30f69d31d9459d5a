#!/usr/bin/env bash
# Rules for the sources beside the compiler's warnings: sizes, one meaning for a name, includes
# without a circle, comments that name existing files, a fixed top level.
#
#   structure.sh BUILD    a build with the programs in it; prints the sizes
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build}
bad=0
fault() { echo "structure: $1"; bad=1; }
mapfile -t sources < <(find src -name '*.[ch]' -o -name '*.[ch]pp' | sort)

# --- sizes: clang-format puts the brace that opens a function and the one that ends it at the margin
function_limit=60 file_limit=365 room_limit=3000
functions=$(awk 'FNR == 1 { start = 0 }
    !start && /^[A-Za-z][^=;]*\(.*[^;]$|^[A-Za-z].*\($/ { start = FNR }
    /^};|^[^ ].*;$/ { start = 0 }
    /^}$/ && start { print FNR - start + 1, FILENAME ":" start; start = 0 }' "${sources[@]}" | sort -n)
files=$(wc -l "${sources[@]}" | grep -v ' total$' | sed 's/^ *//' | sort -n)
rooms=$(echo "$files" | awk '{ n = $1; sub(/\/[^\/]*$/, "", $2); lines[$2] += n }
    END { for (r in lines) print lines[r], r }' | sort -n)
# size NAME LIST LIMIT
size() {
    local count longest
    count=$(echo "$2" | wc -l)
    longest=$(echo "$2" | tail -1)
    printf '%-10s %5d, median %4d lines, longest %s\n' "$1" "$count" \
        "$(echo "$2" | sed -n "$(((count + 1) / 2))p" | cut -d' ' -f1)" "$longest"
    [ "$count" -gt 20 ] || fault "found only $count $1"
    [ "${longest%% *}" -le "$3" ] || fault "$1: more than $3 lines: $longest"
}
size functions "$functions" $function_limit
size files "$files" $file_limit
size tests "$(wc -l tests/unit/*.[ch] | grep -v ' total$' | sed 's/^ *//' | sort -n)" $file_limit
size folders "$rooms" $room_limit

# --- no static function or variable has the name of a global one
globals=$(nm "$build/float/libballoon.a" 2>/dev/null | awk 'NF == 3 && $2 ~ /^[TDBR]$/ { print $3 }' | sort -u)
[ -n "$globals" ] || fault "$build has no library to read the global names from"
statics=$(sed -nE 's/^static ([^=;(]*[ *])?([A-Za-z_0-9]+)(\(|\[| =|;).*/\2/p' "${sources[@]}" | sort -u)
for name in $(comm -12 <(echo "$globals") <(echo "$statics")); do
    fault "static $name has a global's name: $(grep -lE "^static .*\b$name\b" "${sources[@]}" | tr '\n' ' ')"
done

# --- no circle between headers
circle=$(for header in "${sources[@]}"; do
    [[ $header == *.h ]] || continue
    sed -nE "s|^#include \"([^\"]+)\".*|${header#src/} \1|p" "$header"
done | tsort 2>&1 >/dev/null | sed -n 2,8p | tr "\n" " " || true)
[ -z "$circle" ] || fault "headers include each other in a circle: $circle"

# --- a comment that names a file names one that exists: by its path in the tree, in src/ or tests/
while IFS=: read -r file line path; do
    for at in "$path" "src/$path" "tests/$path" "tests/unit/$path" "assets/$path" "$(dirname "$file")/$path"; do
        [ -e "$at" ] && continue 2
    done
    fault "$file:$line names $path, and there is no such file"
done < <(grep -noE '(//|^ *\*|/\*).*' "${sources[@]}" tests/unit/*.[ch] |
    sed -nE ':a; s|^([^:]+:[0-9]+):.*[^a-z_0-9/<.]([a-z_0-9]+(/[a-z_0-9]+)+\.(h\|c\|cpp\|sh\|md\|yaml))\b.*|\1:\2|p')

# ... or, without a folder, the name of a file of the tree, or of one that the program writes
declare -A exists=([chart.md]=1)
while read -r name; do exists[$name]=1; done < <(git ls-files 2>/dev/null | sed 's|.*/||')
while IFS=: read -r file line name; do
    [ ${#exists[@]} = 1 ] || [ -n "${exists[$name]:-}" ] || fault "$file:$line names $name, and there is no such file"
done < <(grep -noE '(//|^ *\*|/\*).*' "${sources[@]}" tests/unit/*.[ch] |
    sed -nE 's#^([^:]+:[0-9]+):(.*[^A-Za-z_0-9/.*])?([a-z][a-z_0-9]*\.(h|c|cpp|sh|md|yaml))\b.*#\1:\3#p')

# --- the top level
for entry in $(git ls-files 2>/dev/null | cut -d/ -f1 | sort -u); do
    case $entry in
        Makefile | src | shaders | assets | tests | README.md | LICENSE | .*) ;;
        *) fault "$entry does not belong at the top level" ;;
    esac
done

[ $bad = 0 ] && echo "structure: sizes, names, includes, comments and the top level are in order"
exit $bad
