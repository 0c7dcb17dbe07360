package org.sitaf.cli.explain;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.explain.report.Bundle;

class BundlesTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "1.5; `1.5`",
        "a|b; `a\\|b`",
        "`<img src=x>`; `'<img src=x>'`",
      })
  void aValueStaysInItsCell(String value, String cell) {
    assertThat(Bundle.code(value, ExplanationText.SENTENCES)).isEqualTo(cell);
    assertThat(Bundle.code("a\n\n# Title\u001b[2J", ExplanationText.SENTENCES))
        .isEqualTo("`a\\u000a\\u000a# Title\\u001b[2J`");
  }
}
