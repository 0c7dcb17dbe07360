package org.sitaf.server.access.web;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.sitaf.server.access.AccessSettings;
import org.springframework.mock.env.MockEnvironment;

class TransportCheckTest {
  private static final String LAUNCHER = "x".repeat(40);

  private final MockEnvironment environment =
      new MockEnvironment()
          .withProperty("server.address", "127.0.0.1")
          .withProperty("spring.grpc.server.address", "::1");

  @Test
  void loopbackNeedsNoTls() {
    assertThatCode(() -> check(LAUNCHER, false)).doesNotThrowAnyException();
  }

  @Test
  void otherAddressesNeedTls() {
    environment.setProperty("server.address", "0.0.0.0");
    assertThatThrownBy(() -> check(null, false)).hasMessageContaining("server.address is 0.0.0.0");
    environment.setProperty("server.ssl.bundle", "web");
    assertThatCode(() -> check(null, false)).doesNotThrowAnyException();
    environment.setProperty("spring.grpc.server.address", "192.0.2.7");
    assertThatThrownBy(() -> check(null, false))
        .hasMessageContaining("spring.grpc.server.address is 192.0.2.7");
    environment.setProperty("spring.grpc.server.ssl.bundle", "web");
    assertThatCode(() -> check(null, false)).doesNotThrowAnyException();
  }

  @Test
  void plaintextCanBeAllowedExceptWithALauncherToken() {
    environment.setProperty("server.address", "0.0.0.0");
    assertThatCode(() -> check(null, true)).doesNotThrowAnyException();
    assertThatThrownBy(() -> check(LAUNCHER, true)).hasMessageContaining("launcher");
  }

  @Test
  void missingAddressMeansAllInterfaces() {
    MockEnvironment nothing = new MockEnvironment();
    assertThatThrownBy(() -> new TransportCheck(nothing, settings(null, false)))
        .isInstanceOf(InsecureTransportException.class);
  }

  private void check(@Nullable String launcher, boolean plaintext) {
    new TransportCheck(environment, settings(launcher, plaintext));
  }

  private static AccessSettings settings(@Nullable String launcher, boolean plaintext) {
    return new AccessSettings(launcher, null, plaintext, Duration.ofDays(1), 12);
  }
}
