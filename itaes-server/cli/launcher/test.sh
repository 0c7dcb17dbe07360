#!/usr/bin/env bash
# Runs the tests except long ones. --all: long ones too. --fast: format, lint and unit tests only.
# A failure does not stop the other tests; the summary at the end lists the failed and the skipped ones.
set -euo pipefail
home=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../.." && pwd)
state=$home/.sitaf
launcher=$home/itaes-server/cli/launcher
# shellcheck source=itaes-server/cli/launcher/setup.sh
source "$launcher/setup.sh"

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

# Reports of all tests in JUnit's format, for the summary.
reports=$state/reports
rm -rf "$reports"
mkdir -p "$reports" "$state/log"
touch "$reports/begun"
# What failed, one line each.
failed=()

section "Simulation bridge: environment"
set_up_bridge
python=$state/venv/bin/python

if ! $fast && ! "$python" -c 'import importlib.metadata as m; m.distribution("example-robot-data")' 2>/dev/null; then
  # The robots of examples/worlds: 131 MB, needed by tests only.
  "$python" -m pip install --quiet "$home/sim-bridge[robots]"
fi

# Nodes run with it, too. PyPI does not have it for each machine and Python.
$fast || (set_up_installed_ros) || echo "sitaf: ROS 2 cannot be installed here: tests that need it are skipped"

# tests_of REPORT FOLDER [OPTION...]: runs the tests of a folder.
tests_of() {
  cd "$2"
  "$python" -m pytest -q --junitxml "$reports/$1.xml" "${python_marks[@]}" "${@:3}"
}

bridge_tests() {
  local code=0
  bash "$home/hardware/python/check.sh" "$python" || code=1
  bash "$home/sim-bridge/check.sh" "$python" || code=1
  (tests_of bridge "$home/sim-bridge") || code=1
  return $code
}

runtime_tests() {
  local code=0
  bash "$home/tba-agent/runtime-python/check.sh" "$python" || code=1
  (tests_of runtime-python "$home/tba-agent/runtime-python") || code=1
  # Compiling the tests takes half a minute: the fast check does it only after a change.
  local stamp=$state/runtime-cpp-checked.stamp
  if ! $fast || newer_than "$stamp" "$home/tba-agent/runtime-cpp" "$home/tests/compliance"; then
    touch "$stamp.begun"
    if bash "$home/tba-agent/runtime-cpp/check.sh"; then mv "$stamp.begun" "$stamp"; else code=1; fi
  fi
  return $code
}

if newer_than "$state/runtime-python.stamp" "$home/tba-agent/runtime-python" "$home/proto"; then
  (cd "$home/tba-agent/runtime-python" && "$python" -m pip install --quiet --editable ".[dev]")
  touch "$state/runtime-python.stamp"
fi

# These run while Maven compiles and tests, because many tests wait for other processes.
alongside=("bridge_tests:Simulation bridge: format, lint, types, tests" "runtime_tests:Runtimes of Python and C++ tests: format, lint, types, tests")
pids=()
for entry in "${alongside[@]}"; do
  ("${entry%%:*}") >"$state/log/${entry%%:*}.log" 2>&1 &
  pids+=($!)
done
trap 'for pid in "${pids[@]}"; do pkill -P "$pid" || true; done' EXIT

# await_alongside: prints the output of these tests when they have ended.
await_alongside() {
  for i in "${!pids[@]}"; do
    wait "${pids[$i]}" || failed+=("${alongside[$i]#*:}")
    section "${alongside[$i]#*:}"
    cat "$state/log/${alongside[$i]%%:*}.log"
  done
  pids=()
}

# end: prints the summary and ends; the exit code is 1 if anything failed.
end() {
  section "Summary"
  "$python" "$launcher/summarize_tests.py" "$home" "$reports" || failed+=("Tests: see above")
  if [ ${#failed[@]} -gt 0 ]; then
    printf 'FAILED: %s\n' "${failed[@]}"
    exit 1
  fi
  echo "All tests passed."
  exit 0
}

section "Java and portal: format, lint, types, tests"
cd "$home"
touch "$state/java.begun"
java=(mvn -B -ntp -T 2 --fail-at-end verify -Dmaven.test.failure.ignore=true "${java_groups[@]}" -Dsitaf.bridge.python="$python")
log=$state/log/java_tests.log
if $fast; then
  "${java[@]}" -q -Dportal.check=check:changed 2>&1 | tee "$log" || failed+=("Java and portal: the build")
else
  # The agent's tests and the launcher compile the same runtime of C++ applications, which takes a minute.
  compiled=$home/tba-agent/agent/target/test-cache/cpp/runtime
  [ ! -d "$state/cache/cpp/runtime" ] || [ -d "$compiled" ] || { mkdir -p "$compiled" && cp -r "$state/cache/cpp/runtime/." "$compiled"; }
  "${java[@]}" 2>&1 | tee "$log" | grep -vE '^\[INFO\] *$|Download(ing|ed)|Overwriting|already exists in destination|Copying .*\.jar' ||
    failed+=("Java and portal: the build")
fi
built=true
[ ${#failed[@]} -eq 0 ] || built=false
# Maven's own words, because its exit code is only that of the build.
! grep -qE 'There are test failures|There was a timeout' "$log" || failed+=("Java: tests")

if $fast; then
  await_alongside
  end
fi
if ! $built; then
  await_alongside
  failed+=("Across rooms: not run, because there is no build")
  end
fi

# Install the tested build, so that the launcher does not build again.
locked
keep_java
unlocked
set_up_archives

[ ! -d "$compiled" ] || [ -d "$state/cache/cpp/runtime" ] || { mkdir -p "$state/cache/cpp/runtime" && cp -r "$compiled/." "$state/cache/cpp/runtime"; }
await_alongside

if ! "$python" -c 'import dateutil, playwright, pydantic, pymodbus, schemathesis, urllib3, xdist' 2>/dev/null; then
  # playwright drives Debian's Chromium; schemathesis sends requests generated from the OpenAPI document; xdist runs test
  # files in parallel; pymodbus connects the servo drive of examples/modbus-joint. The server's Python client requires the others.
  "$python" -m pip install --quiet playwright==1.65.2 schemathesis==4.32.5 pytest-xdist==3.8.0 \
    pydantic==2.14.3 python-dateutil==2.9.0.post0 urllib3==2.8.0 pymodbus==3.16.1
fi

# Three files at a time on two processors, because many tests wait.
section "Across rooms: the wire of the simulator, and the launcher as a person uses it"
(tests_of across "$home/tests" -n 3 --dist loadfile --no-loadscope-reorder --durations 12) || failed+=("Across rooms")
end
