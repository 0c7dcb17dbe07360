package org.sitaf.cli.compare;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * Another release of a package: of the component itself, or of a package that it uses.
 *
 * @param name of a Python package, or {@code GROUP:ARTIFACT} of a Maven package
 */
record NewPackage(String name, String version) {
  private static final Pattern FORM =
      Pattern.compile("([A-Za-z0-9][A-Za-z0-9._-]*(?::[A-Za-z0-9._-]+)?)==([A-Za-z0-9._+!-]+)");
  private static final Pattern MAVEN_FORM =
      Pattern.compile("([A-Za-z0-9][A-Za-z0-9._-]*:[A-Za-z0-9._-]+):([A-Za-z0-9._+!-]+)");
  private static final Pattern PYTHON_NAME = Pattern.compile("^[A-Za-z0-9][A-Za-z0-9._-]*");
  private static final String PROFILE = "activity.yaml";
  private static final String LIST = "requirements.txt";

  /**
   * Reads {@code NAME==VERSION}, or {@code GROUP:ARTIFACT:VERSION} as a profile names a package.
   *
   * @throws InvalidInputException if it has another form
   */
  static NewPackage parse(String text) {
    Matcher maven = MAVEN_FORM.matcher(text);
    Matcher form = maven.matches() ? maven : FORM.matcher(text);
    if (!form.matches()) {
      throw InvalidInputException.of(
          "--new-package " + text,
          "must be NAME==VERSION, such as numpy==2.4.0 or org.apache.commons:commons-math3:3.6.1");
    }
    return new NewPackage(form.group(1), form.group(2));
  }

  /**
   * The files of an activity that uses this release.
   *
   * @throws InvalidInputException if the component cannot use such a package
   */
  FileTree in(Activity activity) {
    Component component = activity.profile().component();
    String used = component.packageName();
    if (used != null && isOf(component.language(), used.strip())) {
      return unlocked(withComponent(activity.files(), used));
    }
    if (component.language() != Language.PYTHON) {
      throw InvalidInputException.of(
          "--new-package " + name,
          "is not the package of the component"
              + (used == null ? ", which has none" : ", " + used)
              + "; other packages can be replaced for Python components only");
    }
    return unlocked(withDependency(activity.files(), component));
  }

  /** Keeps the other packages of a lock. */
  private FileTree unlocked(FileTree files) {
    return ActivityLock.of(files)
        .map(
            lock ->
                files.with(
                    ActivityLock.FILE,
                    lock.without(name.contains(":") ? name : normalised(name))
                        .text()
                        .getBytes(UTF_8)))
        .orElse(files);
  }

  private boolean isOf(Language language, String used) {
    return switch (language) {
      case PYTHON -> isPython(used);
      case JAVA -> used.startsWith(name + ":");
      default -> false;
    };
  }

  /** Whether a requirement names this package; case and separators do not matter (PEP 503). */
  private boolean isPython(String requirement) {
    Matcher start = PYTHON_NAME.matcher(requirement.strip());
    return start.find() && normalised(start.group()).equals(normalised(name));
  }

  private static String normalised(String pythonName) {
    return pythonName.toLowerCase(Locale.ROOT).replaceAll("[-_.]+", "-");
  }

  private FileTree withComponent(FileTree files, String used) {
    String text = files.text(PROFILE).orElseThrow();
    int key = text.indexOf("package:");
    int at = key < 0 ? -1 : text.indexOf(used, key);
    if (at < 0) {
      throw InvalidInputException.of(
          PROFILE, "component: package: cannot be replaced; write it as package: " + used);
    }
    String replaced = name.contains(":") ? name + ":" + version : name + "==" + version;
    return files.with(
        PROFILE,
        (text.substring(0, at) + replaced + text.substring(at + used.length())).getBytes(UTF_8));
  }

  private FileTree withDependency(FileTree files, Component component) {
    FileTree changed = files;
    List<String> lists =
        Stream.<@Nullable String>of(component.sources(), component.adapter(), "")
            .filter(Objects::nonNull)
            .map(folder -> folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/")
            .map(folder -> folder + LIST)
            .distinct()
            .toList();
    for (String list : lists) {
      String text = files.text(list).orElse("");
      String others =
          text.lines()
              .filter(line -> !isPython(line))
              .map(l -> l + "\n")
              .collect(Collectors.joining());
      String own = list.equals(LIST) ? name + "==" + version + "\n" : "";
      if (!text.isEmpty() || !own.isEmpty()) {
        changed = changed.with(list, (others + own).getBytes(UTF_8));
      }
    }
    return changed;
  }
}
