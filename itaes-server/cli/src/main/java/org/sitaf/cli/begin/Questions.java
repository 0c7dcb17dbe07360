package org.sitaf.cli.begin;

import java.io.Console;
import java.io.PrintWriter;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** Asks for what the options do not say, if a person is at the terminal. */
final class Questions {
  private final @Nullable Console console;
  private final PrintWriter out;

  Questions(@Nullable Console console, PrintWriter out) {
    this.console = console;
    this.out = out;
  }

  /** The answer; empty if nobody can answer, or the answer is empty. */
  Optional<String> ask(String question, String otherwise) {
    if (console == null) {
      return Optional.empty();
    }
    out.print(question + " [" + otherwise + "]: ");
    out.flush();
    String answer = console.readLine();
    return Optional.ofNullable(answer).map(String::strip).filter(a -> !a.isEmpty());
  }
}
