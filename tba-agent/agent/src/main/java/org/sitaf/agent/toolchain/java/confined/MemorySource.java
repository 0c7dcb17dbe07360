package org.sitaf.agent.toolchain.java.confined;

import java.net.URI;
import java.net.URISyntaxException;
import javax.tools.SimpleJavaFileObject;

/** A source in memory, identified by its number in the request. */
final class MemorySource extends SimpleJavaFileObject {
  private final int number;
  private final String text;

  MemorySource(int number, String path, String text) {
    super(uri(path), Kind.SOURCE);
    this.number = number;
    this.text = text;
  }

  int number() {
    return number;
  }

  @Override
  public CharSequence getCharContent(boolean ignoreEncodingErrors) {
    return text;
  }

  private static URI uri(String path) {
    try {
      return new URI("source", null, "/" + path, null);
    } catch (URISyntaxException e) {
      throw new IllegalArgumentException("'" + path + "' is not a valid path of a source", e);
    }
  }
}
