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
 * What a file system says of a file or folder; it says something else after each change, since the
 * time of a change cannot be set. All zero where there is no such file.
 *
 * @param modified in nanoseconds
 * @param changed in nanoseconds
 */
record Stamp(long size, long modified, long changed, long inode) {
  static final Stamp NONE = new Stamp(0, 0, 0, 0);

  /** Clocks of file systems go in steps. */
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

  /** Whether the file may have changed after a moment, in milliseconds since 1970. */
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
