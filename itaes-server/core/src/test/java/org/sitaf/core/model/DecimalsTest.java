package org.sitaf.core.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DecimalsTest {
  @Test
  void parsesTheLongestNumbersOfADouble() {
    assertThat(Decimals.parse(" 1.5 ")).isEqualByComparingTo("1.5");
    String largest = new BigDecimal(Double.MAX_VALUE).toPlainString();
    assertThat(Decimals.parse("-" + largest).doubleValue()).isEqualTo(-Double.MAX_VALUE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "x", "1e999999999", "1e-999999999", "NaN"})
  void refusesOtherTexts(String text) {
    assertThatThrownBy(() -> Decimals.parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageEndingWith("is not a number");
  }

  /** Parsing ten million digits takes many minutes of a thread that nothing interrupts. */
  @Test
  @Timeout(20)
  void refusesManyDigitsAtOnce() {
    assertThatThrownBy(() -> Decimals.parse("9".repeat(10_000_000)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("'99999999999999999999...' has more than 820 characters and is not a number");
  }
}
