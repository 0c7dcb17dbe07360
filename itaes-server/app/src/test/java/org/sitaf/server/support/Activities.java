package org.sitaf.server.support;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;

/** The example of the paper's evaluation. */
public final class Activities {
  public static final String MODEL = "GetInfraredData";

  private static final Path EXAMPLES = Path.of("../../examples");

  private Activities() {}

  public static Map<String, byte[]> files() {
    return files("ir-sensor");
  }

  /** The files of another example. */
  public static Map<String, byte[]> files(String example) {
    Path folder = EXAMPLES.resolve(example);
    try (Stream<Path> paths = Files.walk(folder)) {
      Map<String, byte[]> files = new HashMap<>();
      for (Path path : paths.filter(Files::isRegularFile).toList()) {
        files.put(folder.relativize(path).toString(), Files.readAllBytes(path));
      }
      return files;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  public static byte[] zip() {
    return zip(files());
  }

  public static byte[] zip(Map<String, byte[]> files) {
    ByteArrayOutputStream zip = new ByteArrayOutputStream();
    try {
      ActivityArchive.write(FileTree.of(files), zip);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return zip.toByteArray();
  }

  /** A zip with the given entry names, which may be unsafe. */
  public static byte[] rawZip(List<String> names, byte[] content) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      for (String name : names) {
        zip.putNextEntry(new ZipEntry(name));
        zip.write(content);
        zip.closeEntry();
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }
}
