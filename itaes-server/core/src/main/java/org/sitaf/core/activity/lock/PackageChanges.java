package org.sitaf.core.activity.lock;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Describes how two sets of packages differ. */
public final class PackageChanges {
  private PackageChanges() {}

  /** One text for each package that differs, such as {@code numpy 2.4.0 -> 2.4.6}, by name. */
  public static List<String> between(List<ResolvedPackage> before, List<ResolvedPackage> now) {
    Map<String, List<ResolvedPackage>> old = byName(before);
    Map<String, List<ResolvedPackage>> current = byName(now);
    TreeSet<String> names = new TreeSet<>(old.keySet());
    names.addAll(current.keySet());
    return names.stream()
        .filter(name -> !at(old, name).equals(at(current, name)))
        .map(name -> name + " " + change(at(old, name), at(current, name)))
        .toList();
  }

  private static Map<String, List<ResolvedPackage>> byName(List<ResolvedPackage> packages) {
    return packages.stream()
        .sorted()
        .collect(Collectors.groupingBy(ResolvedPackage::name, TreeMap::new, Collectors.toList()));
  }

  private static List<ResolvedPackage> at(Map<String, List<ResolvedPackage>> all, String name) {
    return all.getOrDefault(name, List.of());
  }

  private static String change(List<ResolvedPackage> before, List<ResolvedPackage> now) {
    String old = versions(before);
    String current = versions(now);
    if (old.isEmpty()) {
      return current;
    }
    return current.isEmpty()
        ? "is no longer used"
        : old.equals(current) ? current + ", another file" : old + " -> " + current;
  }

  private static String versions(List<ResolvedPackage> packages) {
    return packages.stream()
        .map(ResolvedPackage::version)
        .distinct()
        .collect(Collectors.joining(", "));
  }
}
