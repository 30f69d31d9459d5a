#!/usr/bin/env bash
# Every document agrees with the program: commands, options, keys, targets, paths, links and scenes in
# the README files are run or looked up.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh
root=$PWD
documents="README.md src/README.md src/lab/README.md assets/scenes/README.md tests/README.md"
"$balloon" --help >"$scratch/help"
"$balloon" list >"$scratch/list"
mkdir "$scratch/work" "$scratch/work/my"
cp assets/models/heart.obj "$scratch/work/my/mesh.obj"

# The words of a command, quotes taken off, in the array `words`; a comment ends it.
split() {
    local text
    text=$(sed -E 's/ +#.*//' <<<"$1")
    eval "words=($(sed 's/~/\\~/g; s/|/\\|/g' <<<"$text"))"
}

verb() { grep -qE "^  balloon $1 " "$scratch/help"; } # verb WORD: it is one

# parses WORD…: all options are known and have their values. The one that is not comes last.
parses() {
    local said
    said=$("$@" --no-such-option 2>&1 >/dev/null </dev/null)
    [ $? = 2 ] && grep -q -- "--no-such-option: no such option" <<<"$said" && return
    echo "  $*: $said"
    return 1
}

# runs PROGRAM WORD…: verbs that take minutes must name a scene or a bench that there is; the others run for a moment.
runs() {
    shift
    case " $* " in *" --auto "*) return ;; esac # it measures for minutes
    if ! verb "${1:-}"; then set -- play "$@"; fi
    case $1 in
        play) shift; (cd "$scratch/work" && "$balloon" run "$@" --seconds 0.02 --quiet >/dev/null) ;;
        run | render | peer) (cd "$scratch/work" && "$balloon" "$@" --seconds 0.02 --quiet >/dev/null) ;;
        check | list) (cd "$scratch/work" && "$balloon" "$@" >/dev/null) ;;
        *)
            case ${2:---} in
                --*) ;;
                *) grep -qE "^  ([A-Z] )?$2 " "$scratch/list" ;;
            esac ;;
    esac
}

try_command() { # try_command DOCUMENT run|parse TEXT
    local words
    split "$3"
    if ! command -v ffmpeg >/dev/null; then words=("${words[@]/%.mp4/.png}"); fi
    ok "$1: $3" parses "$balloon" "${words[@]:1}"
    [ "$2" = parse ] || ok "$1 runs: $3" runs "${words[@]}"
}

target() { # target NAME: make has it
    case $1 in
        build/*/tests/test_*) test -f "tests/unit/$(basename "$1").c" ;;
        *) sed -E '/^[a-z]/!d; s/:.*//' Makefile | tr ' ' '\n' | grep -qx -- "$1" ;;
    esac
}

there() { # there FOLDER PATH: as seen from the document's folder, from src/ or from the root
    compgen -G "$1/$2" >/dev/null || compgen -G "$2" >/dev/null || compgen -G "src/$2" >/dev/null
}

# Scenes first: commands may name them.
for document in $documents; do
    awk -v folder="$scratch/work" '/^```yaml$/ {n++; on = 1; next} /^```$/ {on = 0}
        on {print > (folder "/scene" n ".yaml")}' "$document"
    for scene in "$scratch"/work/scene*.yaml; do
        [ -f "$scene" ] || continue
        ok "$document: $(basename "$scene") loads and runs" "$balloon" run "$scene" --seconds 0.1 --quiet
        [ "$document" != README.md ] || cp "$scene" "$scratch/work/pear.yaml"
        rm "$scene"
    done
done

for document in $documents; do
    folder=$(dirname "$document")
    # code blocks by their four spaces, code spans by their backquotes
    grep -E '^    [^ ]' "$document" | sed 's/^ *//' >"$scratch/blocks"
    sed '/^```/,/^```/d; /^    /d' "$document" | tr '\n' ' ' | grep -oE '`[^`]+`' | tr -d '`' >"$scratch/spans"

    while read -r line; do
        case $line in
            balloon\ * | build/balloon*) try_command "$document" run "$line" ;;
            make\ *) ok "$document: make has ${line#make }" target "$(awk '{print $2}' <<<"$line")" ;;
        esac
    done <"$scratch/blocks"

    while read -r span; do
        case $span in
            balloon | balloon-double) ;;
            balloon\ --* | build/balloon\ --*) ok "$document: $span" "$balloon" ${span#* } >/dev/null ;;
            balloon\ * | build/balloon\ *) try_command "$document" parse "$span" ;;
            make\ *) ok "$document: make has $span" target "$(awk '{print $2}' <<<"$span")" ;;
            --[a-z]*) ok "$document: $span is an option" grep -qE -- "(^|, )  ?${span%% *}( |,|$)" "$scratch/help" ;;
            *[!A-Za-z0-9_./*-]*) ;;
            build/* | out/* | frame-*) ;;
            *.[ch] | *.cpp | *.inc | *.sh | *.md | */*.yaml | */) ok "$document: $span is there" there "$folder" "$span" ;;
        esac
    done <"$scratch/spans"

    for link in $(grep -oE '\]\([^)]+\)' "$document" | sed -E 's/^\]\((.*)\)$/\1/' | grep -v '^http'); do
        ok "$document links to $link" test -s "$folder/$link"
    done
done

# Keys: in the README the first column of the table of keys, elsewhere what follows "key" or "keys".
keys() {
    sed -nE '/^\| key \|/,/^$/ s/^\| (`[^|]*)\|.*/\1/p' "$1" | grep -oE '`[^`]+`' | tr -d '`'
    tr '\n' ' ' <"$1" | grep -oE "keys? (\`[^\`]+\`(, | and | )?)+" | grep -oE '`[^`]+`' | tr -d '`'
}
sed -n '/^keys$/,$p' "$scratch/help" | sed -nE 's/^  (.{11}) .*/\1/p' | sed 's/ *$//' >"$scratch/keys"
for document in $documents; do
    while read -r key; do
        ok "$document: '$key' is a key" grep -qxF -- "$key" "$scratch/keys"
    done < <(keys "$document")
done
ok "the README shows keys" test "$(keys README.md | wc -l)" -ge 12

ok "the README is one page" test "$(wc -l <README.md)" -le 100
for room in $(cd src && ls -d */ */*/ | sed 's,/$,,'); do
    case $room in
        lab/*) ok "src/lab/README.md names $room" grep -q "^| ${room#lab/} |" src/lab/README.md ;;
        *) ok "src/README.md names $room" grep -q "^| $room |" src/README.md ;;
    esac
done

finish
