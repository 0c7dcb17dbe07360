package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.java.confined.Wire;

/** Reads the compiler's answer: classes, which are written at once, or errors. */
final class CompilerAnswer implements CompilerProcess.Answer {
  private static final int MAX_CLASSES = 50_000;
  private static final int MAX_ERRORS = 100;
  private static final int MAX_MESSAGE = 8000;
  private static final int MAX_NAME = 255;

  private final List<JavaSource> sources;
  private final String component;
  private final Path output;
  private final List<SourceDiagnostic> errors = new ArrayList<>();
  private int classes;

  /**
   * Creates a reader for one answer.
   *
   * @param sources in the order of their numbers in the request
   * @param component the class under test
   * @param output folder for the classes, writable for the agent only
   */
  CompilerAnswer(List<JavaSource> sources, String component, Path output) {
    this.sources = sources;
    this.component = component;
    this.output = output;
  }

  /** The agent cannot write a class, which is not the compiler's fault. */
  static final class OutputException extends IOException {
    private static final long serialVersionUID = 1L;

    OutputException(IOException cause) {
      super("a class cannot be written: " + cause.getMessage(), cause);
    }
  }

  @Override
  public void read(Wire.Reader messages) throws IOException, CompilationException {
    while (true) {
      Wire.Message message = messages.next();
      switch (message.word()) {
        case Wire.CLASS -> write(message.text(0), message.bytes(1));
        case Wire.ERROR -> add(message);
        case Wire.ABSENT -> throw missingClass(text(message, 0));
        case Wire.NOT_A_JAR -> {
          String file = text(message, 0) + " is not a jar";
          throw new CompilationException(
              file, List.of(JavaToolchain.inProfile(file + ": " + text(message, 1))));
        }
        case Wire.GAVE_UP ->
            throw new CompilationException(
                "the compiler failed with " + text(message, 0) + "; simplify the sources",
                List.of());
        case Wire.DONE -> {
          int count = message.number(0);
          if (!errors.isEmpty()) {
            throw failure(count);
          }
          return;
        }
        default -> throw unreadable("'" + message.word() + "'");
      }
    }
  }

  private void write(String path, byte[] content) throws IOException, CompilationException {
    if (++classes > MAX_CLASSES) {
      throw new CompilationException(
          "the sources compile to more than " + MAX_CLASSES + " classes", List.of());
    }
    requireClassFile(path);
    try {
      JavaToolchain.write(output, path, content);
    } catch (IOException e) {
      throw new OutputException(e);
    }
  }

  /** Checks that every part is a Java name, so that the path cannot leave the output folder. */
  private static void requireClassFile(String path) throws IOException {
    if (!path.endsWith(".class")) {
      throw unreadable("a path without .class");
    }
    String className = path.substring(0, path.length() - ".class".length());
    for (String part : className.split("/", -1)) {
      if (part.isEmpty()
          || part.length() > MAX_NAME
          // package-info contains a hyphen.
          || !part.codePoints().allMatch(c -> Character.isJavaIdentifierPart(c) || c == '-')
          || part.codePoints().anyMatch(Character::isIdentifierIgnorable)) {
        throw unreadable("an invalid class name");
      }
    }
  }

  private void add(Wire.Message message) throws IOException {
    if (errors.size() == MAX_ERRORS) {
      throw unreadable("too many errors");
    }
    int number = message.number(0);
    if (number >= sources.size()) {
      throw unreadable("an error in an unknown source");
    }
    JavaSource source = number < 0 ? null : sources.get(number);
    errors.add(
        new SourceDiagnostic(
            source == null ? "" : source.path(),
            Math.max(0, message.number(1)),
            Math.max(0, message.number(2)),
            text(message, 3),
            source != null && source.generated()));
  }

  /** Combines the errors; those in the user's files come first. */
  private CompilationException failure(int count) {
    List<SourceDiagnostic> sorted = new ArrayList<>(errors);
    sorted.sort(Comparator.comparing(SourceDiagnostic::generated));
    String what =
        errors.stream().allMatch(SourceDiagnostic::generated)
            ? CompilationException.MISFIT
            : "the sources do not compile";
    String number = count == 1 ? "1 error" : count + " errors";
    String first = sorted.get(0).toString().lines().findFirst().orElse("");
    return new CompilationException(what + ": " + number + "; " + first, sorted);
  }

  private CompilationException missingClass(String defined) {
    String message =
        "component: class: "
            + component
            + " is neither among the sources nor in the libraries; "
            + (defined.isEmpty()
                ? "there are no sources of the component"
                : "the sources define " + defined);
    return new CompilationException(
        "there is no class " + component, List.of(JavaToolchain.inProfile(message)));
  }

  private static String text(Wire.Message message, int part) throws IOException {
    String text = message.text(part);
    return text.substring(0, Math.min(MAX_MESSAGE, text.length()));
  }

  private static IOException unreadable(String what) {
    return new IOException("the compiler's answer has " + what);
  }
}
