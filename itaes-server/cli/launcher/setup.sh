# Builds and installs SITAF if its sources have changed. Sourced by the launcher; expects $home and $state.

# Runs a stage with its output in a log, and shows one line of progress.
stage() {
  local title=$1 log=$state/log/$2.log
  shift 2
  mkdir -p "$state/log"
  local began=$SECONDS
  "$@" >"$log" 2>&1 &
  local pid=$!
  if [ -t 2 ]; then
    while kill -0 "$pid" 2>/dev/null; do
      printf '\r\033[K%s, %d s: %s' "$title" $((SECONDS - began)) "$(progress_of "$log")" >&2
      sleep 0.5
    done
    printf '\r\033[K' >&2
  else
    printf '%s ...\n' "$title" >&2
  fi
  if ! wait "$pid"; then
    printf 'sitaf: %s failed; end of the log %s:\n' "$title" "$log" >&2
    tail -n 40 "$log" >&2
    printf "sitaf: './sitaf doctor' lists missing software\n" >&2
    exit 2
  fi
  printf '%s: %d s\n' "$title" $((SECONDS - began)) >&2
}

progress_of() {
  grep -aoE 'Building [A-Z][A-Za-z ]+ [0-9.]+ +\[[0-9/]+\]|Collecting [A-Za-z0-9_-]+|Installing collected packages' "$1" 2>/dev/null | tail -n 1
}

require() {
  command -v "$1" >/dev/null || {
    printf "sitaf: %s is missing; './sitaf doctor' shows how to install it\n" "$1" >&2
    exit 2
  }
}

# One set-up at a time; other processes wait for it.
locked() {
  mkdir -p "$state"
  exec 9>"$state/lock"
  flock 9
}

unlocked() {
  exec 9>&-
}

# Whether a source file below the given paths is newer than a stamp; build output is ignored.
newer_than() {
  local stamp=$1
  shift
  [ ! -e "$stamp" ] || [ -n "$(find "$@" \( -name target -o -name node_modules -o -name dist -o -name build -o -name '*.egg-info' -o -name __pycache__ -o -name '.*_cache' -o -name '*_pb2*' -o -name schema.d.ts -o -name .jqwik-database \) -prune \
    -o -type f -newer "$stamp" -print -quit)" ]
}

java_sources() {
  printf '%s\n' "$home/pom.xml" "$home/proto" "$home/schemas" "$home/itaes-server" "$home/tba-agent" "$home/webapp"
}

set_up_java() {
  require java
  require javac
  mapfile -t sources < <(java_sources)
  newer_than "$state/java.stamp" "${sources[@]}" || return 0
  locked
  if newer_than "$state/java.stamp" "${sources[@]}"; then
    require mvn
    require npm
    touch "$state/java.begun"
    stage "Building SITAF" build mvn -B -ntp -f "$home/pom.xml" -DskipTests -Dspotless.check.skip=true package
    keep_java
  fi
  unlocked
}

# Installs the output of Maven; expects the lock.
keep_java() {
  stage "Installing SITAF in .sitaf" install install_java
  mv "$state/java.begun" "$state/java.stamp"
}

# Copies the build output, so that later builds do not affect running programs, and creates the archives for class data sharing
# that need no simulation.
install_java() {
  set -e
  local new=$state/dist.new
  rm -rf "$new"
  mkdir -p "$new"
  cp -r "$home/itaes-server/cli/target/dist" "$new/cli"
  cp -r "$home/tba-agent/agent/target/dist" "$new/agent"
  java -Djarmode=tools -jar "$home/itaes-server/app/target/sitaf-server.jar" extract --destination "$new/server"
  rm -rf "$state/dist"
  mv "$new" "$state/dist"
  java -XX:ArchiveClassesAtExit="$state/dist/cli/cli.jsa" -XX:TieredStopAtLevel=1 -jar "$state/dist/cli/cli.jar" \
    generate "$home/examples/ir-sensor/GetInfraredData.xml"
  "$home/tba-agent/agent/archive-runtimes.sh" "$state/dist/agent"
}

# Creates the archives of the command line, the server and the agent. Without the simulation, only that of the server is possible.
set_up_archives() {
  newer_than "$state/archives.stamp" "$state/java.stamp" || return 0
  # Another user's installation is used as it is.
  [ -w "$state" ] || return 0
  locked
  if newer_than "$state/archives.stamp" "$state/java.stamp"; then
    touch "$state/archives.begun"
    if [ -e "$state/bridge.stamp" ]; then
      stage "Preparing fast starts, once after a build" archives archive_dry_run
      mv "$state/archives.begun" "$state/archives.stamp"
    elif [ ! -e "$state/dist/server/server.jsa" ]; then
      stage "Preparing fast starts, once after a build" archives archive_start
    fi
  fi
  unlocked
}

# Archives of what the programs load for an example. Without them they start slowly, but work.
archive_dry_run() {
  local dist=$state/dist
  java -XX:ArchiveClassesAtExit="$dist/cli/cli.jsa.new" -XX:TieredStopAtLevel=1 -Dsitaf.home="$home" \
    -cp "$dist/cli/cli.jar" org.sitaf.cli.system.DryRun || echo "the example could not be run"
  for part in cli server agent; do
    [ ! -e "$dist/$part/$part.jsa.new" ] || mv -f "$dist/$part/$part.jsa.new" "$dist/$part/$part.jsa"
  done
}

# The archive of what the server loads to start.
archive_start() {
  set -e
  local server=$state/dist/server trial=$state/trial
  rm -rf "$trial"
  java -XX:ArchiveClassesAtExit="$server/server.jsa" -XX:TieredStopAtLevel=1 -Dspring.context.exit=onRefresh \
    -jar "$server/sitaf-server.jar" --sitaf.data-directory="$trial" --server.port=0 --spring.grpc.server.port=0
  rm -rf "$trial"
}

