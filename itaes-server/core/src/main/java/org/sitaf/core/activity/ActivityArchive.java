package org.sitaf.core.activity;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.LocalDateTime;
import java.util.LinkedHashMap;
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

  private static final LocalDateTime TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

  private ActivityArchive() {}

  /**
   * Unpacks an archive in memory. Where everything lies in one folder, the tree begins inside it.
   *
   * @throws InvalidInputException when it is not a zip, a path leaves the archive, or it is too
   *     large
   */
  public static FileTree read(InputStream zip, String name) {
    Map<String, byte[]> files = new LinkedHashMap<>();
    long size = 0;
    try (ZipInputStream in = new ZipInputStream(zip, StandardCharsets.UTF_8)) {
      for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
        if (entry.isDirectory()) {
          continue;
        }
        String path = entry.getName();
        if (files.size() >= MAX_FILES) {
          throw InvalidInputException.of(
              name,
              "holds more than " + MAX_FILES + " files; leave out what the test does not need");
        }
        byte[] content = content(in, MAX_SIZE - size, name);
        size += content.length;
        if (files.put(FileTree.requireSafe(path), content) != null) {
          throw InvalidInputException.of(name, "holds '" + path + "' twice");
        }
      }
      if (files.isEmpty()) {
        throw InvalidInputException.of(name, "is not a zip archive, or holds no file");
      }
      return withoutCommonFolder(FileTree.of(files));
    } catch (ZipException e) {
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

  private static byte[] content(InputStream in, long limit, String name) throws IOException {
    ByteArrayOutputStream content = new ByteArrayOutputStream();
    byte[] buffer = new byte[1 << 16];
    for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
      if (content.size() + (long) n > limit) {
        throw InvalidInputException.of(
            name,
            "unpacks to more than "
                + (MAX_SIZE >> 20)
                + " MiB; leave out what the test does not need");
      }
      content.write(buffer, 0, n);
    }
    return content.toByteArray();
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
