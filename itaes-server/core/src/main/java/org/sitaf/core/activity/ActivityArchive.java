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
 * An activity as a zip: untrusted on the way in, the same bytes for the same files on the way out.
 */
public final class ActivityArchive {
  /** Largest number of files in an archive. */
  public static final int MAX_FILES = 10_000;

  /** Largest size of all files together, unpacked, in bytes. */
  public static final long MAX_SIZE = 256L << 20;

  /** Largest number of entries, folders among them. */
  private static final int MAX_ENTRIES = 2 * MAX_FILES;

  /** Beyond {@link #UNSUSPECTED} bytes, how many times its own size an archive may unpack to. */
  public static final int MAX_RATIO = 100;

  /** So much may come of an archive however small it is: a few empty tables, say. */
  private static final long UNSUSPECTED = 1L << 20;

  private static final int PIECE = 1 << 16;

  private static final LocalDateTime TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

  private ActivityArchive() {}

  /**
   * Unpacks an archive in memory. Where everything lies in one folder, the tree begins inside it.
   *
   * @throws InvalidInputException when it is not a zip, a path leaves the archive, or it is too
   *     large
   */
  public static FileTree read(InputStream zip, String name) {
    return read(zip, name, MAX_SIZE);
  }

  /**
   * The same, of at most so many bytes unpacked.
   *
   * @throws InvalidInputException when it is not a zip, a path leaves the archive, or it is too
   *     large
   */
  public static FileTree read(InputStream zip, String name, long maxSize) {
    Map<String, byte[]> files = new LinkedHashMap<>();
    Unpacked unpacked = new Unpacked(zip, name, Math.min(maxSize, MAX_SIZE));
    try (ZipInputStream in = new ZipInputStream(unpacked.packed, StandardCharsets.UTF_8)) {
      int entries = 0;
      for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
        if (++entries > MAX_ENTRIES || files.size() >= MAX_FILES) {
          throw InvalidInputException.of(
              name,
              "holds more than %d files, or %d files and folders; leave out what the test does not need"
                  .formatted(MAX_FILES, MAX_ENTRIES));
        }
        byte[] content = unpacked.content(in);
        if (entry.isDirectory()) {
          continue;
        }
        if (files.put(FileTree.requireSafe(entry.getName()), content) != null) {
          throw InvalidInputException.of(name, "holds '" + entry.getName() + "' twice");
        }
      }
      if (files.isEmpty()) {
        throw InvalidInputException.of(name, "is not a zip archive, or holds no file");
      }
      return withoutCommonFolder(FileTree.of(files));
    } catch (ZipException | EOFException e) {
      throw InvalidInputException.of(name, "is not a readable zip archive: " + e.getMessage());
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of(name, "is refused: " + e.getMessage());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Packs a tree. */
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

  /** What has come out of an archive, held against what went in and against the limits. */
  private static final class Unpacked {
    private final CountedInput packed;
    private final String name;
    private final long most;
    private long size;

    Unpacked(InputStream zip, String name, long most) {
      this.packed = new CountedInput(zip);
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
            "unpacks to more than " + (most >> 20) + " MiB; leave out what the test does not need");
      }
      if (size > UNSUSPECTED && size > MAX_RATIO * packed.count) {
        throw InvalidInputException.of(
            name,
            "unpacks to more than %d times its size: %d KiB have given %d KiB; leave out files that are almost empty"
                .formatted(MAX_RATIO, packed.count >> 10, size >> 10));
      }
    }
  }

  /** Counts what is read through it. */
  private static final class CountedInput extends FilterInputStream {
    private long count;

    CountedInput(InputStream in) {
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
