package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.lock.ActivityLock;

/**
 * The packages that a component needs.
 *
 * @param lines package requirements; empty for none
 * @param file path of the requirements file in the layout of the application
 * @param wheels packages that are part of the activity
 * @param lock their exact releases; null if the newest suitable ones are used
 */
public record Requirements(
    List<String> lines, String file, List<Path> wheels, @Nullable ActivityLock lock) {
  private static final String PROFILE = "activity/activity.yaml";
  private static final int MAX_LINE = 300;
  private static final int MAX_LINES = 200;
  private static final long MAX_LIST_BYTES = 64 << 10;

  /**
   * A package name with extras, versions and a marker. Options, paths and addresses are not
   * allowed, so pip uses only the index that this machine is configured for.
   */
  private static final Pattern PACKAGE =
      Pattern.compile(
          "[A-Za-z0-9][A-Za-z0-9._-]*(?:[ ]?\\[[A-Za-z0-9._, -]*])?"
              + "(?:[ ]*(?:===?|~=|!=|<=?|>=?)[ ]*[A-Za-z0-9._*+!-]+[ ]*,?)*[ ]*"
              + "(?:;[A-Za-z0-9_. <>=!~'\"(),-]+)?");

  /** Names that pip takes for a file if one exists. */
  private static final Pattern ARCHIVE =
      Pattern.compile("(?i).*\\.(whl|zip|tar|tgz|gz|bz2|tbz|xz|txz|tlz|lz|lzma)");

  /** ROS messages hold arrays of numbers as arrays of this package. */
  private static final String NUMPY = "numpy==2.4.6";

  private static final Pattern NUMPY_LINE = Pattern.compile("(?i)numpy(?![A-Za-z0-9._-])");

  private static final Pattern COMMENT = Pattern.compile("(^|[ \\t])#.*");

  public Requirements {
    lines = List.copyOf(lines);
    wheels = List.copyOf(wheels);
  }

  /** An environment without packages of a component. */
  public static final Requirements NONE = new Requirements(List.of(), PROFILE, List.of(), null);

  /** The environment of ROS 2 nodes without packages of a component. */
  public static final Requirements OF_NODES =
      new Requirements(List.of(NUMPY), PROFILE, List.of(), null);

  boolean isEmpty() {
    return lines.isEmpty() && wheels.isEmpty();
  }

  /** Whether a line is a requirement for a package of the index. */
  static boolean isPackage(String line) {
    return line.length() <= MAX_LINE
        && PACKAGE.matcher(line).matches()
        && !ARCHIVE.matcher(line).matches();
  }

  /** Whether a library is a wheel and not a folder of modules. */
  public static boolean isWheel(String library) {
    return library.endsWith(".whl");
  }

  /** The package of the profile, and the lines of {@code requirements.txt} next to the sources. */
  public static Requirements of(ActivityProfile profile, @Nullable ActivityLock lock, Path activity)
      throws CompilationException, IOException {
    Component component = profile.component();
    List<String> lines = new ArrayList<>();
    String file = PROFILE;
    String named = component.packageName();
    if (named != null) {
      if (!isPackage(named.strip())) {
        throw new CompilationException(
            "the component's package cannot be downloaded",
            List.of(
                SourceDiagnostic.ofFile(
                    PROFILE,
                    "component: package: '"
                        + named
                        + "' is not a package such as simple-pid==2.0.1")));
      }
      lines.add(named.strip());
    }
    List<Path> folders = new ArrayList<>();
    for (@Nullable String folder :
        new @Nullable String[] {component.sources(), component.adapter(), ""}) {
      if (folder != null) {
        folders.add(activity.resolve(folder).normalize());
      }
    }
    for (Path folder : folders.stream().distinct().toList()) {
      Path list = folder.resolve("requirements.txt");
      if (Files.isRegularFile(list)) {
        file = "activity/" + activity.normalize().relativize(list);
        lines.addAll(read(list, file));
      }
    }
    if (profile.ros() != null
        && lines.stream().noneMatch(line -> NUMPY_LINE.matcher(line).lookingAt())) {
      lines.add(NUMPY);
    }
    List<Path> wheels =
        Stream.concat(Stream.ofNullable(component.library()), profile.libraries().stream())
            .filter(Requirements::isWheel)
            .map(library -> activity.resolve(library).normalize())
            .toList();
    return new Requirements(lines, file, wheels, lines.isEmpty() && wheels.isEmpty() ? null : lock);
  }

  private static List<String> read(Path list, String file)
      throws CompilationException, IOException {
    if (Files.size(list) > MAX_LIST_BYTES) {
      throw failure(file, 0, "is longer than " + MAX_LIST_BYTES + " bytes");
    }
    String text = new String(Files.readAllBytes(list), StandardCharsets.UTF_8);
    List<String> packages = new ArrayList<>();
    int number = 0;
    for (String line : text.lines().toList()) {
      number++;
      String wanted = COMMENT.matcher(line).replaceFirst("").replace('\t', ' ').strip();
      if (wanted.isEmpty()) {
        continue;
      }
      if (!isPackage(wanted)) {
        throw failure(
            file,
            number,
            "'"
                + wanted.substring(0, Math.min(MAX_LINE, wanted.length()))
                + "' is not a package of the index such as simple-pid==2.0.1; options, addresses,"
                + " repositories and paths are not supported: add other packages"
                + " as wheels to 'libraries:'");
      }
      packages.add(wanted);
      if (packages.size() > MAX_LINES) {
        throw failure(file, number, "more than " + MAX_LINES + " packages");
      }
    }
    return packages;
  }

  private static CompilationException failure(String file, int line, String reason) {
    return new CompilationException(
        "the component's packages cannot be installed",
        List.of(new SourceDiagnostic(file, line, 0, reason, false)));
  }
}
