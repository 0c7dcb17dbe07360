#!/usr/bin/env bash
# Creates the class-data archives of Java test applications and of their compiler: what each of these processes loads before
# its work. usage: archive-runtimes.sh DIST (folder of the agent with its runtimes)
set -euo pipefail
dist=${1:?usage: archive-runtimes.sh DIST}
flags=(-XX:TieredStopAtLevel=1 -XX:+UseSerialGC)
runtime=$(printf '%s\n' "$dist"/runtime-java/*.jar | LC_ALL=C sort | paste -sd:)
rm -f "$dist"/{runtime,compiler}-java.jsa
java -XX:ArchiveClassesAtExit="$dist/runtime-java.jsa" "${flags[@]}" -cp "$runtime" org.sitaf.runtime.DryRun
# The compiler ends without a request.
java -XX:ArchiveClassesAtExit="$dist/compiler-java.jsa" "${flags[@]}" -cp "$dist/compiler-java/compiler-java.jar" \
  org.sitaf.agent.toolchain.java.confined.CompilerMain "$runtime" "" --release 17 -g -nowarn -implicit:none -proc:none \
  </dev/null >/dev/null
