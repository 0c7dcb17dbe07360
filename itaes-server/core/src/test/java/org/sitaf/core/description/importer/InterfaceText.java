package org.sitaf.core.description.importer;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.Diagnostic;

/** Interface files as text in, descriptions as text out, for tests. */
public final class InterfaceText {
  private InterfaceText() {}

  /** Reads one file. */
  public static ImportResult read(String path, String text) {
    return InterfaceFiles.read(SourceFiles.of("test", bytes(Map.of(path, text)), List.of(path)));
  }

  /** Reads some of several files. */
  public static ImportResult read(Map<String, String> files, String... requested) {
    return InterfaceFiles.read(SourceFiles.of("test", bytes(files), List.of(requested)));
  }

  /** Reads every interface file. */
  public static ImportResult readAll(Map<String, String> files) {
    return InterfaceFiles.readAll("test", bytes(files));
  }

  /** Methods as {@code returned name(direction type name, ...)}. */
  public static List<String> prototypes(InterfaceDescription description) {
    return description.methods().stream().map(InterfaceText::prototype).toList();
  }

  /** Diagnostics as compilers print them. */
  public static List<String> lines(ImportResult result) {
    return result.diagnostics().stream().map(Diagnostic::toString).toList();
  }

  private static String prototype(Method method) {
    return method.returnType().typeName()
        + " "
        + method.name()
        + method.parameters().stream()
            .map(p -> p.direction() + " " + p.type().typeName() + " " + p.name())
            .collect(Collectors.joining(", ", "(", ")"));
  }

  private static Map<String, byte[]> bytes(Map<String, String> files) {
    Map<String, byte[]> bytes = new HashMap<>();
    files.forEach((path, text) -> bytes.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return bytes;
  }
}
