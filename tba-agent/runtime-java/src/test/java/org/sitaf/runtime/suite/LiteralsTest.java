package org.sitaf.runtime.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The fast path for numbers gives bit-identical results. */
class LiteralsTest {
  private static final int NUMBERS = 20_000;

  private static String written(Random random) {
    StringBuilder text = new StringBuilder(random.nextBoolean() ? "-" : "");
    text.append("0".repeat(random.nextInt(3)));
    int whole = 1 + random.nextInt(9);
    for (int i = 0; i < whole; i++) {
      text.append((char) ('0' + random.nextInt(10)));
    }
    int decimals = random.nextInt(9);
    for (int i = 0; i < decimals; i++) {
      text.append(i == 0 ? "." : "").append((char) ('0' + random.nextInt(10)));
    }
    return text.toString();
  }

  @Test
  void readsTheNearestFloatingPointNumber() {
    Random random = new Random(7);
    for (int i = 0; i < NUMBERS; i++) {
      String text = written(random);
      double expected = new BigDecimal(text).doubleValue();
      assertThat(Math.abs(Literals.real(text))).as(text).isEqualTo(Math.abs(expected));
      assertThat(Double.compare(Literals.real(text), 0.0) < 0)
          .as(text)
          .isEqualTo(text.startsWith("-"));
    }
  }

  @Test
  void readsIntegersExactly() {
    Random random = new Random(8);
    for (int i = 0; i < NUMBERS; i++) {
      String text = written(random).replaceAll("\\..*", "");
      assertThat(Literals.whole(text, Long.MIN_VALUE, Long.MAX_VALUE))
          .isEqualTo(new BigDecimal(text).longValueExact());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "-", ".", "1.2.3", "--1", "1-", "0x1", "1d", "one"})
  void rejectsTextThatIsNoNumber(String text) {
    assertThatThrownBy(() -> Literals.real(text)).isInstanceOf(CaseDataException.class);
    assertThatThrownBy(() -> Literals.whole(text, 0, 9)).isInstanceOf(CaseDataException.class);
  }
}
