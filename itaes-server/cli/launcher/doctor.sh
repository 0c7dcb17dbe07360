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
