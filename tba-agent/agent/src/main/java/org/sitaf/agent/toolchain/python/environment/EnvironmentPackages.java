package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.List;
import java.util.stream.Collectors;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.digest.Sha256;

/**
 * The list of the component's packages in an environment. It lies outside of the environment, where
 * a package can install any file.
 */
final class EnvironmentPackages {
  private static final String LIST = "packages";

  private EnvironmentPackages() {}

  /** Writes the list into a folder. */
  static void write(Path folder, List<ResolvedPackage> packages) throws IOException {
    Files.writeString(
        folder.resolve(LIST),
        packages.stream()
            .sorted()
            .map(each -> each.name() + " " + each.version() + " " + each.sha256() + "\n")
            .collect(Collectors.joining()));
  }

  /** The packages in a folder's list, in ascending order. */
  static List<ResolvedPackage> read(Path folder) throws IOException {
    return Files.readAllLines(folder.resolve(LIST), StandardCharsets.UTF_8).stream()
        .map(line -> line.split(" ", 3))
        .map(parts -> new ResolvedPackage(parts[0], parts[1], parts[2]))
        .toList();
  }

  /** The SHA-256 of a file in hexadecimal. */
  static String digest(Path file) throws IOException {
    MessageDigest digest = Sha256.newDigest();
    byte[] buffer = new byte[1 << 16];
    try (InputStream in = Files.newInputStream(file)) {
      for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
        digest.update(buffer, 0, count);
      }
    }
    return Sha256.hex(digest);
  }
}
