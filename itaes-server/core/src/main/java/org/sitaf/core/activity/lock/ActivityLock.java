package org.sitaf.core.activity.lock;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.YamlDocument;
import org.sitaf.core.document.YamlMapping;

/**
 * The exact packages of an activity, from {@code activity.lock}.
 *
 * @param packages in ascending order, at most one of each name
 * @param complete whether builds may use no other packages
 */
public record ActivityLock(List<ResolvedPackage> packages, boolean complete) {
  /** The file in the root folder of an activity. */
  public static final String FILE = "activity.lock";

  private static final int MAX_PACKAGES = 2000;
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_][A-Za-z0-9._:-]{0,299}");
  private static final Pattern VERSION = Pattern.compile("[A-Za-z0-9_][A-Za-z0-9._+!-]{0,199}");
  private static final Pattern SHA256 = Pattern.compile("[0-9a-f]{64}");
  private static final String REMEDY =
      "; if this is intended, update the file by ./sitaf lock ACTIVITY_DIR --update";

  public ActivityLock {
    packages = packages.stream().sorted().toList();
  }

  /** The lock of an activity; empty if it has none. Problems are reported. */
  public static Optional<ActivityLock> of(FileTree files, Diagnostics diagnostics) {
    return files.text(FILE).map(text -> read(text, diagnostics));
  }

  /**
   * The lock of an activity; empty if it has none.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException if the file is invalid
   */
  public static Optional<ActivityLock> of(FileTree files) {
    Diagnostics diagnostics = new Diagnostics();
    Optional<ActivityLock> lock = of(files, diagnostics);
    diagnostics.throwIfErrors();
    return lock;
  }

  private static ActivityLock read(String text, Diagnostics diagnostics) {
    YamlMapping root = YamlDocument.read(text, FILE, diagnostics);
    root.allowOnly(Set.of("packages", "complete"));
    List<ResolvedPackage> packages = new ArrayList<>();
    Map<String, Integer> lines = new HashMap<>();
    List<YamlMapping.Item> items = root.items("packages");
    if (items.size() > MAX_PACKAGES) {
      root.problem("packages", "lists more than " + MAX_PACKAGES + " packages");
      return new ActivityLock(List.of(), true);
    }
    for (YamlMapping.Item item : items) {
      YamlMapping entry = item.mapping();
      if (entry == null) {
        diagnostics.error(
            FILE, item.line(), "packages", "must have the entries name, version and sha256");
        continue;
      }
      entry.allowOnly(Set.of("name", "version", "sha256"));
      String name = checked(entry, "name", NAME, "a package such as numpy or org.apache:math");
      String version = checked(entry, "version", VERSION, "a version such as 2.4.6");
      String sha256 = checked(entry, "sha256", SHA256, "a SHA-256 of 64 hexadecimal digits");
      if (lines.putIfAbsent(name, item.line()) != null) {
        entry.problem("name", "'" + name + "' is listed twice; remove one");
      }
      packages.add(new ResolvedPackage(name, version, sha256));
    }
    return new ActivityLock(packages, root.booleanValue("complete").orElse(true));
  }

  private static String checked(YamlMapping entry, String key, Pattern form, String wanted) {
    String text = entry.requiredText(key);
    if (!text.isEmpty() && !form.matcher(text).matches()) {
      entry.problem(key, "'" + text + "' is not " + wanted);
    }
    return text;
  }

  /** The text of the file. */
  public String text() {
    StringBuilder text = new StringBuilder();
    text.append("# Builds use exactly these packages. Written by ./sitaf lock; do not edit.\n");
    if (!complete) {
      text.append("complete: false\n");
    }
    text.append(packages.isEmpty() ? "packages: []\n" : "packages:\n");
    for (ResolvedPackage each : packages) {
      text.append("- name: \"").append(each.name()).append("\"\n");
      text.append("  version: \"").append(each.version()).append("\"\n");
      text.append("  sha256: \"").append(each.sha256()).append("\"\n");
    }
    return text.toString();
  }

  /**
   * A copy that allows any release of one package and of packages that are not listed.
   *
   * @param name normalised name
   */
  public ActivityLock without(String name) {
    return new ActivityLock(
        packages.stream().filter(each -> !each.name().equals(name)).toList(), false);
  }

  /**
   * Why packages are not those of the lock, with what to do; empty if they are.
   *
   * @param resolved the packages of a build
   */
  public Optional<String> mismatch(List<ResolvedPackage> resolved) {
    Map<String, ResolvedPackage> open = new TreeMap<>();
    packages.forEach(each -> open.put(each.name(), each));
    for (ResolvedPackage each : resolved) {
      ResolvedPackage locked = open.remove(each.name());
      if (locked == null) {
        if (complete) {
          return Optional.of(
              "does not list " + each.name() + " " + each.version() + ", which is needed" + REMEDY);
        }
      } else if (!locked.version().equals(each.version())) {
        return Optional.of(
            "lists %s %s, but %s is needed".formatted(each.name(), locked.version(), each.version())
                + REMEDY);
      } else if (!locked.sha256().equals(each.sha256())) {
        return Optional.of(
            "lists %s %s with SHA-256 %s, but the file for this machine has %s: it was replaced, or the file was written on another platform"
                    .formatted(each.name(), each.version(), locked.sha256(), each.sha256())
                + REMEDY);
      }
    }
    return open.isEmpty() || !complete
        ? Optional.empty()
        : Optional.of(
            "lists " + String.join(", ", open.keySet()) + ", which is not needed" + REMEDY);
  }
}
