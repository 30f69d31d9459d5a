#!/usr/bin/env bash
# Every source is formatted by clang-format 14.
set -euo pipefail
cd "$(dirname "$0")/.."
find src tests/unit -name "*.[ch]" -o -name "*.[ch]pp" | sort | xargs clang-format --dry-run -Werror
cmp src/.clang-format tests/.clang-format
echo "format: as clang-format has it"
