#!/usr/bin/env bash
# Reads the commands of `make -Bn` and prints them as a compilation database.
set -euo pipefail
cd "$(dirname "$0")/.."
sed -nE 's/^ *(gcc|g\+\+|clang|clang\+\+|cc) (.* -c ([^ ]+) -o .*)$/\1 \2\t\3/p' | awk -F'\t' -v folder="$PWD" '
    BEGIN { print "[" }
    { gsub(/\\/, "\\\\", $1); gsub(/"/, "\\\"", $1)
      printf "%s{\"directory\": \"%s\", \"file\": \"%s\", \"command\": \"%s\"}", comma, folder, $2, $1; comma = ",\n" }
    END { print "\n]" }'
