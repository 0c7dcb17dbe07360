package org.sitaf.core.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sitaf.core.verdict.Coverage;

class LostCoverageTest {
  private static Coverage coverage(int lines, Integer... reached) {
    return new Coverage(
        List.of(
            new Coverage.File(
                "a.py",
                IntStream.rangeClosed(1, lines)
                    .mapToObj(n -> new Coverage.Line(n, Set.of(reached).contains(n), 0, 0))
                    .toList())));
  }

  @Test
  void unchangedLinesThatNoRunOfTheNewVersionExecutesAreLost() {
    LostCoverage lost = new LostCoverage("M");
    // Line 1 of the new version was added; line 4 of the base version was changed.
    LostCoverage.LineMap map = (path, line) -> line == 4 ? 0 : line + 1;
    lost.add(coverage(6, 1, 2, 3, 4, 6), coverage(7, 2), map);
    assertThat(lost.differences())
        .singleElement()
        .satisfies(
            d -> {
              assertThat(d.kind()).isEqualTo(DifferenceClass.COVERAGE_LOST);
              assertThat(d.output()).isEqualTo("a.py");
              assertThat(d.base()).isEqualTo("executes lines 3-4, 7");
            });
    lost.add(coverage(6, 1, 2, 3), coverage(7, 2, 3), map);
    assertThat(lost.differences()).extracting(Difference::base).containsExactly("executes lines 4");
    lost.add(coverage(6), coverage(7), map);
    assertThat(lost.isEmpty()).isTrue();
  }

  @Test
  void aFileOfOneVersionIsNotCompared() {
    LostCoverage lost = new LostCoverage("M");
    lost.add(coverage(3, 1, 2), new Coverage(List.of()), (path, line) -> line);
    assertThat(lost.isEmpty()).isTrue();
  }
}
