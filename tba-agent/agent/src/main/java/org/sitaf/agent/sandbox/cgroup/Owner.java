package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The process that made a group, as the group's name says it; a process id alone would be given
 * again.
 *
 * @param namespace of process ids, in which the id means that process
 * @param id of the process
 * @param start when it began, in ticks since the machine did
 */
record Owner(String namespace, long id, String start) {
  private static final Pattern NAME = Pattern.compile("sitaf-([0-9]+)-([0-9]+)-([0-9]+)-[0-9]+");
  private static final Pattern NAMESPACE = Pattern.compile("pid:\\[([0-9]+)]");

  /** Field of {@code /proc/PID/stat} behind the name in parentheses, counted from 0. */
  private static final int START_FIELD = 19;

  static Owner thisProcess() throws IOException {
    long id = ProcessHandle.current().pid();
    return new Owner(
        namespaceOfThisProcess(),
        id,
        startOf(id).orElseThrow(() -> new IOException("/proc/" + id + "/stat cannot be read")));
  }

  /** The owner of a group; empty where the name is none of ours. */
  static Optional<Owner> ofGroup(String name) {
    Matcher matcher = NAME.matcher(name);
    return matcher.matches()
        ? Optional.of(
            new Owner(matcher.group(1), Long.parseLong(matcher.group(2)), matcher.group(3)))
        : Optional.empty();
  }

  String nameOf(int number) {
    return "sitaf-" + namespace + "-" + id + "-" + start + "-" + number;
  }

  /** Whether that process is known to have ended. */
  boolean isGone() throws IOException {
    return namespace.equals(namespaceOfThisProcess())
        && startOf(id).filter(start::equals).isEmpty();
  }

  private static String namespaceOfThisProcess() throws IOException {
    String link = Files.readSymbolicLink(Path.of("/proc/self/ns/pid")).toString();
    Matcher matcher = NAMESPACE.matcher(link);
    if (!matcher.matches()) {
      throw new IOException("/proc/self/ns/pid is " + link);
    }
    return matcher.group(1);
  }

  private static Optional<String> startOf(long id) {
    try {
      String stat =
          Files.readString(
              Path.of("/proc", Long.toString(id), "stat"), StandardCharsets.ISO_8859_1);
      String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
      return Optional.of(fields[START_FIELD]);
    } catch (IOException e) {
      return Optional.empty();
    }
  }
}
