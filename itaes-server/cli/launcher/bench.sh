#!/usr/bin/env bash
# Lists the programs of tests/benchmarks and tests/faults, or runs one.
set -euo pipefail
home=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../.." && pwd)

programs() { find "$home/tests/benchmarks" "$home/tests/faults" -mindepth 2 -maxdepth 2 -name run -executable 2>/dev/null | sort; }

if [ $# -eq 0 ]; then
  programs | while read -r program; do
    printf '%-16s %s\n' "$(basename "$(dirname "$program")")" "$(sed -n '2s/^# *//p' "$program")"
  done
  exit 0
fi
name=$1
shift
program=$(programs | grep -E "/$(printf '%s' "$name" | sed 's/[^A-Za-z0-9_-]//g')/run$" || true)
if [ -z "$program" ]; then
  printf "sitaf: unknown program '%s'; './sitaf bench' lists them\n" "$name" >&2
  exit 2
fi
SITAF_HOME=$home exec "$program" "$@"
