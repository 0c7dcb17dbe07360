#!/usr/bin/env bash
# Lists installed and missing software, and the command that installs it. Needs only a shell.
# doctor --install cpp: installs what tests of C++ components need.
# doctor --install ros: installs a ROS 2 for Python from PyPI, for nodes that run with an installed one.
set -uo pipefail
launcher=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
home=$(cd "$launcher/../../.." && pwd)
state=$home/.sitaf
missing=()
# The compiler, gRPC and expat for the runtime of test applications, gcovr for the coverage of components.
cpp_packages=(g++ pkg-config libgrpc++-dev libprotobuf-dev protobuf-compiler protobuf-compiler-grpc libexpat1-dev gcovr)

if [ "$*" = "--install ros" ]; then
  # shellcheck source=itaes-server/cli/launcher/setup.sh
  source "$launcher/setup.sh"
  set_up_installed_ros
  exit
fi
if [ $# -gt 0 ]; then
  if [ "$*" != "--install cpp" ]; then
    echo "sitaf: doctor: unknown arguments '$*'; expected '--install cpp' or '--install ros'" >&2
    exit 2
  fi
  command -v apt-get >/dev/null || {
    echo "sitaf: apt-get is not installed; install the equivalents of these Debian packages: ${cpp_packages[*]}" >&2
    exit 1
  }
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -qq &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${cpp_packages[@]}"
  exit
fi

# check NAME WANTED FOUND PACKAGES: FOUND is the version that was found, or empty.
check() {
  local name=$1 wanted=$2 found=$3 packages=$4
  if [ -n "$found" ]; then
    printf '  %-12s %-28s %s\n' "$name" "$found" "ok"
  else
    printf '  %-12s %-28s %s\n' "$name" "not found" "needs $wanted"
    missing+=($packages)
  fi
}

# optional NAME PURPOSE FOUND PACKAGES: software that SITAF does not require.
optional() {
  local name=$1 purpose=$2 found=$3 packages=$4
  if [ -n "$found" ]; then
    printf '  %-12s %-28s %s\n' "$name" "$found" "ok"
  else
    printf '  %-12s %-28s %s\n' "$name" "not found" "$purpose; apt-get install -y $packages"
  fi
}

# at_least MAJOR.MINOR VERSION: prints the version when it is new enough.
at_least() {
  [ -n "$2" ] && [ "$(printf '%s\n%s\n' "$1" "$2" | sort -V | head -n 1)" = "$1" ] && printf '%s' "$2"
}

version_of() {
  "$@" 2>&1 | grep -oE '[0-9]+(\.[0-9]+)+' | head -n 1
}

echo "Required:"
check "JDK" "17 or newer" "$(at_least 17 "$(command -v javac >/dev/null && version_of javac -version)")" openjdk-17-jdk-headless
check "Maven" "3.8 or newer" "$(at_least 3.8 "$(command -v mvn >/dev/null && version_of mvn -version)")" maven
check "Python" "3.11 or newer, with venv" "$(at_least 3.11 "$(command -v python3 >/dev/null && python3 -c 'import venv, ensurepip' 2>/dev/null && version_of python3 --version)")" "python3 python3-venv"
check "Node" "20 or newer" "$(at_least 20 "$(command -v node >/dev/null && version_of node --version)")" nodejs
check "npm" "10 or newer" "$(at_least 10 "$(command -v npm >/dev/null && version_of npm --version)")" npm
check "flock" "util-linux" "$(command -v flock >/dev/null && version_of flock --version)" util-linux

echo
echo "Optional:"
cpp=$(command -v g++ >/dev/null && command -v grpc_cpp_plugin >/dev/null && pkg-config --exists grpc++ protobuf expat 2>/dev/null && version_of g++ -dumpfullversion)
if [ -n "$cpp" ]; then
  printf '  %-12s %-28s %s\n' "C++" "g++ $cpp, gRPC $(pkg-config --modversion grpc++)" "ok"
else
  printf '  %-12s %-28s %s\n' "C++" "not found" "for C++ components: ./sitaf doctor --install cpp"
fi
optional "CMake" "for components that are CMake projects" "$(command -v make >/dev/null && command -v cmake >/dev/null && version_of cmake --version)" "cmake make"
optional "bubblewrap" "sandbox for components" "$(command -v bwrap >/dev/null && version_of bwrap --version)" bubblewrap

optional "socat" "serial cable of examples/serial-range" "$(command -v socat >/dev/null && version_of socat -V)" socat
optional "gdb" "debugger for C++ components" "$(command -v gdb >/dev/null && version_of gdb --version)" gdb

# As the agent searches.
ros=${AMENT_PREFIX_PATH:-$(ls -d /opt/ros/*/ "$state/ros-jazzy" 2>/dev/null | head -n 1)}
if [ -n "$ros" ]; then
  printf '  %-12s %-28s %s\n' "ROS 2" "${ros%%:*}" "ok"
else
  printf '  %-12s %-28s %s\n' "ROS 2" "not found" "only for nodes that run with --ros system: ./sitaf doctor --install ros"
fi

# feature NAME STATE NOTE: a feature of the sandbox; the note explains how to get a missing feature.
feature() {
  printf '  %-12s %-28s %s\n' "$1" "$2" "${3:-ok}"
}

# own_group CONTROLLER: the folder of this process's control group of version 1, or of version 2 for the empty name.
own_group() {
  local mount own
  if [ -z "$1" ]; then
    mount=$(awk '$3 == "cgroup2" { print $2; exit }' /proc/mounts 2>/dev/null)
    own=$(sed -n 's/^0:://p' /proc/self/cgroup 2>/dev/null)
  else
    mount=$(awk -v c=",$1," '$3 == "cgroup" && index("," $4 ",", c) { print $2; exit }' /proc/mounts 2>/dev/null)
    own=$(sed -nE "s/^[0-9]+:([^:]*,)?$1(,[^:]*)?:(.*)$/\\3/p" /proc/self/cgroup 2>/dev/null)
  fi
  [ -n "$mount" ] && [ -w "$mount$own/cgroup.procs" ] && printf '%s' "$mount$own"
}

if command -v bwrap >/dev/null; then
  echo
  echo "Sandbox for components, if started by $(id -un):"
  namespaces=()
  [ "$(id -u)" -eq 0 ] || namespaces=(--unshare-user)
  if why=$(bwrap "${namespaces[@]}" --unshare-pid --unshare-net --ro-bind / / --proc /proc true 2>&1); then
    feature "namespaces" "bubblewrap" ""
  else
    feature "namespaces" "none" "$why; start the agent as root, or allow user namespaces (sysctl kernel.unprivileged_userns_clone)"
  fi
  filtered=
  case $(uname -m) in
    x86_64 | aarch64) grep -q '^Seccomp:' /proc/self/status 2>/dev/null && filtered=yes ;;
  esac
  if [ -n "$filtered" ]; then
    feature "system calls" "filtered" ""
  else
    feature "system calls" "not filtered" "only on x86_64 and aarch64, by a kernel with seccomp"
  fi
  unified=$(own_group "")
  delegate="start the agent by its systemd unit (docs/systemd), by 'systemd-run --user --scope -p Delegate=yes' or, with control groups v1, as root"
  if python3 -c 'import ctypes, sys; sys.exit(ctypes.CDLL(None).syscall(444, None, ctypes.c_size_t(0), 1) < 1)' 2>/dev/null; then
    feature "ROS 2 nodes" "kept out of their driver" ""
  else
    feature "ROS 2 nodes" "NOT KEPT OUT OF THEIR DRIVER" "they could write results; needs Linux 5.13 or newer with Landlock (lsm=landlock,...)"
  fi
  if perl -e 'exit(syscall(444, 0, 0, 1) < 1)' 2>/dev/null; then
    feature "own process" "components in a domain" ""
  else
    feature "own process" "NOT PROTECTED" "an ordinary user's component could change its exit code; needs Perl, and Linux 5.13 or newer with Landlock"
  fi
  if [ -n "$(own_group memory)" ]; then
    feature "memory" "control groups v1" ""
  elif [ -n "$unified" ] && [ "$(id -u)" -ne 0 ] && grep -qw memory "$unified/cgroup.controllers"; then
    feature "memory" "control groups v2" ""
  elif [ -n "$filtered" ]; then
    feature "memory" "polled by the agent" "control groups would be exact: $delegate"
  else
    feature "memory" "NOT LIMITED" "--sandbox=required does not work on this host; $delegate"
  fi
  if [ -n "$(own_group cpu)" ] || { [ -n "$unified" ] && [ "$(id -u)" -ne 0 ] && grep -qw cpu "$unified/cgroup.controllers"; }; then
    feature "processors" "shared by control groups" ""
  elif [ "$(cat /proc/sys/kernel/sched_autogroup_enabled 2>/dev/null)" = 1 ] &&
    grep -qE '^([0-9]+:([^:]*,)?cpu(,[^:]*)?|0:):/$' /proc/self/cgroup; then
    feature "processors" "shared by session" ""
  else
    feature "processors" "NOT SHARED" "a component can slow others down; $delegate"
  fi
fi

echo
echo "Built:"
for part in java:"server, agent and commands" bridge:simulation; do
  if [ -e "$home/.sitaf/${part%%:*}.stamp" ]; then
    printf '  %-42s %s\n' "${part#*:}" "since $(date -r "$home/.sitaf/${part%%:*}.stamp" '+%Y-%m-%d %H:%M')"
  else
    printf '  %-42s %s\n' "${part#*:}" "not yet; built by the first command that needs it"
  fi
done

echo
if [ ${#missing[@]} -eq 0 ]; then
  echo "All required software is installed. './sitaf demo' runs the paper's evaluation."
else
  echo "Install the missing software on Debian with:"
  echo
  echo "  sudo apt-get install -y ${missing[*]}"
  exit 1
fi
