import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import javax.tools.ToolProvider;

/** Two versions of a C++ library and of a Java library. */
final class Libraries {
  private Libraries() {}

  static Path write(Path folder) throws IOException, InterruptedException {
    Files.createDirectories(folder);
    for (int version = 0; version < 2; version++) {
      Path source = folder.resolve("extra" + version + ".cpp");
      Files.writeString(source, "int extra() { return " + (60 + version) + "; }\n");
      Path object = folder.resolve("extra.o");
      run(folder, List.of("g++", "-fPIC", "-c", source.toString(), "-o", object.toString()));
      run(folder, List.of("ar", "rcD", folder.resolve("extra" + version + ".a").toString(), object.toString()));
      Path classes = Files.createDirectories(folder.resolve("classes" + version));
      Path java = Files.createDirectories(classes.resolve("extra")).resolve("Extra.java");
      Files.writeString(java, "package extra;\npublic class Extra { public static final int VALUE = " + (70 + version) + "; }\n");
      if (ToolProvider.getSystemJavaCompiler().run(null, null, null, "--release", "17", java.toString()) != 0) {
        throw new IOException("the library cannot be compiled");
      }
      try (OutputStream file = Files.newOutputStream(folder.resolve("extra" + version + ".jar"));
          JarOutputStream jar = new JarOutputStream(file)) {
        jar.putNextEntry(new JarEntry("extra/Extra.class"));
        jar.write(Files.readAllBytes(classes.resolve("extra/Extra.class")));
      }
    }
    return folder;
  }

  private static void run(Path folder, List<String> command) throws IOException, InterruptedException {
    if (new ProcessBuilder(command).directory(folder.toFile()).inheritIO().start().waitFor() != 0) {
      throw new IOException(command + " failed");
    }
  }
}
