package org.sitaf.cli.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.compare.ComparedCase;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceClass;
import org.sitaf.core.compare.NotComparable;

class ComparisonTextTest {
  private static final Difference MOVED =
      new Difference(
          "Drive",
          2,
          false,
          DifferenceClass.TRAJECTORY,
          "robot_x",
          Map.of("speed", "2"),
          "1.0",
          "1.5\u001b[2J",
          0.25,
          "numbers",
          0.5);

  private static String text(Comparison comparison) {
    StringWriter text = new StringWriter();
    ComparisonText.print(comparison, List.of(), new PrintWriter(text));
    return text.toString();
  }

  @Test
  void aGroupShowsItsFirstCaseWithTimeAndValues() {
    List<ComparedCase> cases =
        List.of(
            new ComparedCase("Drive", 1, Map.of("speed", "1")),
            new ComparedCase("Drive", 2, Map.of("speed", "2")));
    assertThat(
            text(new Comparison(cases, List.of(MOVED), List.of(), List.of(), List.of(), List.of())))
        .isEqualToNormalizingNewlines(
            """
            1 case with another motion, first robot_x at 0.25 s where speed = 2
              Drive, case 2
              case 2 (invalid inputs): speed = 2
                BASE robot_x at 0.25 s: 1.0
                NEW  robot_x at 0.25 s: 1.5\\u001b[2J

            2 cases compared, 1 difference in 1 case
            """);
  }

  @Test
  void nothingComparedIsNotNoDifference() {
    NotComparable reason = new NotComparable("Drive", 0, "", "BASE: does not compile");
    assertThat(
            text(
                new Comparison(
                    List.of(), List.of(), List.of(), List.of(), List.of(), List.of(reason))))
        .contains("Drive: BASE: does not compile")
        .endsWith("no case could be compared" + System.lineSeparator());
  }
}
