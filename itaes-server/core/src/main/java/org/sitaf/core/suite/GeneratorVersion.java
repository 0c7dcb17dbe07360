package org.sitaf.core.suite;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Objects;
import java.util.Properties;

/** The generator name in suites. */
public final class GeneratorVersion {
  private GeneratorVersion() {}

  /** Name and version, such as {@code sitaf 1.0.0}. */
  public static String current() {
    Properties properties = new Properties();
    try (InputStream in = GeneratorVersion.class.getResourceAsStream("version.properties")) {
      properties.load(Objects.requireNonNull(in));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return "sitaf " + properties.getProperty("version");
  }
}
