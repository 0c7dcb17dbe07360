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
 * @param text as {@code pip} reads them; empty where it needs none
 * @param file where they stand, in the layout of the application
 * @param wheels packages that the activity brings itself
 */
record Requirements(String text, String file, List<Path> wheels) {
  private static final String PROFILE = "activity/activity.yaml";

  /** A package by name, with extras and versions; no option, no path, no address. */
  private static final Pattern PACKAGE =
      Pattern.compile(
          "[A-Za-z0-9][A-Za-z0-9._-]*(\\[[A-Za-z0-9._, -]*])?"
              + "\\s*((===?|~=|!=|<=?|>=?)\\s*[A-Za-z0-9._*+!-]+\\s*,?\\s*)*");

  Requirements {
    wheels = List.copyOf(wheels);
  }

  /** Whether a library is a package that pip installs, and no folder of modules. */
  static boolean isWheel(String library) {
    return library.endsWith(".whl");
  }

  /** What the profile names, and what {@code requirements.txt} beside the sources lists. */
  static Requirements of(ActivityProfile profile, Path activity)
      throws CompilationException, IOException {
    Component component = profile.component();
    StringBuilder text = new StringBuilder();
    String file = PROFILE;
    String named = component.packageName();
    if (named != null) {
      if (!PACKAGE.matcher(named.strip()).matches()) {
        throw new CompilationException(
            "the component's package cannot be fetched",
            List.of(
                SourceDiagnostic.ofFile(
                    PROFILE,
                    "component: package: '"
                        + named
                        + "' is not a package such as simple-pid==2.0.1")));
      }
      text.append(named.strip()).append('\n');
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
        text.append(new String(Files.readAllBytes(list), StandardCharsets.UTF_8)).append('\n');
        file = "activity/" + activity.normalize().relativize(list);
      }
    }
    List<Path> wheels =
        Stream.concat(Stream.ofNullable(component.library()), profile.libraries().stream())
            .filter(Requirements::isWheel)
            .map(library -> activity.resolve(library).normalize())
            .toList();
    return new Requirements(text.toString(), file, wheels);
  }
}
