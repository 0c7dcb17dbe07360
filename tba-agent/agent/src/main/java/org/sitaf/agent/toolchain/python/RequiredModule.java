package org.sitaf.agent.toolchain.python;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.python.environment.Requirements;
import org.sitaf.core.activity.ActivityProfile.Component;

/** The module of a component's class. */
final class RequiredModule {
  /** Constructs by which a module defines names that its text does not show. */
  private static final Pattern DYNAMIC_NAMES =
      Pattern.compile(
          // Not \\s, which would also match line breaks and take quadratic time.
          "^[ \\t]*from[ \\t]+\\S+[ \\t]+import[ \\t]+\\*|\\b__getattr__\\b", Pattern.MULTILINE);

  private static final Pattern CLASS =
      Pattern.compile("^class\\s+([A-Za-z_][A-Za-z0-9_]*)", Pattern.MULTILINE);
  private static final int MAX_LISTED = 10;

  private RequiredModule() {}

  /** Checks that the component's module exists, unless a package may contain it. */
  static void check(Compilation compilation, Component component, Map<String, String> roots)
      throws CompilationException, IOException {
    String qualified = component.className();
    int dot = qualified.lastIndexOf('.');
    String module = qualified.substring(0, Math.max(0, dot)).replace('.', '/');
    String name = qualified.substring(dot + 1);
    for (Map.Entry<String, String> root : roots.entrySet()) {
      for (String file : List.of(module + ".py", module + "/__init__.py")) {
        Path source = compilation.output().resolve(root.getValue()).resolve(file);
        if (Files.isRegularFile(source)) {
          String text = Files.readString(source, StandardCharsets.ISO_8859_1);
          if (!Pattern.compile("\\b" + Pattern.quote(name) + "\\b").matcher(text).find()
              && !DYNAMIC_NAMES.matcher(text).find()) {
            throw missing(
                qualified,
                root.getKey()
                    + file
                    + " does not define "
                    + name
                    + classes(text)
                    + "; name one of the component's classes, as MODULE.CLASS");
          }
          return;
        }
      }
      if (isExtension(compilation.output().resolve(root.getValue()).resolve(module))) {
        return;
      }
    }
    boolean fetched =
        component.packageName() != null
            || (component.library() != null && Requirements.isWheel(component.library()));
    if (!fetched) {
      throw missing(
          qualified,
          "there is no "
              + module
              + ".py below "
              + String.join(", ", roots.keySet())
              + "; write the module that defines "
              + name
              + ", then the class: MODULE."
              + name);
    }
  }

  /** Lists the classes of a module, for the error message. */
  private static String classes(String text) {
    List<String> names =
        CLASS.matcher(text).results().map(found -> found.group(1)).limit(MAX_LISTED).toList();
    return names.isEmpty() ? ", and no class at all" : "; it defines " + String.join(", ", names);
  }

  /** Whether a module is compiled, so that its classes cannot be listed. */
  private static boolean isExtension(Path module) throws IOException {
    Path folder = module.getParent();
    if (folder == null || !Files.isDirectory(folder)) {
      return false;
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> file.getFileName().toString())
          .anyMatch(file -> file.startsWith(module.getFileName() + ".") && file.endsWith(".so"));
    }
  }

  private static CompilationException missing(String qualified, String reason) {
    return new CompilationException(
        "the component's class does not exist",
        List.of(
            SourceDiagnostic.ofFile(
                "activity/activity.yaml", "component.class: " + qualified + ": " + reason)));
  }
}
