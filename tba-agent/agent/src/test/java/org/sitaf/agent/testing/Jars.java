package org.sitaf.agent.testing;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/** Creates the jars of users, compiled in the test. */
public final class Jars {
  private Jars() {}

  /**
   * A jar of classes and other entries.
   *
   * @param sources by path
   * @param entries other files by name
   */
  public static Path of(Path folder, Map<String, String> sources, Map<String, String> entries)
      throws IOException {
    Path source = Files.createDirectories(folder.resolve("sources"));
    Path classes = Files.createDirectories(folder.resolve("classes"));
    List<String> arguments = new ArrayList<>(List.of("-proc:none", "-d", classes.toString()));
    for (Map.Entry<String, String> file : sources.entrySet()) {
      Path path = source.resolve(file.getKey());
      Files.createDirectories(path.getParent());
      arguments.add(Files.writeString(path, file.getValue()).toString());
    }
    int code =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, arguments.toArray(String[]::new));
    if (code != 0) {
      throw new IOException("the test's own sources do not compile");
    }
    Map<String, byte[]> all = new TreeMap<>();
    entries.forEach((name, text) -> all.put(name, text.getBytes()));
    try (Stream<Path> files = Files.walk(classes)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        all.put(classes.relativize(file).toString(), Files.readAllBytes(file));
      }
    }
    return write(folder.resolve("made.jar"), new Manifest(), all);
  }

  /** A jar whose manifest has a class path. */
  public static Path naming(Path file, String classPath) throws IOException {
    Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
    manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, classPath);
    return write(file, manifest, Map.of());
  }

  /** A small jar with an entry of the given size in MiB. */
  public static Path bomb(Path file, String entry, int mib) throws IOException {
    byte[] zeros = new byte[1 << 20];
    try (OutputStream output = Files.newOutputStream(file);
        JarOutputStream jar = new JarOutputStream(output)) {
      jar.putNextEntry(new JarEntry(entry));
      for (int i = 0; i < mib; i++) {
        jar.write(zeros);
      }
    }
    return file;
  }

  private static Path write(Path file, Manifest manifest, Map<String, byte[]> entries)
      throws IOException {
    try (OutputStream output = Files.newOutputStream(file);
        JarOutputStream jar = new JarOutputStream(output, manifest)) {
      for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
        jar.putNextEntry(new JarEntry(entry.getKey()));
        jar.write(entry.getValue());
      }
    }
    return file;
  }
}
