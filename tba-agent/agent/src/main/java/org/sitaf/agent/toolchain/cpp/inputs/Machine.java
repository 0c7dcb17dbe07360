package org.sitaf.agent.toolchain.cpp.inputs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.sitaf.core.digest.Sha256;

/**
 * Headers and libraries of this machine's packages, which no user can change. An instance sees each
 * file as at its first access.
 */
final class Machine {
  /** Folders that a confined compiler sees; users cannot write there. */
  private static final List<String> SYSTEM =
      List.of("/usr/", "/lib/", "/lib32/", "/lib64/", "/libx32/");

  private static final long MAX_BYTES = 64L << 20;
  private static final int MAX_CACHED = 20_000;
  private static final Map<String, Content> CONTENTS = new ConcurrentHashMap<>();

  private final Map<String, Stamp> stamps = new HashMap<>();

  /** Digest and names of a header. */
  private record Content(Stamp stamp, String sha256, AskedNames asked) {}

  /** Whether a path printed by a tool is in a system folder. */
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
   * @throws IOException if its content is uncertain, for example because it changes at this moment
   */
  String sha256(String path) throws IOException {
    return content(path).sha256();
  }

  /**
   * The names in the include directives of a header.
   *
   * @throws IOException like {@link #sha256(String)}
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
    if (stamp.size() > MAX_BYTES) {
      throw new IOException(path + " is too large to be a header");
    }
    byte[] bytes = Files.readAllBytes(Path.of(path));
    if (!Stamp.of(path).equals(stamp)) {
      throw new IOException(path + " changed while it was read");
    }
    Content content = new Content(stamp, Sha256.hex(bytes), AskedNames.in(bytes));
    if (CONTENTS.size() >= MAX_CACHED) {
      CONTENTS.clear();
    }
    CONTENTS.put(path, content);
    return content;
  }
}
