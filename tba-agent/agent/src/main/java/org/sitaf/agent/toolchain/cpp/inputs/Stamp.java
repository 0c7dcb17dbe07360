package org.sitaf.agent.toolchain.cpp.inputs;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * Metadata of a file or folder. Differs after each change, because users cannot set the change
 * time. All zero for a missing file.
 *
 * @param modified in nanoseconds
 * @param changed in nanoseconds
 */
record Stamp(long size, long modified, long changed, long inode) {
  static final Stamp NONE = new Stamp(0, 0, 0, 0);

  /** File systems use clocks of coarse resolution. */
  private static final long STEP_NANOS = TimeUnit.SECONDS.toNanos(2);

  static Stamp of(String path) {
    try {
      Map<String, Object> found =
          Files.readAttributes(Path.of(path), "unix:size,lastModifiedTime,ctime,ino");
      return new Stamp(
          (Long) found.get("size"),
          nanos(found.get("lastModifiedTime")),
          nanos(found.get("ctime")),
          (Long) found.get("ino"));
    } catch (IOException e) {
      return NONE;
    }
  }

  private static long nanos(Object time) {
    return ((FileTime) time).to(TimeUnit.NANOSECONDS);
  }

  /** Whether the file may have changed after a time in milliseconds since 1970. */
  boolean mayBeYoungerThan(long millis) {
    return changed > TimeUnit.MILLISECONDS.toNanos(millis) - STEP_NANOS;
  }

  void write(DataOutputStream out) throws IOException {
    out.writeLong(size);
    out.writeLong(modified);
    out.writeLong(changed);
    out.writeLong(inode);
  }

  static Stamp read(DataInputStream in) throws IOException {
    return new Stamp(in.readLong(), in.readLong(), in.readLong(), in.readLong());
  }
}
