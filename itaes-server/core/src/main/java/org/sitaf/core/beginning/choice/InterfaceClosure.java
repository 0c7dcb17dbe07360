package org.sitaf.core.beginning.choice;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.activity.FileTree;

/** The interface files that a file refers to, directly or not. */
final class InterfaceClosure {
  // Files are untrusted: a pattern must not scan the same characters again from each position.
  private static final Pattern ROS_TYPE =
      Pattern.compile(
          "^[ \\t]{0,100}(?:([A-Za-z]\\w{0,255})/)?(?:msg/)?([A-Z]\\w{0,255})\\b",
          Pattern.MULTILINE);
  private static final Pattern ROS_FILE =
      Pattern.compile("(?:(.*)/)?([^/]+)/(?:msg|srv|action)/[^/]+\\.(?:msg|srv|action)");
  private static final Pattern WORD =
      Pattern.compile("(?<![\\w.-])[\\w.-]{1,255}\\.(?:idl|proto|xml|msg)\\b");

  private InterfaceClosure() {}

  /**
   * The file and those that it needs.
   *
   * @param main path of the file among the candidates
   * @param candidates files next to it, and of its package
   * @param installed interface files of ROS 2 by {@code PACKAGE/msg/NAME.msg}
   */
  static FileTree of(String main, FileTree candidates, FileTree installed) {
    Map<String, byte[]> needed = new HashMap<>();
    Deque<String> open = new ArrayDeque<>(Set.of(main));
    while (!open.isEmpty()) {
      String path = open.remove();
      if (needed.containsKey(path)) {
        continue;
      }
      byte[] content =
          candidates.content(path).or(() -> installed.content(path)).orElse(new byte[0]);
      needed.put(path, content);
      String text = new String(content, StandardCharsets.UTF_8);
      for (String reference : references(path, text)) {
        found(reference, candidates, installed).ifPresent(open::add);
      }
    }
    return FileTree.of(needed);
  }

  private static Set<String> references(String path, String text) {
    Set<String> references = new HashSet<>();
    Matcher ros = ROS_FILE.matcher(path);
    if (ros.matches()) {
      String above = ros.group(1) == null ? "" : ros.group(1) + "/";
      Matcher type = ROS_TYPE.matcher(text);
      while (type.find()) {
        String name = type.group(2);
        String owner =
            type.group(1) != null
                ? type.group(1)
                : name.equals("Header") ? "std_msgs" : ros.group(2);
        references.add(above + owner + "/msg/" + name + ".msg");
        references.add(owner + "/msg/" + name + ".msg");
      }
      return references;
    }
    String folder = path.contains("/") ? path.substring(0, path.lastIndexOf('/') + 1) : "";
    Matcher word = WORD.matcher(text);
    while (word.find()) {
      references.add(folder + word.group());
    }
    return references;
  }

  private static Optional<String> found(String path, FileTree candidates, FileTree installed) {
    return candidates.contains(path) || installed.contains(path)
        ? Optional.of(path)
        : Optional.empty();
  }
}
