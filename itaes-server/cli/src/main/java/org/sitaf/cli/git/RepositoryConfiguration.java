package org.sitaf.cli.git;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.jgit.errors.ConfigInvalidException;
import org.eclipse.jgit.lib.Config;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * The file {@code config} of a repository, which may come from an archive of somebody else. JGit
 * would read each file that it includes, such as a device without an end.
 */
final class RepositoryConfiguration {
  private static final String NAME = "config";
  private static final int MAX_BYTES = 1 << 20;

  /** Holds the path of the main repository's folder in that of a further working tree. */
  private static final String COMMON = "commondir";

  private RepositoryConfiguration() {}

  /**
   * Checks the configuration before JGit reads it.
   *
   * @throws InvalidInputException if it is not a text of limited size, or includes another file
   */
  static void requireWithoutIncludes(Path gitFolder) throws IOException {
    List<Path> folders = new ArrayList<>(List.of(gitFolder));
    if (Files.exists(gitFolder.resolve(COMMON))) {
      folders.add(gitFolder.resolve(text(gitFolder.resolve(COMMON)).strip()));
    }
    for (Path folder : folders) {
      Path file = folder.resolve(NAME);
      if (Files.exists(file)) {
        check(file);
      }
    }
  }

  private static void check(Path file) throws IOException {
    Config config = new Config();
    try {
      // This class does not follow includes.
      config.fromText(text(file));
    } catch (ConfigInvalidException e) {
      throw InvalidInputException.of(file.toString(), "is not valid: " + e.getMessage());
    }
    if (config.getSections().stream().anyMatch("include"::equalsIgnoreCase)) {
      throw InvalidInputException.of(
          file.toString(),
          "includes other files, which are not read; remove the section [include], or clone the"
              + " repository and name the clone");
    }
  }

  private static String text(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw InvalidInputException.of(file.toString(), "is not a regular file");
    }
    try (InputStream in = Files.newInputStream(file)) {
      byte[] content = in.readNBytes(MAX_BYTES + 1);
      if (content.length > MAX_BYTES) {
        throw InvalidInputException.of(
            file.toString(), "has more than " + MAX_BYTES + " bytes; clone the repository");
      }
      return new String(content, StandardCharsets.UTF_8);
    }
  }
}
