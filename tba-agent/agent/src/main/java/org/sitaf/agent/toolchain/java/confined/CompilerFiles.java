package org.sitaf.agent.toolchain.java.confined;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.StandardLocation;
import org.jspecify.annotations.Nullable;

/**
 * The compiler's file manager, which sends output classes as messages. Loads classes from the
 * annotation processor path only: without this location javac would search the class path for
 * plugins, and plugins with {@code autoStart} run regardless of {@code -proc}.
 */
final class CompilerFiles extends ForwardingJavaFileManager<JavaFileManager> {
  private final boolean processors;
  private final OutputStream output;

  CompilerFiles(JavaFileManager files, boolean processors, OutputStream output) {
    super(files);
    this.processors = processors;
    this.output = output;
  }

  @Override
  public boolean hasLocation(Location location) {
    return location == StandardLocation.ANNOTATION_PROCESSOR_PATH || super.hasLocation(location);
  }

  @Override
  public @Nullable ClassLoader getClassLoader(Location location) {
    return processors && location == StandardLocation.ANNOTATION_PROCESSOR_PATH
        ? super.getClassLoader(location)
        : new URLClassLoader(new URL[0], ClassLoader.getPlatformClassLoader());
  }

  @Override
  public JavaFileObject getJavaFileForOutput(
      Location location, String className, JavaFileObject.Kind kind, @Nullable FileObject sibling)
      throws IOException {
    if (location != StandardLocation.CLASS_OUTPUT || kind != JavaFileObject.Kind.CLASS) {
      return super.getJavaFileForOutput(location, className, kind, sibling);
    }
    return new ClassMessage(className.replace('.', '/') + ".class");
  }

  private final class ClassMessage extends SimpleJavaFileObject {
    private final String path;

    ClassMessage(String path) {
      super(URI.create("class:/"), Kind.CLASS);
      this.path = path;
    }

    @Override
    public OutputStream openOutputStream() {
      return new ByteArrayOutputStream() {
        @Override
        public void close() throws IOException {
          Wire.write(
              output,
              Wire.CLASS,
              path.getBytes(java.nio.charset.StandardCharsets.UTF_8),
              toByteArray());
        }
      };
    }
  }
}
