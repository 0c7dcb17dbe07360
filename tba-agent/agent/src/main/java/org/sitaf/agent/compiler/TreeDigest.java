package org.sitaf.agent.compiler;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.core.digest.Sha256;

/** SHA-256 of the files of a folder, with their paths and executable flags. */
final class TreeDigest {
  private TreeDigest() {}

  static String of(Path folder) throws IOException {
    MessageDigest digest = Sha256.newDigest();
    List<Path> files;
    try (Stream<Path> all = Files.walk(folder)) {
      files =
          all.filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS))
              .sorted()
              .toList();
    }
    for (Path file : files) {
      byte[] content = Files.readAllBytes(file);
      String path = folder.relativize(file).toString();
      String head =
          path.length() + " " + path + " " + Files.isExecutable(file) + " " + content.length + "\n";
      digest.update(head.getBytes(StandardCharsets.UTF_8));
      digest.update(content);
    }
    return Sha256.hex(digest);
  }
}