set_up_bridge() {
  newer_than "$state/bridge.stamp" "$home/sim-bridge" "$home/hardware/python" "$home/proto" || return 0
  locked
  if newer_than "$state/bridge.stamp" "$home/sim-bridge" "$home/hardware/python" "$home/proto"; then
    require python3
    touch "$state/bridge.begun"
    stage "Setting up the simulation" bridge install_bridge
    mv "$state/bridge.begun" "$state/bridge.stamp"
  fi
  unlocked
}

install_bridge() {
  set -e
  [ -x "$state/venv/bin/python" ] || python3 -m venv "$state/venv"
  "$state/venv/bin/python" -m pip install "$home/hardware/python" "$home/sim-bridge[dev,ros]"
}

# Builds the book, which the server shows below /docs.
set_up_docs() {
  local stamp=$state/docs.stamp
  newer_than "$stamp" "$home/docs" "$state/java.stamp" || return 0
  mkdir -p "$state/book"
  exec 8>"$state/book/lock"
  flock 8
  if newer_than "$stamp" "$home/docs" "$state/java.stamp"; then
    touch "$state/docs.begun"
    stage "Building the documentation" docs build_docs
    mv "$state/docs.begun" "$stamp"
  fi
  exec 8>&-
}

# The same while the server starts, which does not wait for it.
set_up_docs_later() {
  (set_up_docs >/dev/null 2>&1 </dev/null &)
}

build_docs() {
  set -e
  local venv=$state/book/venv
  if newer_than "$venv/stamp" "$home/docs/book/requirements.txt"; then
    [ -x "$venv/bin/python" ] || python3 -m venv "$venv"
    "$venv/bin/python" -m pip install --disable-pip-version-check -r "$home/docs/book/requirements.txt"
    touch "$venv/stamp"
  fi
  "$venv/bin/python" "$home/docs/book/build.py" "$home" "$state/book"
}

# Exports the interface files of ROS 2, which activities use without containing them.
set_up_ros() {
  set_up_bridge
  local runtime=$home/tba-agent/runtime-python/src
  [ -d "$runtime/sitaf_ros" ] || return 0
  newer_than "$state/ros2.stamp" "$runtime/sitaf_ros" "$state/bridge.stamp" || return 0
  locked
  if newer_than "$state/ros2.stamp" "$runtime/sitaf_ros" "$state/bridge.stamp"; then
    touch "$state/ros2.begun"
    stage "Setting up the interfaces of ROS 2" ros2 install_ros_interfaces "$runtime"
    mv "$state/ros2.begun" "$state/ros2.stamp"
  fi
  unlocked
}

install_ros_interfaces() {
  set -e
  local new=$state/ros2.new
  rm -rf "$new"
  mkdir -p "$new"
  PYTHONPATH=$1 PYTHONDONTWRITEBYTECODE=1 "$state/venv/bin/python" -m sitaf_ros.export "$new/jazzy"
  # Services, actions and default values that the store of rosbags lacks.
  cp -r "$1/sitaf_ros/definitions/." "$new/jazzy"
  rm -rf "$state/ros2"
  mv "$new" "$state/ros2"
}

# Installs a ROS 2 for Python from PyPI; `with_installed_ros` names it to agents and commands.
set_up_installed_ros() {
  local wanted=$launcher/ros-requirements.txt
  newer_than "$state/ros-jazzy/stamp" "$wanted" || return 0
  if [ "$(uname -m)" != x86_64 ]; then
    echo "sitaf: PyPI has ROS 2 for x86_64 only; install the packages of ROS itself, and source its setup.bash" >&2
    exit 2
  fi
  mkdir -p "$state"
  locked
  if newer_than "$state/ros-jazzy/stamp" "$wanted"; then
    stage "Installing ROS 2 for Python" ros install_ros "$wanted"
  fi
  unlocked
}

install_ros() {
  set -e
  rm -rf "$state/ros-jazzy"
  python3 -m venv "$state/ros-jazzy"
  "$state/ros-jazzy/bin/python" -m pip install --disable-pip-version-check -r "$1"
  touch "$state/ros-jazzy/stamp"
}

# Unless the shell or the machine has another one.
with_installed_ros() {
  if [ -z "${AMENT_PREFIX_PATH:-}" ] && [ ! -d /opt/ros ] && [ -e "$state/ros-jazzy/stamp" ]; then
    export AMENT_PREFIX_PATH=$state/ros-jazzy ROS_DISTRO=jazzy
  fi
}

java_flags() {
  printf '%s\n' -XX:SharedArchiveFile="$state/dist/$1/$1.jsa" -Xshare:auto -Xlog:disable -Xlog:all=error:stderr -XX:TieredStopAtLevel=1
}

run_cli() {
  with_installed_ros
  mapfile -t flags < <(java_flags cli)
  exec java "${flags[@]}" -Dsitaf.home="$home" -jar "$state/dist/cli/cli.jar" "$@"
}

run_server() {
  mapfile -t flags < <(java_flags server)
  exec java "${flags[@]}" -jar "$state/dist/server/sitaf-server.jar" --sitaf.data-directory="$state/data" \
    --sitaf.ros-interfaces="$state/ros2/jazzy" --sitaf.documentation="$state/book/site" "$@"
}

run_agent() {
  with_installed_ros
  mapfile -t flags < <(java_flags agent)
  # The folder holds the agent's key and users' sources.
  (umask 077 && mkdir -p "$state/agent")
  exec java "${flags[@]}" -jar "$state/dist/agent/agent.jar" --directory "$state/agent" --earlier-cache "$state/cache" \
    --bridge-command "'$state/venv/bin/python' -m sitaf_bridge" "$@"
}
