package org.sitaf.agent.toolchain.java.confined;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.Locale;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticListener;
import javax.tools.JavaFileObject;

/** Sends compiler errors. Warnings are ignored, because they do not prevent a test. */
final class CompilerErrors implements DiagnosticListener<JavaFileObject> {
  private static final int MAX_ERRORS = 100;
  private static final int MAX_MESSAGE_LENGTH = 4000;

  private final OutputStream output;
  private int count;

  CompilerErrors(OutputStream output) {
    this.output = output;
  }

  int count() {
    return count;
  }

  @Override
  public void report(Diagnostic<? extends JavaFileObject> diagnostic) {
    if (diagnostic.getKind() != Diagnostic.Kind.ERROR || ++count > MAX_ERRORS) {
      return;
    }
    int source = diagnostic.getSource() instanceof MemorySource own ? own.number() : -1;
    String message = diagnostic.getMessage(Locale.ROOT);
    try {
      Wire.write(
          output,
          Wire.ERROR,
          Integer.toString(source),
          position(diagnostic.getLineNumber()),
          position(diagnostic.getColumnNumber()),
          message.substring(0, Math.min(MAX_MESSAGE_LENGTH, message.length())));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String position(long fromJavac) {
    return Long.toString(fromJavac == Diagnostic.NOPOS ? 0 : Math.min(fromJavac, 999_999_999));
  }
}
