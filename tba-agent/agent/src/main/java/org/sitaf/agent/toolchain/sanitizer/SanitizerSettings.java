package org.sitaf.agent.toolchain.sanitizer;

import java.nio.file.Path;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Settings of the processes of programs that are compiled with sanitizers. */
public final class SanitizerSettings {
  /** Red zones, the quarantine of freed memory and the shadow of what is used. */
  public static final int MEMORY_MIB = 512;

  private SanitizerSettings() {}

  /**
   * Environment variables of a process.
   *
   * @param reports beginning of the paths of reports, which the process id follows; null for
   *     reports on standard error
   */
  public static Map<String, String> environment(@Nullable Path reports) {
    String file = reports == null ? "" : ":log_path=" + reports;
    return Map.of(
        "ASAN_OPTIONS",
        // Leaks are searched by attaching to the process, which the sandbox refuses. Handlers of
        // signals that a runtime installs would hide a report.
        "detect_leaks=0:quarantine_size_mb=64" + (reports == null ? "" : ":handle_segv=2") + file,
        "UBSAN_OPTIONS",
        "print_stacktrace=1" + file,
        // Libraries of the machine are compiled without it, so it cannot see how they synchronise.
        "TSAN_OPTIONS",
        "halt_on_error=1:ignore_noninstrumented_modules=1:report_thread_leaks=0"
            + ":report_signal_unsafe=0");
  }
}
