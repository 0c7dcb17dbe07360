package org.sitaf.agent.sandbox;

import java.nio.file.Path;
import java.util.List;

/**
 * What a process and all that it starts may write together in its writable folders.
 *
 * @param mebibytes total apparent size of all files (a sparse file counts with its full length)
 * @param files number of files, folders and other entries
 */
public record DiskLimits(int mebibytes, int files) {
  /** The limits for a component. */
  public static final DiskLimits COMPONENT = new DiskLimits(512, 20_000);

  /** A process may write several files of the largest allowed size. */
  private static final int FILES_OF_FULL_SIZE = 2;

  public DiskLimits {
    if (mebibytes < 1 || files < 1) {
      throw new IllegalArgumentException("limits must be positive");
    }
  }

  /** Whether a folder holds more than allowed. The folder should no longer change. */
  public boolean areExceededBy(Path folder) {
    TreeSize size = new TreeSize(this).with(List.of(folder));
    return size.bytes() > bytes() || size.files() > files || size.isTooDeep();
  }

  /** Twice the largest file, and at least as many files per MiB as {@link #COMPONENT}. */
  static DiskLimits of(ProcessLimits limits) {
    int mebibytes = FILES_OF_FULL_SIZE * limits.fileMiB();
    long files = (long) mebibytes * COMPONENT.files / COMPONENT.mebibytes;
    return new DiskLimits(mebibytes, (int) Math.max(COMPONENT.files, files));
  }

  long bytes() {
    return (long) mebibytes << 20;
  }
}
