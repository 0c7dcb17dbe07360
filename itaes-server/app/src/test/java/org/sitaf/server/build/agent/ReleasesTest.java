package org.sitaf.server.build.agent;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class ReleasesTest {
  @Test
  void oneReleaseApartIsNearEnoughEitherWay() {
    for (String agent : new String[] {"0.3.9", "0.4.0", "0.5.1-rc1", "development"}) {
      assertThatCode(() -> Releases.requireNear(agent, "0.4.2")).doesNotThrowAnyException();
    }
  }

  @Test
  void whoIsFurtherApartLearnsWhichToReplace() {
    assertThatThrownBy(() -> Releases.requireNear("0.2.0", "0.4.0"))
        .hasMessageContaining("bring the agent up to date");
    assertThatThrownBy(() -> Releases.requireNear("1.0.0", "0.4.0"))
        .hasMessageContaining("bring the server up to date");
  }
}
