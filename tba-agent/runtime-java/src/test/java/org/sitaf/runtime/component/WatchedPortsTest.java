package org.sitaf.runtime.component;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import org.junit.jupiter.api.Test;

class WatchedPortsTest {
  @Test
  void onlyChangesAreKeptWithTheLastValueOfEachTime() throws Exception {
    WatchedPorts ports = new WatchedPorts();
    Iterator<String> values = List.of("0.0", "0.0", "1.0", "2.0", "2.0", "0.0").iterator();
    ports.watch("speed", values::next, 10);
    for (long now : new long[] {20, 30, 30, 40, 50}) {
      ports.take(now);
    }
    ports.requireRead();
    assertThat(recorded(ports, 30)).containsExactly("speed 0: -20 0.0, 0 2.0, 20 0.0");
    ports.clear();
    assertThat(recorded(ports, 0)).isEmpty();
  }

  @Test
  void changesBeyondTheLimitAreCounted() throws Exception {
    WatchedPorts ports = new WatchedPorts();
    int[] count = {0};
    ports.watch("speed", () -> Integer.toString(count[0]++), 0);
    for (int now = 1; now < WatchedPorts.MOST_CHANGES + 6; now++) {
      ports.take(now);
    }
    assertThat(recorded(ports, 0)).singleElement().asString().startsWith("speed 6: 0 0, 1 1");
  }

  @Test
  void aPortThatThrowsIsReportedAtTheEndOfTheCase() throws Exception {
    WatchedPorts ports = new WatchedPorts();
    Iterator<String> values = List.of("1").iterator();
    ports.watch("speed", values::next, 0);
    ports.take(1);
    ports.take(2);
    assertThatThrownBy(ports::requireRead).isInstanceOf(java.util.NoSuchElementException.class);
    assertThatThrownBy(() -> ports.watch("speed", values::next, 0))
        .isInstanceOf(java.util.NoSuchElementException.class);
  }

  private static List<String> recorded(WatchedPorts ports, long call) {
    List<String> found = new ArrayList<>();
    ports.forEach(
        call,
        (signal, changes, leftOut) ->
            found.add(
                signal
                    + " "
                    + leftOut
                    + ": "
                    + String.join(
                        ", ", changes.stream().map(c -> c.nanos() + " " + c.literal()).toList())));
    return found;
  }
}
