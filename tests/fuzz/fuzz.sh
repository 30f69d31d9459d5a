#!/usr/bin/env bash
# Fuzz each target from its corpus, by default for 60 s each. What breaks one is left in out/fuzz, to be
# mended and kept in the corpus.
#
#   fuzz.sh PROGRAM [SECONDS [TARGET…]]
set -u
cd "$(dirname "$0")/../.."
program=$1 seconds=${2:-60}
shift; shift
[ $# -gt 0 ] || set -- mesh scene input set command
bad=0
for target in "$@"; do
    mkdir -p "out/fuzz/$target"
    echo "fuzz $target"
    FUZZ_TARGET=$target UBSAN_OPTIONS=print_stacktrace=1 "$program" -max_total_time="$seconds" -timeout=10 \
        -rss_limit_mb=2000 -max_len=4096 -print_final_stats=1 -artifact_prefix="out/fuzz/$target-" \
        "out/fuzz/$target" "tests/fuzz/corpus/$target" >"out/fuzz/$target.log" 2>&1 || bad=1
    grep -E "^stat::number_of_executed|^==.*ERROR|runtime error|^SUMMARY" "out/fuzz/$target.log"
done
exit $bad
