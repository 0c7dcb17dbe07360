package org.sitaf.agent.sandbox;

import java.nio.file.Path;
import java.util.List;

/**
 * What a process and all that it starts may write together, in the folders that it is given.
 *
 * @param mebibytes of all files, as long as they say they are
 * @param files folders and all else among them
 */
public record DiskLimits(int mebibytes, int files) {
  /** What the processes of a component may write. */
  public static final DiskLimits COMPONENT = new DiskLimits(512, 20_000);

  /** A process writes several files of the size that it may give to one. */
  private static final int FILES_OF_FULL_SIZE = 2;

  public DiskLimits {
    if (mebibytes < 1 || files < 1) {
      throw new IllegalArgumentException("limits must be above 0");
    }
  }

  /** Whether more lies in a folder; nobody writes to it any more, or it does not matter. */
  public boolean areExceededBy(Path folder) {
    TreeSize size = new TreeSize(this).with(List.of(folder));
    return size.bytes() > bytes() || size.files() > files || size.isTooDeep();
  }

  /** Twice the largest file, and as many files for each MiB as {@link #COMPONENT} has. */
  static DiskLimits of(ProcessLimits limits) {
    int mebibytes = FILES_OF_FULL_SIZE * limits.fileMiB();
    long files = (long) mebibytes * COMPONENT.files / COMPONENT.mebibytes;
    return new DiskLimits(mebibytes, (int) Math.max(COMPONENT.files, files));
  }

  long bytes() {
    return (long) mebibytes << 20;
  }
}
