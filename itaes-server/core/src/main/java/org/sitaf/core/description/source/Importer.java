package org.sitaf.core.description.source;

/** Reads one kind of interface files. */
public interface Importer {
  /** Whether a file of this path is of the kind, by its name. */
  boolean takes(String path);

  /**
   * Reads files of the kind. Whatever is wrong with them becomes a diagnostic; nothing is thrown.
   *
   * @param files of which it is asked for such that it takes
   */
  void read(SourceFiles files, Findings findings);
}
