package org.sitaf.cli.compare;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.git.GitFolder;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * One of the two compared versions.
 *
 * @param label {@code BASE} or {@code NEW}
 * @param activity as its documents say
 */
public record Version(String label, Activity activity) {
  /**
   * Reads an activity folder, its ZIP archive, or {@code FOLDER@REVISION}.
   *
   * @throws InvalidInputException with all problems, which name the version
   */
  public static Version read(String label, String argument) throws IOException {
    return of(label, files(argument));
  }

  /** The same version with another release of a package. */
  Version with(NewPackage changed) {
    return of(label, changed.in(activity));
  }

  private static Version of(String label, FileTree files) {
    try {
      return new Version(label, Installation.read(files));
    } catch (InvalidInputException e) {
      throw new InvalidInputException(
          e.diagnostics().stream()
              .map(
                  d ->
                      new Diagnostic(
                          d.severity(),
                          label + ": " + d.file(),
                          d.line(),
                          d.element(),
                          d.message()))
              .toList());
    }
  }

  private static FileTree files(String argument) throws IOException {
    Path path = Path.of(argument);
    if (Files.isDirectory(path)) {
      return UserFiles.folder(path);
    }
    if (Files.isRegularFile(path)) {
      try (InputStream zip = new BufferedInputStream(Files.newInputStream(path))) {
        return ActivityArchive.read(zip, argument);
      }
    }
    List<Integer> separators = new ArrayList<>();
    for (int at = argument.indexOf('@'); at >= 0; at = argument.indexOf('@', at + 1)) {
      separators.add(at);
    }
    if (separators.isEmpty()) {
      throw InvalidInputException.of(
          argument, "does not exist; name an activity folder, its ZIP archive or FOLDER@REVISION");
    }
    // A folder and a revision such as HEAD@{1} may contain the character.
    int separator =
        separators.stream()
            .filter(at -> Files.isDirectory(Path.of(argument.substring(0, at))))
            .findFirst()
            .orElse(separators.get(0));
    String revision = argument.substring(separator + 1);
    if (revision.isEmpty()) {
      throw InvalidInputException.of(argument, "names no revision after '@'");
    }
    return GitFolder.read(Path.of(argument.substring(0, separator)), revision);
  }
}
