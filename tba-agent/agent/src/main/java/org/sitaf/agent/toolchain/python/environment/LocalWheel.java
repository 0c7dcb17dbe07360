package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.python.environment.WheelCollection.PackageException;

/**
 * A wheel that does not come from the package index: part of the activity, or built here.
 *
 * @param origin the wheel itself, or the source archive that it was built from
 * @param name normalized name
 * @param requires requirement lines that name packages of the index
 */
record LocalWheel(Path file, Path origin, String name, String version, List<String> requires) {
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,99}");
  private static final Pattern VERSION = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._+!]{0,99}");
  private static final Pattern FILE =
      Pattern.compile("[A-Za-z0-9_.]{1,100}(-[A-Za-z0-9_.+!]{1,100}){4,5}\\.whl");
  private static final int MAX_REQUIRED = 200;
  private static final int MAX_WHEELS = 2000;

  LocalWheel {
    requires = List.copyOf(requires);
  }

  /**
   * Reads a wheel's metadata, in the sandbox.
   *
   * @throws PackageException if the file is not a wheel or requires anything but packages of the
   *     index
   */
  static LocalWheel read(Path file, Path environment, PackageTools tools)
      throws IOException, InterruptedException, PackageException {
    String title = file.getFileName().toString();
    ToolResult answer =
        tools.runScript(
            environment, tools.folder(), false, List.of(file), "wheel", file.toString());
    if (answer.code() != 0) {
      throw new PackageException(title + ": " + tools.errorOf(answer));
    }
    String name = "";
    String version = "";
    List<String> requires = new ArrayList<>();
    for (String line : answer.output().lines().toList()) {
      int tab = line.indexOf('\t');
      String value = line.substring(tab + 1);
      switch (line.substring(0, Math.max(0, tab))) {
        case "name" -> name = value;
        case "version" -> version = value;
        case "requires" -> requirement(value, title).forEach(requires::add);
        default -> throw new PackageException(title + " cannot be read");
      }
    }
    if (!NAME.matcher(name).matches() || !VERSION.matcher(version).matches()) {
      throw new PackageException(title + ": its metadata lack name or version");
    }
    if (requires.size() > MAX_REQUIRED) {
      throw new PackageException(title + " requires more than " + MAX_REQUIRED + " packages");
    }
    return new LocalWheel(file, file, WheelCollection.normalized(name), version, requires);
  }

  /** A copy that was built from a source archive. */
  LocalWheel builtFrom(Path archive) {
    return new LocalWheel(file, archive, name, version, requires);
  }

  /** Converts a requirement to a line for pip; empty for a requirement of an extra. */
  static Stream<String> requirement(String text, String of) throws PackageException {
    int semicolon = text.indexOf(';');
    String marker = semicolon < 0 ? "" : text.substring(semicolon + 1).strip();
    if (marker.matches(".*\\bextra\\b.*")) {
      return Stream.empty();
    }
    // Older wheels write versions in parentheses.
    String wanted =
        (semicolon < 0 ? text : text.substring(0, semicolon)).replaceAll("[()]", " ").strip();
    String line = marker.isEmpty() ? wanted : wanted + " ; " + marker;
    if (!Requirements.isPackage(line)) {
      throw new PackageException(
          of
              + " requires '"
              + text.substring(0, Math.min(200, text.length()))
              + "', which is not a package of the index; add it as a wheel to 'libraries:'");
    }
    return Stream.of(line);
  }

  /** Writes an empty wheel of the given name and version without requirements. */
  Path writeStub(Path folder) throws IOException {
    String title = name.replace('-', '_') + "-" + version;
    String info = title + ".dist-info/";
    Path stub = folder.resolve(title + "-py3-none-any.whl");
    try (OutputStream output = Files.newOutputStream(stub);
        ZipOutputStream zip = new ZipOutputStream(output)) {
      entry(
          zip,
          info + "METADATA",
          "Metadata-Version: 2.1\nName: " + name + "\nVersion: " + version + "\n");
      entry(
          zip,
          info + "WHEEL",
          "Wheel-Version: 1.0\nGenerator: sitaf\nRoot-Is-Purelib: true\nTag: py3-none-any\n");
      entry(zip, info + "RECORD", info + "METADATA,,\n" + info + "WHEEL,,\n" + info + "RECORD,,\n");
    }
    return stub;
  }

  private static void entry(ZipOutputStream zip, String name, String text) throws IOException {
    zip.putNextEntry(new ZipEntry(name));
    zip.write(text.getBytes(StandardCharsets.UTF_8));
  }

  /** The wheels in an untrusted folder: regular files with a wheel's name. */
  static List<Path> wheelsIn(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .limit(MAX_WHEELS)
          .filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS))
          .filter(file -> FILE.matcher(file.getFileName().toString()).matches())
          .sorted()
          .toList();
    }
  }
}
