#!/usr/bin/env bash
# Checks format and tests of the runtime with the tools of this machine. Tests with the simulator are in tests/ of the project.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
if ! command -v g++ >/dev/null || [ ! -e /usr/include/doctest/doctest.h ] || [ ! -e /usr/include/expat.h ]; then
  echo "skipped: needs './sitaf doctor --install cpp' and apt-get install -y doctest-dev"
  exit 0
fi
if command -v clang-format >/dev/null; then
  find include src tests -name '*.?pp' -print0 | xargs -0 clang-format --dry-run --Werror
fi
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
g++ -std=c++17 -O0 -Wall -Wextra -Werror -Iinclude -Isrc "-DSITAF_COMPLIANCE=\"$PWD/../../tests/compliance\"" tests/*.cpp src/suite/*.cpp src/simulation/passing_time.cpp src/runtime/watched_ports.cpp -lexpat -pthread -o "$build/tests"
"$build/tests"
