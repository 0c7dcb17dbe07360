package org.sitaf.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PrintableTest {
  @Test
  void keepsAndIndentsLines() {
    assertThat(Printable.lines("cannot find symbol\n\tsymbol: x\r\nlocation: y\n", "  "))
        .isEqualTo(
            String.join(
                System.lineSeparator(), "cannot find symbol", "   symbol: x", "  location: y"));
  }

  @Test
  void escapesControlCharacters() {
    assertThat(Printable.lines("a\u001b[2Jb", "")).isEqualTo("a\\u001b[2Jb");
    assertThat(Printable.line("a\nb")).isEqualTo("a\\u000ab");
  }
}
