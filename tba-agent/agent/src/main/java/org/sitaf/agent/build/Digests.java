package org.sitaf.agent.build;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.sitaf.core.activity.FileTree;

/** SHA-256 of files and trees, in hexadecimal. */
final class Digests {
  private Digests() {}

  static String of(byte[] content) {
    return HexFormat.of().formatHex(sha256().digest(content));
  }

  /**
   * Digest of a tree: of the lines {@code DIGEST␠␠PATH\n} of its files sorted by path, in the
   * format of {@code sha256sum}.
   */
  static String of(FileTree tree) {
    MessageDigest digest = sha256();
    for (String path : tree.paths()) {
      String line = of(tree.content(path).orElseThrow()) + "  " + path + "\n";
      digest.update(line.getBytes(StandardCharsets.UTF_8));
    }
    return HexFormat.of().formatHex(digest.digest());
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
