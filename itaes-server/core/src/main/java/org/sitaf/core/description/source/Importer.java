package org.sitaf.core.description.source;

/** Reads one format of interface files. */
public interface Importer {
  /** Whether the name of a file has this format. */
  boolean supports(String path);

  /**
   * Reads files of this format. Problems become diagnostics; no exception is thrown.
   *
   * @param files files of which only supported ones are requested
   */
  void read(SourceFiles files, Findings findings);
}
