#!/usr/bin/env bash
# What is installed, what is missing, and the one command that installs it. Needs nothing but a shell.
# doctor --install cpp: installs what tests of C++ components need.
set -uo pipefail
missing=()
# The compiler, gRPC and expat for the runtime of test applications, gcovr for the coverage of components.
cpp_packages=(g++ pkg-config libgrpc++-dev libprotobuf-dev protobuf-compiler protobuf-compiler-grpc libexpat1-dev gcovr)

if [ $# -gt 0 ]; then
  if [ "$*" != "--install cpp" ]; then
    echo "sitaf: doctor knows '--install cpp' only, not '$*'" >&2
    exit 2
  fi
  command -v apt-get >/dev/null || {
    echo "sitaf: there is no apt-get on this machine; install what Debian calls: ${cpp_packages[*]}" >&2
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

# better NAME WHAT_FOR FOUND PACKAGES: something that SITAF runs without.
better() {
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

echo "SITAF needs:"
check "JDK" "17 or newer" "$(at_least 17 "$(command -v javac >/dev/null && version_of javac -version)")" openjdk-17-jdk-headless
check "Maven" "3.8 or newer" "$(at_least 3.8 "$(command -v mvn >/dev/null && version_of mvn -version)")" maven
check "Python" "3.11 or newer, with venv" "$(at_least 3.11 "$(command -v python3 >/dev/null && python3 -c 'import venv, ensurepip' 2>/dev/null && version_of python3 --version)")" "python3 python3-venv"
check "Node" "20 or newer" "$(at_least 20 "$(command -v node >/dev/null && version_of node --version)")" nodejs
check "npm" "10 or newer" "$(at_least 10 "$(command -v npm >/dev/null && version_of npm --version)")" npm
check "flock" "util-linux" "$(command -v flock >/dev/null && version_of flock --version)" util-linux

echo
echo "SITAF is better with:"
cpp=$(command -v g++ >/dev/null && command -v grpc_cpp_plugin >/dev/null && pkg-config --exists grpc++ protobuf expat 2>/dev/null && version_of g++ -dumpfullversion)
if [ -n "$cpp" ]; then
  printf '  %-12s %-28s %s\n' "C++" "g++ $cpp, gRPC $(pkg-config --modversion grpc++)" "ok"
else
  printf '  %-12s %-28s %s\n' "C++" "not found" "components in C++; ./sitaf doctor --install cpp"
fi
better "bubblewrap" "the sandbox of components" "$(command -v bwrap >/dev/null && version_of bwrap --version)" bubblewrap

# held NAME HOW NOTE: how the sandbox holds a component; a note says what this host cannot give, and what gives it.
held() {
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
  echo "The sandbox of components, as $(id -un) starts it:"
  namespaces=()
  [ "$(id -u)" -eq 0 ] || namespaces=(--unshare-user)
  if why=$(bwrap "${namespaces[@]}" --unshare-pid --unshare-net --ro-bind / / --proc /proc true 2>&1); then
    held "namespaces" "bubblewrap" ""
  else
    held "namespaces" "none" "$why; start the agent as root, or allow user namespaces (sysctl kernel.unprivileged_userns_clone)"
  fi
  filtered=
  case $(uname -m) in
    x86_64 | aarch64) grep -q '^Seccomp:' /proc/self/status 2>/dev/null && filtered=yes ;;
  esac
  if [ -n "$filtered" ]; then
    held "system calls" "filtered" ""
  else
    held "system calls" "not filtered" "only on x86_64 and aarch64, by a kernel with seccomp"
  fi
  unified=$(own_group "")
  delegate="start the agent by its systemd unit (docs/systemd), by 'systemd-run --user --scope -p Delegate=yes' or, with control groups v1, as root"
  if [ -n "$(own_group memory)" ]; then
    held "memory" "control groups v1" ""
  elif [ -n "$unified" ] && [ "$(id -u)" -ne 0 ] && grep -qw memory "$unified/cgroup.controllers"; then
    held "memory" "control groups v2" ""
  elif [ -n "$filtered" ]; then
    held "memory" "polled by the agent" "control groups would be exact: $delegate"
  else
    held "memory" "NOT LIMITED" "--sandbox=required does not work on this host; $delegate"
  fi
  if [ -n "$(own_group cpu)" ] || { [ -n "$unified" ] && [ "$(id -u)" -ne 0 ] && grep -qw cpu "$unified/cgroup.controllers"; }; then
    held "processors" "shared by control groups" ""
  elif [ "$(cat /proc/sys/kernel/sched_autogroup_enabled 2>/dev/null)" = 1 ] &&
    grep -qE '^([0-9]+:([^:]*,)?cpu(,[^:]*)?|0:):/$' /proc/self/cgroup; then
    held "processors" "shared by session" ""
  else
    held "processors" "NOT SHARED" "a component can slow others down; $delegate"
  fi
fi

home=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../.." && pwd)
echo
echo "Set up here:"
for part in java:"server, agent and commands" bridge:simulation; do
  if [ -e "$home/.sitaf/${part%%:*}.stamp" ]; then
    printf '  %-42s %s\n' "${part#*:}" "since $(date -r "$home/.sitaf/${part%%:*}.stamp" '+%Y-%m-%d %H:%M')"
  else
    printf '  %-42s %s\n' "${part#*:}" "not yet; the first command that needs it does it"
  fi
done

echo
if [ ${#missing[@]} -eq 0 ]; then
  echo "Nothing is missing. './sitaf demo' runs the paper's evaluation."
else
  echo "Missing. On Debian, this installs it:"
  echo
  echo "  sudo apt-get install -y ${missing[*]}"
  exit 1
fi
