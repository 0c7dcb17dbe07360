package org.sitaf.agent.manager;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.grpc.InsecureChannelCredentials;
import io.grpc.TlsChannelCredentials;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ServerAccessTest {
  private static final ServerAccess USUAL = new ServerAccess(null, null, false);

  @ParameterizedTest
  @ValueSource(
      strings = {"localhost:9090", "127.0.0.1:9090", "[::1]:9090", "127.0.0.1:1, localhost:2"})
  void usesPlaintextOnTheLoopbackInterface(String server) throws IOException {
    assertThat(USUAL.channelCredentials(server)).isInstanceOf(InsecureChannelCredentials.class);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "sitaf.example:9090",
        "10.0.0.1:9090",
        "localhost.sitaf.example:1",
        "localhost:1,10.0.0.1:2"
      })
  void usesTlsForOtherAddresses(String server) throws IOException {
    assertThat(USUAL.channelCredentials(server)).isInstanceOf(TlsChannelCredentials.class);
    assertThat(new ServerAccess(null, null, true).channelCredentials(server))
        .as("plaintext is allowed explicitly")
        .isInstanceOf(InsecureChannelCredentials.class);
  }

  @Test
  void rejectsCertificatesWithoutTls() {
    assertThatThrownBy(() -> new ServerAccess(null, Path.of("ca.pem"), true))
        .hasMessageContaining("--plaintext and --ca exclude each other");
  }
}
