package org.sitaf.core.harness.cpp.syntax;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlanner;

/** Finds the header that declares the component under test. */
public final class ComponentHeader {
  private static final Pattern HEADER = Pattern.compile(".*\\.(h|hh|hpp|hxx|h\\+\\+)");
  private static final Pattern PATH = Pattern.compile("[A-Za-z0-9_+./ -]+");

  private ComponentHeader() {}

  /**
   * Returns the include path of the header: {@code component.header}, or the only header in
   * adapter, sources and headers that declares the class.
   *
   * @param diagnostics receives the reason if the header is not found
   * @return empty if the header is not found
   */
  public static Optional<String> find(Activity activity, Diagnostics diagnostics) {
    Component component = activity.profile().component();
    if (component.header() != null) {
      return checked(component.header(), "component.header", diagnostics);
    }
    String className = component.className();
    String simple = className.substring(className.lastIndexOf(':') + 1);
    Pattern declaration =
        Pattern.compile(
            "\\b(?:class|struct)\\s+(?:\\[\\[[^\\]]*\\]\\]\\s*)?(?:[A-Z][A-Z0-9_]*\\s+)?"
                + Pattern.quote(simple)
                + "\\s*(?:final\\s*)?[:{]");
    List<String> folders =
        Stream.of(component.adapter(), component.sources(), component.headers())
            .filter(Objects::nonNull)
            .toList();
    for (String folder : folders) {
      FileTree files = activity.files().below(folder);
      List<String> declaring = new ArrayList<>();
      for (String path : files.paths()) {
        if (HEADER.matcher(path).matches()
            && declaration.matcher(files.text(path).orElse("")).find()) {
          declaring.add(path);
        }
      }
      if (declaring.size() > 1) {
        diagnostics.error(
            HarnessPlanner.PROFILE,
            0,
            "component.class",
            simple + " is declared in several headers, " + declaring + "; select one by header:");
        return Optional.empty();
      }
      if (!declaring.isEmpty()) {
        return checked(declaring.get(0), "the header of " + simple, diagnostics);
      }
    }
    diagnostics.error(
        HarnessPlanner.PROFILE,
        0,
        "component.class",
        "no header "
            + (folders.isEmpty() ? "is in the activity" : "in " + String.join(", ", folders))
            + " that declares "
            + className
            + "; add such a header, or set header: to its include path"
            + (component.adapter() == null
                ? ""
                : "; ./sitaf harness ACTIVITY_DIR --adapter generates a skeleton"));
    return Optional.empty();
  }

  private static Optional<String> checked(String path, String where, Diagnostics diagnostics) {
    if (PATH.matcher(path).matches()) {
      return Optional.of(path);
    }
    diagnostics.error(
        HarnessPlanner.PROFILE,
        0,
        where,
        "'" + path + "' cannot be included; use letters, digits and _+./- only");
    return Optional.empty();
  }
}
