#!/usr/bin/env bash
# Fuzz each target from its corpus, by default for 60 s each, JOBS side by side. What breaks one is left
# in out/fuzz, to be mended and kept in the corpus.
#
#   fuzz.sh PROGRAM [SECONDS [TARGET…]]
set -uo pipefail
cd "$(dirname "$0")/../.."
export program=$1 seconds=${2:-60}
shift; shift
[ $# -gt 0 ] || set -- mesh scene input set command

# fuzz TARGET: the number of its runs, or what broke
fuzz() {
    local status=0
    mkdir -p "out/fuzz/$1"
    FUZZ_TARGET=$1 UBSAN_OPTIONS=print_stacktrace=1 "$program" -max_total_time="$seconds" -timeout=10 \
        -rss_limit_mb=2000 -max_len=4096 -print_final_stats=1 -artifact_prefix="out/fuzz/$1-" \
        "out/fuzz/$1" "tests/fuzz/corpus/$1" >"out/fuzz/$1.log" 2>&1 || status=1
    grep -E "^stat::number_of_executed|^==.*ERROR|runtime error|^SUMMARY" "out/fuzz/$1.log" | sed "s/^/fuzz $1: /"
    return $status
}
export -f fuzz
printf '%s\n' "$@" | xargs -P "${JOBS:-1}" -n 1 bash -c 'fuzz "$1"' _
