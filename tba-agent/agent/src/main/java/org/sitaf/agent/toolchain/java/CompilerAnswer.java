package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.java.confined.Wire;

/** What the compiler answers: classes, which are written as they come, or why there are none. */
final class CompilerAnswer implements CompilerProcess.Answer {
  private static final int MOST_CLASSES = 50_000;
  private static final int MOST_ERRORS = 100;
  private static final int LONGEST_MESSAGE = 8000;
  private static final int LONGEST_NAME = 255;

  private final List<JavaSource> sources;
  private final String component;
  private final Path output;
  private final List<SourceDiagnostic> errors = new ArrayList<>();
  private int classes;

  /**
   * An answer.
   *
   * @param sources in the order of their numbers in the request
   * @param component the class under test
   * @param output where classes are written; nobody but the agent writes there
   */
  CompilerAnswer(List<JavaSource> sources, String component, Path output) {
    this.sources = sources;
    this.component = component;
    this.output = output;
  }

  /** The agent cannot write a class; nothing of it is the compiler's fault. */
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
        case Wire.ABSENT -> throw absent(text(message, 0));
        case Wire.NOT_A_JAR -> {
          String file = text(message, 0) + " is not a jar";
          throw new CompilationException(
              file, List.of(JavaToolchain.inProfile(file + ": " + text(message, 1))));
        }
        case Wire.GAVE_UP ->
            throw new CompilationException(
                "the compiler gave up with " + text(message, 0) + "; simplify the sources",
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
    if (++classes > MOST_CLASSES) {
      throw new CompilationException(
          "the sources compile to more than " + MOST_CLASSES + " classes", List.of());
    }
    requireClassFile(path);
    try {
      JavaToolchain.write(output, path, content);
    } catch (IOException e) {
      throw new OutputException(e);
    }
  }

  /** Every part is a name of Java's, so that the path stays below the output. */
  private static void requireClassFile(String path) throws IOException {
    if (!path.endsWith(".class")) {
      throw unreadable("a path without .class");
    }
    String name = path.substring(0, path.length() - ".class".length());
    for (String part : name.split("/", -1)) {
      if (part.isEmpty()
          || part.length() > LONGEST_NAME
          // A package-info has a hyphen.
          || !part.codePoints().allMatch(c -> Character.isJavaIdentifierPart(c) || c == '-')
          || part.codePoints().anyMatch(Character::isIdentifierIgnorable)) {
        throw unreadable("a path that no class has");
      }
    }
  }

  private void add(Wire.Message message) throws IOException {
    if (errors.size() == MOST_ERRORS) {
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

  /**
   * The errors as one failure; what is the user's comes first, because that is where it can be
   * fixed.
   */
  private CompilationException failure(int count) {
    List<SourceDiagnostic> sorted = new ArrayList<>(errors);
    sorted.sort(Comparator.comparing(SourceDiagnostic::generated));
    String what =
        errors.stream().allMatch(SourceDiagnostic::generated)
            ? "the component does not fit the generated test application"
            : "the sources do not compile";
    String number = count == 1 ? "1 error" : count + " errors";
    String first = sorted.get(0).toString().lines().findFirst().orElse("");
    return new CompilationException(what + ": " + number + "; " + first, sorted);
  }

  private CompilationException absent(String defined) {
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
    return text.substring(0, Math.min(LONGEST_MESSAGE, text.length()));
  }

  private static IOException unreadable(String what) {
    return new IOException("its answer has " + what);
  }
}
