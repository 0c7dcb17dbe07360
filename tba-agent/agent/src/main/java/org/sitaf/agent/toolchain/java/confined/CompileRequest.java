package org.sitaf.agent.toolchain.java.confined;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A compiler request. It comes from the agent and needs no validation.
 *
 * @param libraries jars in the order of the class path, without those of the runtime
 * @param component the class under test
 * @param harnessPackage prefix of generated classes with a trailing dot, or empty
 */
record CompileRequest(
    List<MemorySource> sources, List<File> libraries, String component, String harnessPackage) {

  /** Reads a request; jars are stored in the folder. */
  static CompileRequest read(InputStream input, Path folder) throws IOException {
    Wire.Reader reader = new Wire.Reader(input, Long.MAX_VALUE);
    List<MemorySource> sources = new ArrayList<>();
    List<File> libraries = new ArrayList<>();
    String component = "";
    String harnessPackage = "";
    while (true) {
      Wire.Message message = reader.next();
      switch (message.word()) {
        case Wire.JAR -> {
          Path jar = folder.resolve(message.text(0));
          Files.createDirectories(jar.getParent());
          Files.write(jar, message.bytes(1));
        }
        case Wire.CLASS_PATH -> libraries.add(folder.resolve(message.text(0)).toFile());
        case Wire.SOURCE ->
            sources.add(new MemorySource(message.number(0), message.text(1), message.text(2)));
        case Wire.COMPONENT -> {
          component = message.text(0);
          harnessPackage = message.text(1);
        }
        case Wire.COMPILE -> {
          return new CompileRequest(sources, libraries, component, harnessPackage);
        }
        default -> throw new Wire.ProtocolException("'" + message.word() + "' is not a request");
      }
    }
  }
}
