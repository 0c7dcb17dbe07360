package org.sitaf.core.trajectory;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class TraceCsvTest {
  @Test
  void columnsAreInTheOrderOfTheirNamesAndOfTheNumbersInThem() {
    List<String> names =
        List.of("t", "r[10]", "x", "r[2]", "r[002]", "a10b9", "a10b10", "ranges", "r[9].y", "r[9]");
    List<double[]> columns =
        names.stream().map(n -> new double[] {names.indexOf(n) + 0.5}).toList();
    assertThat(TraceCsv.write(new Trace(0, 1, names, columns)))
        .isEqualTo(
            """
            t,a10b9,a10b10,r[002],r[2],r[9],r[9].y,r[10],ranges,x
            0,5.5,6.5,4.5,3.5,9.5,8.5,1.5,7.5,2.5
            """);
  }
}
