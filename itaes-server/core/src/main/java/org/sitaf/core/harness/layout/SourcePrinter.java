package org.sitaf.core.harness.layout;

import com.samskivert.mustache.Mustache;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.function.UnaryOperator;

/** Prints views of generated sources with the templates of a language, and lays the result out. */
public final class SourcePrinter {
  private static final Mustache.Compiler TEMPLATES =
      Mustache.compiler().escapeHTML(false).emptyStringIsFalse(true);

  private final Class<?> language;
  private final UnaryOperator<String> layout;

  /**
   * Creates a printer.
   *
   * @param language a class of the package that contains the templates
   * @param layout breaks the lines of a printed source
   */
  public SourcePrinter(Class<?> language, UnaryOperator<String> layout) {
    this.language = language;
    this.layout = layout;
  }

  /** A source file in UTF-8. */
  public byte[] print(String template, Object view) {
    return layout.apply(printed(template, view)).getBytes(StandardCharsets.UTF_8);
  }

  private String printed(String template, Object view) {
    try (InputStream stream = language.getResourceAsStream(template + ".mustache")) {
      return TEMPLATES
          .compile(
              new InputStreamReader(
                  Objects.requireNonNull(stream, template), StandardCharsets.UTF_8))
          .execute(view);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
