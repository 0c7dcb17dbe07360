package org.sitaf.core.activity;

import java.io.EOFException;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * Reads and writes activities as ZIP archives. Archives are untrusted input; writing the same files
 * gives the same bytes.
 */
public final class ActivityArchive {
  /** Maximum number of files in an archive. */
  public static final int MAX_FILES = 10_000;

  /** Maximum unpacked size of all files in bytes. */
  public static final long MAX_SIZE = 256L << 20;

  /** Maximum number of entries, including folders. */
  private static final int MAX_ENTRIES = 2 * MAX_FILES;

  /**
   * Maximum compression ratio of an archive that unpacks to more than {@link #MIN_CHECKED} bytes.
   */
  public static final int MAX_RATIO = 100;

  /** The compression ratio of smaller contents is not checked: almost empty files compress well. */
  private static final long MIN_CHECKED = 1L << 20;

  private static final int PIECE = 1 << 16;

  private static final LocalDateTime TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

  private ActivityArchive() {}

  /**
   * Unpacks an archive in memory. If all files are in one top-level folder, this folder is removed
   * from the paths.
   *
   * @throws InvalidInputException if it is not a ZIP archive, a path is unsafe, or it is too large
   */
  public static FileTree read(InputStream zip, String name) {
    return read(zip, name, MAX_SIZE);
  }

  /**
   * Unpacks an archive in memory, with a maximum unpacked size in bytes.
   *
   * @throws InvalidInputException if it is not a ZIP archive, a path is unsafe, or it is too large
   */
  public static FileTree read(InputStream zip, String name, long maxSize) {
    return withoutCommonFolder(readWhole(zip, name, maxSize));
  }

  /**
   * Unpacks an archive in memory, with a top-level folder that contains all files, whose name can
   * be that of a package.
   *
   * @throws InvalidInputException if it is not a ZIP archive, a path is unsafe, or it is too large
   */
  public static FileTree readWhole(InputStream zip, String name, long maxSize) {
    Map<String, byte[]> files = new LinkedHashMap<>();
    Unpacked unpacked = new Unpacked(zip, name, Math.min(maxSize, MAX_SIZE));
    try (ZipInputStream in = new ZipInputStream(unpacked.packed, StandardCharsets.UTF_8)) {
      int entries = 0;
      for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
        if (++entries > MAX_ENTRIES || files.size() >= MAX_FILES) {
          throw InvalidInputException.of(
              name,
              "contains more than %d files or %d files and folders; remove files that the test does not need"
                  .formatted(MAX_FILES, MAX_ENTRIES));
        }
        byte[] content = unpacked.content(in);
        if (entry.isDirectory()) {
          continue;
        }
        if (files.put(FileTree.requireSafe(entry.getName()), content) != null) {
          throw InvalidInputException.of(name, "contains '" + entry.getName() + "' twice");
        }
      }
      if (files.isEmpty()) {
        throw InvalidInputException.of(name, "is not a ZIP archive or contains no file");
      }
      return FileTree.of(files);
    } catch (ZipException | EOFException e) {
      throw InvalidInputException.of(name, "is not a valid ZIP archive: " + e.getMessage());
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of(name, "is rejected: " + e.getMessage());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Writes a file tree as an archive. */
  public static void write(FileTree files, OutputStream out) throws IOException {
    ZipOutputStream zip = new ZipOutputStream(out, StandardCharsets.UTF_8);
    for (String path : files.paths()) {
      byte[] content = files.content(path).orElseThrow();
      ZipEntry entry = new ZipEntry(path);
      entry.setTimeLocal(TIME);
      CRC32 crc = new CRC32();
      crc.update(content);
      entry.setCrc(crc.getValue());
      entry.setSize(content.length);
      zip.putNextEntry(entry);
      zip.write(content);
      zip.closeEntry();
    }
    zip.finish();
  }

  /** Unpacks entries and checks the size limits. */
  private static final class Unpacked {
    private final CountingInputStream packed;
    private final String name;
    private final long most;
    private long size;

    Unpacked(InputStream zip, String name, long most) {
      this.packed = new CountingInputStream(zip);
      this.name = name;
      this.most = most;
    }

    byte[] content(InputStream entry) throws IOException {
      List<byte[]> pieces = new ArrayList<>();
      long before = size;
      byte[] piece = entry.readNBytes(PIECE);
      while (piece.length > 0) {
        size += piece.length;
        require();
        pieces.add(piece);
        piece = entry.readNBytes(PIECE);
      }
      byte[] content = new byte[Math.toIntExact(size - before)];
      int filled = 0;
      for (byte[] part : pieces) {
        System.arraycopy(part, 0, content, filled, part.length);
        filled += part.length;
      }
      return content;
    }

    private void require() {
      if (size > most) {
        throw InvalidInputException.of(
            name,
            "unpacks to more than "
                + (most >> 20)
                + " MiB; remove files that the test does not need");
      }
      if (size > MIN_CHECKED && size > MAX_RATIO * packed.count) {
        throw InvalidInputException.of(
            name,
            "unpacks to more than %d times its size (%d KiB to %d KiB); remove files that are almost empty"
                .formatted(MAX_RATIO, packed.count >> 10, size >> 10));
      }
    }
  }

  /** Counts the bytes read. */
  private static final class CountingInputStream extends FilterInputStream {
    private long count;

    CountingInputStream(InputStream in) {
      super(in);
    }

    @Override
    public int read() throws IOException {
      int read = super.read();
      count += read < 0 ? 0 : 1;
      return read;
    }

    @Override
    public int read(byte[] buffer, int offset, int length) throws IOException {
      int read = super.read(buffer, offset, length);
      count += Math.max(read, 0);
      return read;
    }
  }

  private static FileTree withoutCommonFolder(FileTree tree) {
    if (tree.contains(ActivityReader.PROFILE)) {
      return tree;
    }
    String first = tree.paths().first();
    int slash = first.indexOf('/');
    String folder = slash < 0 ? "" : first.substring(0, slash + 1);
    boolean common = slash > 0 && tree.paths().stream().allMatch(p -> p.startsWith(folder));
    return common ? tree.below(folder) : tree;
  }
}
