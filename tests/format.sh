#!/usr/bin/env bash
# Every source is as clang-format 14 has it.
set -euo pipefail
cd "$(dirname "$0")/.."
clang-format --dry-run -Werror src/*.c src/*/*.[ch] src/*/*.[ch]pp tests/unit/*.[ch]
cmp src/.clang-format tests/.clang-format
echo "format: as clang-format has it"
