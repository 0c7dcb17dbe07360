package org.sitaf.agent.toolchain.cpp.inputs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Files of this machine that belong to no user: headers and libraries of its packages. One view
 * sees each of them as it was when it was first looked at.
 */
final class Machine {
  /** What a confined compiler sees of the machine; users write nothing there. */
  private static final List<String> SYSTEM =
      List.of("/usr/", "/lib/", "/lib32/", "/lib64/", "/libx32/");

  private static final long MOST_BYTES = 64L << 20;
  private static final int REMEMBERED = 20_000;
  private static final Map<String, Content> CONTENTS = new ConcurrentHashMap<>();

  private final Map<String, Stamp> stamps = new HashMap<>();

  /** What was read of a header. */
  private record Content(Stamp stamp, String sha256, AskedNames asked) {}

  /** Whether a path, as a tool has printed it, is one of the system's. */
  static boolean isOfSystem(String printed) {
    return SYSTEM.stream().anyMatch(printed::startsWith)
        && SYSTEM.stream().anyMatch(Path.of(printed).normalize().toString()::startsWith);
  }

  synchronized Stamp stamp(String path) {
    return stamps.computeIfAbsent(path, Stamp::of);
  }

  /**
   * SHA-256 of a header.
   *
   * @throws IOException if it cannot be said what is in it, as when it changes meanwhile
   */
  String sha256(String path) throws IOException {
    return content(path).sha256();
  }

  /**
   * The names that a header asks for.
   *
   * @throws IOException as {@link #sha256(String)} does
   */
  AskedNames asked(String path) throws IOException {
    return content(path).asked();
  }

  private Content content(String path) throws IOException {
    Stamp stamp = stamp(path);
    Content known = CONTENTS.get(path);
    if (known != null && known.stamp().equals(stamp)) {
      return known;
    }
    if (stamp.size() > MOST_BYTES) {
      throw new IOException(path + " is too large for a header");
    }
    byte[] bytes = Files.readAllBytes(Path.of(path));
    if (!Stamp.of(path).equals(stamp)) {
      throw new IOException(path + " changes while it is read");
    }
    Content content = new Content(stamp, sha256(bytes), AskedNames.in(bytes));
    if (CONTENTS.size() >= REMEMBERED) {
      CONTENTS.clear();
    }
    CONTENTS.put(path, content);
    return content;
  }

  static String sha256(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError(e);
    }
  }
}
