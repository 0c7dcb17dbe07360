package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The process that created a group, encoded in the group's name. The start time tells processes
 * apart that got the same id.
 *
 * @param namespace process id namespace of the id
 * @param id process id
 * @param start start time in clock ticks since boot
 */
record GroupOwner(String namespace, long id, String start) {
  private static final Pattern NAME = Pattern.compile("sitaf-([0-9]+)-([0-9]+)-([0-9]+)-[0-9]+");
  private static final Pattern NAMESPACE = Pattern.compile("pid:\\[([0-9]+)]");

  /**
   * Index of the start time in {@code /proc/PID/stat}, counted from 0 after the name in
   * parentheses.
   */
  private static final int START_FIELD = 19;

  static GroupOwner thisProcess() throws IOException {
    long id = ProcessHandle.current().pid();
    return new GroupOwner(
        namespaceOfThisProcess(),
        id,
        startOf(id).orElseThrow(() -> new IOException("/proc/" + id + "/stat cannot be read")));
  }

  /** The owner of a group; empty if the name has another form. */
  static Optional<GroupOwner> ofGroup(String name) {
    Matcher matcher = NAME.matcher(name);
    return matcher.matches()
        ? Optional.of(
            new GroupOwner(matcher.group(1), Long.parseLong(matcher.group(2)), matcher.group(3)))
        : Optional.empty();
  }

  String nameOf(int number) {
    return "sitaf-" + namespace + "-" + id + "-" + start + "-" + number;
  }

  /** Whether that process has ended; false if that cannot be known. */
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
