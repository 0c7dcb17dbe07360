package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.zip.ZipException;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.core.harness.TestApplication;

/** The class under test, as the activity's profile names it. */
final class ComponentClass {
  private static final int NAMED_AT_MOST = 8;

  private final String className;
  private final List<Path> libraries;
  private final String harnessPackage;

  ComponentClass(TestApplication application, List<Path> libraries) {
    this.className = application.activity().profile().component().className();
    this.libraries = libraries;
    int lastDot = application.entryPoint().lastIndexOf('.');
    this.harnessPackage = application.entryPoint().substring(0, lastDot + 1);
  }

  /**
   * Checks that somebody defines the class.
   *
   * @param declared the top-level types of the sources
   * @throws CompilationException when neither the sources nor the libraries do
   */
  void requireAmong(Set<String> declared) throws CompilationException, IOException {
    if (declared.stream().anyMatch(this::isOrEncloses) || isInLibrary()) {
      return;
    }
    String there =
        declared.stream()
            .filter(name -> !name.startsWith(harnessPackage) || harnessPackage.isEmpty())
            .limit(NAMED_AT_MOST)
            .collect(Collectors.joining(", "));
    String message =
        "component: class: "
            + className
            + " is neither among the sources nor in the libraries; "
            + (there.isEmpty()
                ? "there are no sources of the component"
                : "the sources define " + there);
    throw new CompilationException(
        "there is no class " + className, List.of(JavaToolchain.inProfile(message)));
  }

  private boolean isOrEncloses(String topLevel) {
    return className.equals(topLevel)
        || className.startsWith(topLevel + ".")
        || className.startsWith(topLevel + "$");
  }

  private boolean isInLibrary() throws IOException, CompilationException {
    String entry = className.replace('.', '/');
    for (Path library : libraries) {
      try (JarFile jar = new JarFile(library.toFile())) {
        // A nested class may be written with dots; its entry has '$' for the last of them.
        for (String name = entry; ; ) {
          if (jar.getEntry(name + ".class") != null) {
            return true;
          }
          int slash = name.lastIndexOf('/');
          if (slash < 0) {
            break;
          }
          name = name.substring(0, slash) + "$" + name.substring(slash + 1);
        }
      } catch (ZipException e) {
        String file = library.getFileName().toString();
        throw new CompilationException(
            file + " is not a jar",
            List.of(JavaToolchain.inProfile(file + " is not a jar: " + e.getMessage())));
      }
    }
    return false;
  }
}
