package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.util.Set;
import java.util.concurrent.CancellationException;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import org.jspecify.annotations.Nullable;

/**
 * Ends a compilation that nobody waits for any more: javac cannot be interrupted, but it asks for
 * files all the time.
 */
final class AbortableFiles extends ForwardingJavaFileManager<JavaFileManager> {
  private volatile boolean aborted;

  AbortableFiles(JavaFileManager files) {
    super(files);
  }

  void abort() {
    aborted = true;
  }

  private void check() {
    if (aborted) {
      throw new CancellationException("nobody waits for this compilation");
    }
  }

  @Override
  public Iterable<JavaFileObject> list(
      Location location, String packageName, Set<JavaFileObject.Kind> kinds, boolean recurse)
      throws IOException {
    check();
    return super.list(location, packageName, kinds, recurse);
  }

  @Override
  public JavaFileObject getJavaFileForOutput(
      Location location, String className, JavaFileObject.Kind kind, @Nullable FileObject sibling)
      throws IOException {
    check();
    return super.getJavaFileForOutput(location, className, kind, sibling);
  }
}
