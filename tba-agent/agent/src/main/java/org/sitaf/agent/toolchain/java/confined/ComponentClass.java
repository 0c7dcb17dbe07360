package org.sitaf.agent.toolchain.java.confined;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Set;
import java.util.jar.JarFile;
import java.util.stream.Collectors;

/** The class under test, as named in the activity's profile. */
record ComponentClass(CompileRequest request) {
  private static final int MAX_LISTED = 8;

  /**
   * Whether the sources or libraries define the class; otherwise sends a message.
   *
   * @param declared top-level types of the sources
   */
  boolean isAmong(Set<String> declared, OutputStream output) throws IOException {
    if (declared.stream().anyMatch(this::isOrEncloses)) {
      return true;
    }
    for (File library : request.libraries()) {
      try (JarFile jar = new JarFile(library)) {
        if (holds(jar)) {
          return true;
        }
      } catch (IOException e) {
        Wire.write(output, Wire.NOT_A_JAR, library.getName(), String.valueOf(e.getMessage()));
        return false;
      }
    }
    String prefix = request.harnessPackage();
    Wire.write(
        output,
        Wire.ABSENT,
        declared.stream()
            .filter(name -> prefix.isEmpty() || !name.startsWith(prefix))
            .limit(MAX_LISTED)
            .collect(Collectors.joining(", ")));
    return false;
  }

  private boolean isOrEncloses(String topLevel) {
    String className = request.component();
    return className.equals(topLevel)
        || className.startsWith(topLevel + ".")
        || className.startsWith(topLevel + "$");
  }

  /** A nested class may be written with dots; its jar entry separates it with '$'. */
  private boolean holds(JarFile jar) {
    for (String name = request.component().replace('.', '/'); ; ) {
      if (jar.getEntry(name + ".class") != null) {
        return true;
      }
      int slash = name.lastIndexOf('/');
      if (slash < 0) {
        return false;
      }
      name = name.substring(0, slash) + "$" + name.substring(slash + 1);
    }
  }
}
