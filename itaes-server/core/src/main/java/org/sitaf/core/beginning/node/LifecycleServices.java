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
      Pattern.compile("\\bclass\\s+(\\w{1,100})[^{;:]{0,20}[(:][^{;]{0,300}?\\bLifecycleNode\\b");

  /** rclpy.lifecycle has the class as {@code Node}, too. */
  private static final Pattern ALIAS =
      Pattern.compile(
          "\\bfrom\\s+rclpy\\.lifecycle\\s+import\\s+(?:\\([^)]{0,500}?|[^\\n]{0,500}?)\\bNode\\b");

  private static final Pattern OF_ALIAS =
      Pattern.compile("\\bclass\\s+(\\w{1,100})\\(\\s{0,20}Node\\s{0,20}[,)]");

  private static final Pattern NAME =
      Pattern.compile("\\b(?:__init__|LifecycleNode)\\s{0,20}\\(\\s{0,100}['\"](\\w{1,100})['\"]");

  private LifecycleServices() {}

  /** Entries of {@code provided}; empty unless a source holds a lifecycle node with a name. */
  static List<String> of(List<String> texts, FileTree installed) {
    return texts.stream()
        .flatMap(
            text -> classIn(text).flatMap(c -> nameIn(text).or(() -> nameOf(c, texts))).stream())
        .findFirst()
        .filter(name -> METHODS.stream().allMatch(m -> installed.contains(path(m))))
        .map(
            name ->
                List.of(
                    entry(METHODS.get(0), name + "/change_state"),
                    entry(METHODS.get(1), name + "/get_state")))
        .orElse(List.of());
  }

  private static Optional<String> classIn(String text) {
    Matcher declared = CLASS.matcher(text);
    if (declared.find()) {
      return Optional.of(declared.group(1));
    }
    Matcher alias = OF_ALIAS.matcher(text);
    return ALIAS.matcher(text).find() && alias.find()
        ? Optional.of(alias.group(1))
        : Optional.empty();
  }

  /** The name with which the node is made: {@code Talker('talker')}. */
  private static Optional<String> nameOf(String nodeClass, List<String> texts) {
    Pattern made =
        Pattern.compile(
            "\\b" + nodeClass + "\\s{0,20}>?\\s{0,20}\\(\\s{0,100}['\"](\\w{1,100})['\"]");
    return texts.stream()
        .map(made::matcher)
        .filter(Matcher::find)
        .map(found -> found.group(1))
        .findFirst();
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
