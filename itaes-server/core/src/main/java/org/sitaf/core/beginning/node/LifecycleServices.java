package org.sitaf.core.beginning.node;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.activity.FileTree;

/** The services of a lifecycle node, which its sources do not create themselves. */
final class LifecycleServices {
  /** The package of these services, and the name of the interface that they are. */
  static final String PACKAGE = "lifecycle_msgs";

  /** Models of the services alone would tell nothing. */
  static final List<String> METHODS = List.of("ChangeState", "GetState");

  private static final Pattern CLASS =
      Pattern.compile("\\bclass\\s+\\w{1,100}[^{;:]{0,20}[(:][^{;]{0,300}?\\bLifecycleNode\\b");
  private static final Pattern NAME =
      Pattern.compile("\\b(?:__init__|LifecycleNode)\\s{0,20}\\(\\s{0,100}['\"](\\w{1,100})['\"]");

  private LifecycleServices() {}

  /** Entries of {@code provided}; empty unless a source holds a lifecycle node with a name. */
  static List<String> of(List<String> texts, FileTree installed) {
    return texts.stream()
        .filter(text -> CLASS.matcher(text).find())
        .map(LifecycleServices::nameIn)
        .flatMap(Optional::stream)
        .findFirst()
        .filter(name -> METHODS.stream().allMatch(m -> installed.contains(path(m))))
        .map(
            name ->
                List.of(
                    entry(METHODS.get(0), name + "/change_state"),
                    entry(METHODS.get(1), name + "/get_state")))
        .orElse(List.of());
  }

  private static Optional<String> nameIn(String text) {
    Matcher name = NAME.matcher(text);
    return name.find() ? Optional.of(name.group(1)) : Optional.empty();
  }

  private static String path(String service) {
    return PACKAGE + "/srv/" + service + ".srv";
  }

  private static String entry(String service, String name) {
    return "{type: " + path(service) + ", name: /" + name + "}";
  }
}
