package org.sitaf.agent.toolchain.python;

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

/**
 * The packages that a component needs.
 *
 * @param lines each names a package of the index; empty where it needs none
 * @param file where they stand, in the layout of the application
 * @param wheels packages that the activity brings itself
 */
record Requirements(List<String> lines, String file, List<Path> wheels) {
  private static final String PROFILE = "activity/activity.yaml";
  private static final int LONGEST_LINE = 300;
  private static final int MOST_LINES = 200;
  private static final long LONGEST_LIST_BYTES = 64 << 10;

  /**
   * A package by name, with extras, versions and a marker. No option, no path, no address: pip is
   * to reach nothing but the index that this machine is configured for.
   */
  private static final Pattern PACKAGE =
      Pattern.compile(
          "[A-Za-z0-9][A-Za-z0-9._-]*(?:[ ]?\\[[A-Za-z0-9._, -]*])?"
              + "(?:[ ]*(?:===?|~=|!=|<=?|>=?)[ ]*[A-Za-z0-9._*+!-]+[ ]*,?)*[ ]*"
              + "(?:;[A-Za-z0-9_. <>=!~'\"(),-]+)?");

  /** What pip takes for a file where there is one of the name. */
  private static final Pattern ARCHIVE =
      Pattern.compile("(?i).*\\.(whl|zip|tar|tgz|gz|bz2|tbz|xz|txz|tlz|lz|lzma)");

  private static final Pattern COMMENT = Pattern.compile("(^|[ \\t])#.*");

  Requirements {
    lines = List.copyOf(lines);
    wheels = List.copyOf(wheels);
  }

  /** What makes an environment without packages of a component. */
  static final Requirements NONE = new Requirements(List.of(), PROFILE, List.of());

  boolean isEmpty() {
    return lines.isEmpty() && wheels.isEmpty();
  }

  /** Whether a line names a package of the index and nothing else. */
  static boolean isPackage(String line) {
    return line.length() <= LONGEST_LINE
        && PACKAGE.matcher(line).matches()
        && !ARCHIVE.matcher(line).matches();
  }

  /** Whether a library is a package that pip installs, and no folder of modules. */
  static boolean isWheel(String library) {
    return library.endsWith(".whl");
  }

  /** What the profile names, and what {@code requirements.txt} beside the sources lists. */
  static Requirements of(ActivityProfile profile, Path activity)
      throws CompilationException, IOException {
    Component component = profile.component();
    List<String> lines = new ArrayList<>();
    String file = PROFILE;
    String named = component.packageName();
    if (named != null) {
      if (!isPackage(named.strip())) {
        throw new CompilationException(
            "the component's package cannot be fetched",
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
    List<Path> wheels =
        Stream.concat(Stream.ofNullable(component.library()), profile.libraries().stream())
            .filter(Requirements::isWheel)
            .map(library -> activity.resolve(library).normalize())
            .toList();
    return new Requirements(lines, file, wheels);
  }

  private static List<String> read(Path list, String file)
      throws CompilationException, IOException {
    if (Files.size(list) > LONGEST_LIST_BYTES) {
      throw refused(file, 0, "is longer than " + LONGEST_LIST_BYTES + " bytes");
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
        throw refused(
            file,
            number,
            "'"
                + wanted.substring(0, Math.min(LONGEST_LINE, wanted.length()))
                + "' is not a package of the index such as simple-pid==2.0.1; options, addresses,"
                + " repositories and paths are not taken: add a package that is not in the index"
                + " as a wheel to 'libraries:'");
      }
      packages.add(wanted);
      if (packages.size() > MOST_LINES) {
        throw refused(file, number, "more than " + MOST_LINES + " packages");
      }
    }
    return packages;
  }

  private static CompilationException refused(String file, int line, String reason) {
    return new CompilationException(
        "the component's packages cannot be installed",
        List.of(new SourceDiagnostic(file, line, 0, reason, false)));
  }
}
