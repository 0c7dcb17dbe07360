package org.sitaf.agent.build;

import java.util.Optional;

/** Counts what a build keeps of its cases, up to a number of cases and bytes. Not thread-safe. */
final class KeptFiles {
  private final String what;
  private final int maxCases;
  private final long maxBytes;

  private int kept;
  private long bytes;
  private int omitted;

  /**
   * @param what the files of the cases, for messages
   */
  KeptFiles(String what, int maxCases, long maxBytes) {
    this.what = what;
    this.maxCases = maxCases;
    this.maxBytes = maxBytes;
  }

  /** Whether the file of another case is kept; if not, it is counted as omitted. */
  boolean admit(long size) {
    if (kept >= maxCases || bytes + size > maxBytes) {
      omitted++;
      return false;
    }
    kept++;
    bytes += size;
    return true;
  }

  /** The totals for the log; empty if there was no file. */
  Optional<String> totals() {
    if (kept == 0 && omitted == 0) {
      return Optional.empty();
    }
    return Optional.of(
        "%s: %d cases, %.1f MiB".formatted(what, kept, bytes / (double) (1 << 20))
            + (omitted == 0
                ? ""
                : "; %d more are omitted: a build keeps %d of at most %d MiB"
                    .formatted(omitted, maxCases, maxBytes >> 20)));
  }
}
