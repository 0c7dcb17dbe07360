package org.sitaf.server.build.agent;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class ReleaseCompatibilityTest {
  @Test
  void oneReleaseApartIsCompatible() {
    for (String agent : new String[] {"0.3.9", "0.4.0", "0.5.1-rc1", "development"}) {
      assertThatCode(() -> ReleaseCompatibility.requireCompatible(agent, "0.4.2"))
          .doesNotThrowAnyException();
    }
  }

  @Test
  void errorNamesTheOlderSide() {
    assertThatThrownBy(() -> ReleaseCompatibility.requireCompatible("0.2.0", "0.4.0"))
        .hasMessageContaining("update the agent");
    assertThatThrownBy(() -> ReleaseCompatibility.requireCompatible("1.0.0", "0.4.0"))
        .hasMessageContaining("update the server");
  }
}
