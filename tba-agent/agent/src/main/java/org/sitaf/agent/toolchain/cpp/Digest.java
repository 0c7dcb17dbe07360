package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.core.digest.Sha256;

/** SHA-256 of a sequence of texts and files, each with its length. */
final class Digest {
  private final MessageDigest digest;

  Digest() {
    digest = Sha256.newDigest();
  }

  /** SHA-256 of the first bytes of an array. */
  static byte[] sha256(byte[] bytes, int length) {
    MessageDigest digest = Sha256.newDigest();
    digest.update(bytes, 0, length);
    return digest.digest();
  }

  void add(String text) {
    add(text.getBytes(StandardCharsets.UTF_8));
  }

  void add(byte[] content) {
    digest.update((content.length + ":").getBytes(StandardCharsets.US_ASCII));
    digest.update(content);
  }

  /** Adds all files of a folder with their paths, sorted by path. */
  void addFolder(Path folder) throws IOException {
    List<Path> files;
    try (Stream<Path> walk = Files.walk(folder)) {
      files = walk.filter(Files::isRegularFile).sorted().toList();
    }
    for (Path file : files) {
      add(folder.relativize(file).toString());
      add(Files.readAllBytes(file));
    }
  }

  String hexadecimal() {
    return Sha256.hex(digest);
  }
}
