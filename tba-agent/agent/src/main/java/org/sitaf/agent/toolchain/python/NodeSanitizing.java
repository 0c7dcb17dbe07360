package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.spool.LeftFiles;
import org.sitaf.agent.toolchain.ProcessPlace;
import org.sitaf.agent.toolchain.sanitizer.SanitizerSettings;

/**
 * How processes run that load a node compiled with sanitizers.
 *
 * @param preloaded path of the library that must be loaded before all others; null if none must be
 */
record NodeSanitizing(@Nullable String preloaded) {
  /** Beginning of the paths of reports; see {@code sitaf_runtime.ros.sanitizer_report}. */
  private static final String REPORTS = "SITAF_SANITIZER_REPORTS";

  private static final String PRELOADED = "preloaded";
  private static final int MAX_PATH = 4096;

  /**
   * @param folder of the compiled node
   */
  static NodeSanitizing of(Path folder) throws IOException {
    Path file = folder.resolve(PRELOADED);
    return new NodeSanitizing(
        Files.exists(file)
            ? new String(LeftFiles.read(file, MAX_PATH), StandardCharsets.UTF_8)
            : null);
  }

  /**
   * Words before a command; only the command itself, not the sandbox's tools, loads the library.
   */
  List<String> launcher() {
    return preloaded == null ? List.of() : List.of("/usr/bin/env", "LD_PRELOAD=" + preloaded);
  }

  Map<String, String> environment(ProcessPlace place) {
    Path reports = place.temporary().resolve("sanitizer");
    Map<String, String> environment = new HashMap<>(SanitizerSettings.environment(reports));
    environment.put(REPORTS, reports.toString());
    return environment;
  }
}
