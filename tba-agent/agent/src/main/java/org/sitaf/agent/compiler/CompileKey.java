package org.sitaf.agent.compiler;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.TestApplication;

/** Names what a compilation brings by all that goes into it. */
final class CompileKey {
  private final MessageDigest digest;

  private CompileKey(MessageDigest digest) {
    this.digest = digest;
  }

  static String of(TestApplication application, Toolchain toolchain, boolean coverage)
      throws IOException, InterruptedException {
    CompileKey key = new CompileKey(sha256());
    key.add("toolchain", toolchain.identity().getBytes(StandardCharsets.UTF_8));
    key.add("coverage", new byte[] {(byte) (coverage ? 1 : 0)});
    key.add("entry point", application.entryPoint().getBytes(StandardCharsets.UTF_8));
    key.add("harness/", application.harness(), "");
    key.add("activity/", application.activity().files(), worldFolder(application));
    return HexFormat.of().formatHex(key.digest.digest());
  }

  /** A world of its own folder is no source; its meshes may be large. Empty for none. */
  private static String worldFolder(TestApplication application) {
    String world = application.activity().profile().world();
    return world == null ? "" : world.substring(0, world.lastIndexOf('/') + 1);
  }

  private void add(String folder, FileTree files, String without) {
    for (String path : files.paths()) {
      if (without.isEmpty() || !path.startsWith(without)) {
        add(folder + path, files.content(path).orElseThrow());
      }
    }
  }

  /** Lengths keep what follows from passing for a part of it. */
  private void add(String name, byte[] content) {
    byte[] head =
        (name.length() + " " + name + " " + content.length + "\n").getBytes(StandardCharsets.UTF_8);
    digest.update(head);
    digest.update(content);
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
