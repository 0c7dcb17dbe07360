#!/usr/bin/env bash
# Runs the tests except long ones. --all: long ones too. --fast: format, lint and unit tests only.
set -euo pipefail
home=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../.." && pwd)
state=$home/.sitaf
# shellcheck source=itaes-server/cli/launcher/setup.sh
source "$home/itaes-server/cli/launcher/setup.sh"

fast=false
without="long"
case "${1:-}" in
  "") ;;
  --fast) fast=true without="slow long" ;;
  --all) without="" ;;
  *)
    echo "sitaf: error: test: unknown option '$1': expected --fast, --all or nothing" >&2
    exit 2
    ;;
esac
# The tags as Maven and as pytest expect them.
java_groups=(-DexcludedGroups="${without// /,}")
python_marks=()
[ -z "$without" ] || python_marks=(-m "not (${without// / or })")
[ -d "$home/../shared" ] || echo "sitaf: no ../shared next to the source tree: tests that need it are skipped"

section() { printf '\n== %s (%d s)\n' "$1" "$SECONDS"; }

section "Simulation bridge: environment"
set_up_bridge
python=$state/venv/bin/python

if ! $fast && ! "$python" -c 'import example_robot_data' 2>/dev/null; then
  # The robots of examples/worlds: 131 MB, needed by tests only.
  "$python" -m pip install --quiet "$home/sim-bridge[robots]"
fi

bridge_tests() {
  bash "$home/hardware/python/check.sh" "$python"
  cd "$home/sim-bridge"
  bash check.sh "$python"
  "$python" -m pytest -q "${python_marks[@]}"
}

runtime_tests() {
  cd "$home/tba-agent/runtime-python"
  bash check.sh "$python"
  "$python" -m pytest -q "${python_marks[@]}"
  # Compiling the tests takes half a minute: the fast check does it only after a change.
  local stamp=$state/runtime-cpp-checked.stamp
  if ! $fast || newer_than "$stamp" "$home/tba-agent/runtime-cpp" "$home/tests/compliance"; then
    touch "$stamp.begun"
    bash "$home/tba-agent/runtime-cpp/check.sh"
    mv "$stamp.begun" "$stamp"
  fi
}

cd "$home/tba-agent/runtime-python"
if newer_than "$state/runtime-python.stamp" "$home/tba-agent/runtime-python" "$home/proto"; then
  "$python" -m pip install --quiet --editable ".[dev]"
  touch "$state/runtime-python.stamp"
fi

# These run while Maven compiles and tests, because many tests wait for other processes.
alongside=("bridge_tests:Simulation bridge: format, lint, types, tests" "runtime_tests:Runtimes of Python and C++ tests: format, lint, types, tests")
mkdir -p "$state/log"
pids=()
for entry in "${alongside[@]}"; do
  (set -e; "${entry%%:*}") >"$state/log/${entry%%:*}.log" 2>&1 &
  pids+=($!)
done
trap 'for pid in "${pids[@]}"; do pkill -P "$pid" || true; done' EXIT

# await_alongside: prints the output of these tests when they have ended, and fails if one has failed.
await_alongside() {
  local failed=false
  for i in "${!pids[@]}"; do
    wait "${pids[$i]}" || failed=true
    section "${alongside[$i]#*:}"
    cat "$state/log/${alongside[$i]%%:*}.log"
  done
  pids=()
  ! $failed
}

section "Java and portal: format, lint, types, tests"
cd "$home"
if $fast; then
  mvn -B -ntp -q -T 2 verify "${java_groups[@]}" -Dportal.check=check:changed -Dsitaf.bridge.python="$python"
  await_alongside
  exit 0
fi
touch "$state/java.begun"
# The agent's tests and the launcher compile the same runtime of C++ applications, which takes a minute.
compiled=$home/tba-agent/agent/target/test-cache/cpp/runtime
[ ! -d "$state/cache/cpp/runtime" ] || [ -d "$compiled" ] || { mkdir -p "$compiled" && cp -r "$state/cache/cpp/runtime/." "$compiled"; }
mvn -B -ntp -T 2 verify "${java_groups[@]}" -Dsitaf.bridge.python="$python" | grep -vE '^\[INFO\] *$|Download(ing|ed)|Overwriting|already exists in destination|Copying .*\.jar'

# Install the tested build, so that the launcher does not build again.
locked
keep_java
unlocked

[ ! -d "$compiled" ] || [ -d "$state/cache/cpp/runtime" ] || { mkdir -p "$state/cache/cpp/runtime" && cp -r "$compiled/." "$state/cache/cpp/runtime"; }
await_alongside

if ! "$python" -c 'import dateutil, playwright, pydantic, pymodbus, schemathesis, urllib3, xdist' 2>/dev/null; then
  # playwright drives Debian's Chromium; schemathesis sends requests generated from the OpenAPI document; xdist runs test
  # files in parallel; pymodbus connects the servo drive of examples/modbus-joint. The server's Python client requires the others.
  "$python" -m pip install --quiet playwright==1.65.2 schemathesis==4.32.5 pytest-xdist==3.8.0 \
    pydantic==2.14.3 python-dateutil==2.9.0.post0 urllib3==2.8.0 pymodbus==3.16.1
fi

section "Across rooms: the wire of the simulator, and the launcher as a person uses it"
cd "$home/tests"
"$python" -m pytest -q -n 2 --dist loadfile --no-loadscope-reorder --durations 12 "${python_marks[@]}"
section "Done"
