package org.sitaf.server.build.request;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RecordedCasesTest {
  @ParameterizedTest
  @CsvSource({"1, ALL", "100, ALL", "101, NONE", "100000, NONE"})
  void onlySmallSuitesAreRecordedByDefault(int cases, RecordedCases expected) {
    assertThat(RecordedCases.byDefault(cases)).isEqualTo(expected);
  }
}
