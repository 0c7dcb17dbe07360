package org.sitaf.agent.toolchain.java;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticListener;
import javax.tools.JavaFileObject;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;

/** Collects a compiler's errors; warnings do not keep a test from running and are left out. */
final class DiagnosticCollection implements DiagnosticListener<JavaFileObject> {
  private static final int AT_MOST = 100;

  private final List<SourceDiagnostic> errors = new ArrayList<>();
  private int count;

  @Override
  public synchronized void report(Diagnostic<? extends JavaFileObject> diagnostic) {
    if (diagnostic.getKind() == Diagnostic.Kind.ERROR && ++count <= AT_MOST) {
      JavaSource source = diagnostic.getSource() instanceof JavaSource own ? own : null;
      errors.add(
          new SourceDiagnostic(
              source == null ? "" : source.path(),
              position(diagnostic.getLineNumber()),
              position(diagnostic.getColumnNumber()),
              diagnostic.getMessage(Locale.ROOT),
              source != null && source.generated()));
    }
  }

  synchronized boolean isEmpty() {
    return errors.isEmpty();
  }

  /**
   * The errors as one failure; what is the user's comes first, because that is where it can be
   * mended.
   */
  synchronized CompilationException failure() {
    List<SourceDiagnostic> sorted = new ArrayList<>(errors);
    sorted.sort(java.util.Comparator.comparing(SourceDiagnostic::generated));
    String what =
        errors.stream().allMatch(SourceDiagnostic::generated)
            ? "the component does not fit the generated test application"
            : "the sources do not compile";
    String number = count == 1 ? "1 error" : count + " errors";
    return new CompilationException(what + ": " + number + "; " + firstLine(sorted), sorted);
  }

  private static String firstLine(List<SourceDiagnostic> sorted) {
    return sorted.get(0).toString().lines().findFirst().orElse("");
  }

  private static int position(long fromJavac) {
    return fromJavac == Diagnostic.NOPOS ? 0 : (int) Math.min(fromJavac, Integer.MAX_VALUE);
  }
}
