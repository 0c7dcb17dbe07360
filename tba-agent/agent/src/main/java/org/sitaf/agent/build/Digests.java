package org.sitaf.agent.build;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.digest.Sha256;

/** SHA-256 of files and trees, in hexadecimal. */
final class Digests {
  private Digests() {}

  static String of(byte[] content) {
    return Sha256.hex(content);
  }

  /**
   * Digest of a tree: of the lines {@code DIGEST␠␠PATH\n} of its files sorted by path, in the
   * format of {@code sha256sum}.
   */
  static String of(FileTree tree) {
    MessageDigest digest = Sha256.newDigest();
    for (String path : tree.paths()) {
      String line = of(tree.content(path).orElseThrow()) + "  " + path + "\n";
      digest.update(line.getBytes(StandardCharsets.UTF_8));
    }
    return Sha256.hex(digest);
  }
}
