package org.sitaf.agent.compiler;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.digest.Sha256;
import org.sitaf.core.harness.TestApplication;

/** The cache key of a compilation: a digest of all its inputs. */
final class CompileKey {
  /** Format of the cache entries; entries of another format are never found. */
  private static final byte FORMAT = 2;

  private final MessageDigest digest;

  private CompileKey(MessageDigest digest) {
    this.digest = digest;
  }

  static String of(
      TestApplication application, Toolchain toolchain, boolean coverage, boolean debugging)
      throws IOException, InterruptedException {
    CompileKey key = new CompileKey(Sha256.newDigest());
    key.add("format", new byte[] {FORMAT});
    key.add("toolchain", toolchain.identity().getBytes(StandardCharsets.UTF_8));
    key.add("coverage", new byte[] {(byte) (coverage ? 1 : 0)});
    key.add("debugging", new byte[] {(byte) (debugging ? 1 : 0)});
    key.add("entry point", application.entryPoint().getBytes(StandardCharsets.UTF_8));
    for (String word : words(application.activity().profile())) {
      key.add("profile", word.getBytes(StandardCharsets.UTF_8));
    }
    key.add("harness/", application.harness());
    key.add("activity/", inputs(application, toolchain));
    return Sha256.hex(key.digest);
  }

  /** The files of the activity that a compilation may read. */
  private static FileTree inputs(TestApplication application, Toolchain toolchain) {
    ActivityProfile profile = application.activity().profile();
    Component component = profile.component();
    FileTree files = application.activity().files();
    FileTree inputs = FileTree.of(Map.of());
    for (String folder :
        Stream.of(component.sources(), component.adapter(), component.headers())
            .filter(Objects::nonNull)
            .toList()) {
      inputs = inputs.with(folder, files.below(folder));
    }
    Map<String, byte[]> elsewhere = new HashMap<>();
    for (String path : files.paths()) {
      if (toolchain.readsElsewhere(path, profile)) {
        elsewhere.put(path, files.content(path).orElseThrow());
      }
    }
    return inputs.with("", FileTree.of(elsewhere));
  }

  /**
   * The keys of the profile that affect a compiler; others are contained in the harness or affect
   * later stages.
   */
  private static List<String> words(ActivityProfile profile) {
    Component component = profile.component();
    List<String> words = new ArrayList<>();
    for (Object word :
        new @Nullable Object[] {
          component.language(),
          component.sources(),
          component.library(),
          component.headers(),
          component.header(),
          component.packageName(),
          component.className(),
          component.adapter(),
          profile.harness()
        }) {
      words.add(word == null ? "-" : "+" + word);
    }
    words.addAll(profile.libraries());
    profile.sanitizers().forEach(sanitizer -> words.add("sanitize " + sanitizer.id()));
    RosNode node = profile.ros();
    if (node != null) {
      words.add("main " + node.isMain());
      node.packages().forEach(name -> words.add("package " + name));
    }
    return words;
  }

  private void add(String folder, FileTree files) {
    for (String path : files.paths()) {
      add(folder + path, files.content(path).orElseThrow());
    }
  }

  /** Lengths make the encoding unambiguous. */
  private void add(String name, byte[] content) {
    byte[] head =
        (name.length() + " " + name + " " + content.length + "\n").getBytes(StandardCharsets.UTF_8);
    digest.update(head);
    digest.update(content);
  }
}
