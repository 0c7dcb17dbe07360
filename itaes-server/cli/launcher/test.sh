#!/usr/bin/env bash
# Runs all tests. --fast: format, lint and unit tests only.
set -euo pipefail
home=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../.." && pwd)
state=$home/.sitaf
# shellcheck source=itaes-server/cli/launcher/setup.sh
source "$home/itaes-server/cli/launcher/setup.sh"

fast=false
[ "${1:-}" = --fast ] && fast=true
[ -d "$home/../shared" ] || echo "sitaf: no ../shared next to the source tree: tests that need it are skipped"

section() { printf '\n== %s (%d s)\n' "$1" "$SECONDS"; }

section "Simulation bridge: environment"
set_up_bridge
python=$state/venv/bin/python

if ! $fast && ! "$python" -c 'import example_robot_data' 2>/dev/null; then
  # The robots of examples/worlds: 131 MB, needed by tests only.
  "$python" -m pip install --quiet "$home/sim-bridge[robots]"
fi

section "Simulation bridge: format, lint, types, tests"
cd "$home/sim-bridge"
bash check.sh "$python"
if $fast; then "$python" -m pytest -q -m "not slow"; else "$python" -m pytest -q; fi

section "Runtime of Python tests: format, lint, types, tests"
cd "$home/tba-agent/runtime-python"
if newer_than "$state/runtime-python.stamp" "$home/tba-agent/runtime-python" "$home/proto"; then
  "$python" -m pip install --quiet --editable ".[dev]"
  touch "$state/runtime-python.stamp"
fi
bash check.sh "$python"
"$python" -m pytest -q

section "Runtime of C++ tests: format, tests"
bash "$home/tba-agent/runtime-cpp/check.sh"

section "Java and portal: format, lint, types, tests"
cd "$home"
if $fast; then
  mvn -B -ntp -q -T 2 verify -DexcludedGroups=slow -Dportal.check=check:changed -Dsitaf.bridge.python="$python"
  exit 0
fi
touch "$state/java.begun"
mvn -B -ntp -T 2 verify -Dsitaf.bridge.python="$python" | grep -vE '^\[INFO\] *$|Download(ing|ed)|Overwriting|already exists in destination|Copying .*\.jar'

# Install the tested build, so that the launcher does not build again.
locked
keep_java
unlocked

if ! "$python" -c 'import dateutil, playwright, pydantic, schemathesis, urllib3, xdist' 2>/dev/null; then
  # playwright drives Debian's Chromium; schemathesis sends requests generated from the OpenAPI document; xdist runs test
  # files in parallel. The server's Python client requires the others.
  "$python" -m pip install --quiet playwright==1.65.2 schemathesis==4.32.5 pytest-xdist==3.8.0 \
    pydantic==2.14.3 python-dateutil==2.9.0.post0 urllib3==2.8.0
fi

section "Across rooms: the wire of the simulator, and the launcher as a person uses it"
cd "$home/tests"
"$python" -m pytest -q -n 2 --dist loadfile --no-loadscope-reorder --durations 12
section "Done"
