#!/usr/bin/env bash
# Out of memory: if allocation number k fails, the program ends with a sentence or goes on without it.
# A crash after a failed allocation by a library is listed only; one after the program's own allocation is a
# failure. Every 11th k; ALL=1 tries each.
set -u
cd "$(dirname "$0")/../.."
. tests/say.sh
ulimit -t 20 # no run takes a second
stride=11
[ -z "${ALL:-}" ] || stride=1

# the sanitizers have an allocator of their own
if nm "$balloon" 2>/dev/null | grep -q __asan_init; then
    ok "a sanitized program is left out" true
    finish
    exit
fi
cc -shared -fPIC -O1 -o "$scratch/fail.so" tests/cli/fail_malloc.c -ldl || exit 1
printf 'step: 0.001\nspheres: [{position: [0, 2, 0], radius: 0.5, mass: 1}]\nballoons: [{model: cube, skin: {springs: {structural: 50}}, mass: {per_particle: 0.001}}]\n' \
    >"$scratch/scene.yaml"
printf '# balloon input 1 scene\n1 key inflate down\n' >"$scratch/log"
command=("$balloon" run "$scratch/scene.yaml" --seconds 0.003 --set gravity=1 --set 'camera={eye: [1, 2, 3], look: [0, 0, 0]}'
    --input "$scratch/log" --record "$scratch/made.log" --csv "$scratch/made.csv" --hash)

# try K: how the run ends, and which code had requested the allocation
try() {
    { FAIL_AT=$1 LD_PRELOAD=$scratch/fail.so "${command[@]}" \
        9>"$scratch/asked" >"$scratch/out" 2>"$scratch/said"; } 2>/dev/null
    status=$?
    asked=$(head -1 "$scratch/asked")
}

tried=0 sentences=0 bad=0
: >"$scratch/library"
for ((k = 1; ; k += stride)); do
    try $k
    [ -n "$asked" ] || break # all allocations are made before the k-th
    tried=$((tried + 1))
    if [ $status = 0 ]; then
        continue
    elif [ $status -le 2 ] && grep -q '^balloon: ' "$scratch/said"; then
        sentences=$((sentences + 1))
    elif [[ $asked = */balloon* ]]; then
        echo "  allocation $k: exit $status: $(head -1 "$scratch/said")"
        bad=$((bad + 1))
    else
        basename "$asked" >>"$scratch/library"
    fi
done
echo "$tried places, $sentences with a sentence; a library's, which ends the program:"
sort "$scratch/library" | uniq -c
ok "allocations were tried" test $tried -gt 50
ok "the program's own end with a sentence" test $bad = 0
ok "there are sentences" test $sentences -gt 0
finish
