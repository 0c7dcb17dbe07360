package org.sitaf.server.webhook;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.network.OutboundHosts;

class TargetTest {
  private final Target target =
      new Target(
          new WebhookSettings(List.of("ci.example.org", "*.hooks.example", "localhost"), false));

  @ParameterizedTest
  @ValueSource(
      strings = {
        "https://ci.example.org/hook",
        "http://CI.example.org:8080/hook?x=1",
        "https://a.b.hooks.example/"
      })
  void listedHostsAreAllowed(String url) {
    assertThat(target.verify(url)).hasToString(url);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "https://example.org/",
        "https://evilci.example.org/",
        "https://ci.example.org.evil.example/",
        "https://hooks.example/",
        "https://user@ci.example.org/",
        "https://ci.example.org@evil.example/",
        "https://169.254.169.254/latest/meta-data",
        "ftp://ci.example.org/",
        "file:///etc/passwd",
        "//ci.example.org/",
        "https:/ci.example.org",
        "not an address"
      })
  void otherUrlsAreRejected(String url) {
    assertThatThrownBy(() -> target.verify(url)).isInstanceOf(RequestException.class);
  }

  @Test
  void listedHostWithLoopbackAddressIsRejected() {
    assertThatThrownBy(() -> target.resolve("localhost"))
        .isInstanceOf(UnknownHostException.class)
        .hasMessageContaining("not a public address");
    assertThatThrownBy(() -> target.resolve("127.0.0.1"))
        .isInstanceOf(UnknownHostException.class)
        .hasMessageContaining("not allowed");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "127.0.0.1",
        "10.1.2.3",
        "172.16.0.1",
        "192.168.1.1",
        "169.254.169.254",
        "100.64.0.1",
        "0.0.0.0",
        "0.1.2.3",
        "224.0.0.1",
        "240.0.0.1",
        "255.255.255.255",
        "::1",
        "::",
        "fe80::1",
        "fc00::1",
        "fd12::1",
        "ff02::1",
        "64:ff9b::a00:1",
        "2002:a00:1::",
        "::ffff:10.0.0.1",
        "::10.0.0.1"
      })
  void privateAddressesAreRecognized(String address) throws UnknownHostException {
    assertThat(OutboundHosts.isPrivate(InetAddress.getByName(address))).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"192.0.2.1", "8.8.8.8", "100.128.0.1", "172.32.0.1", "2606:4700::1111"})
  void publicAddressesAreRecognized(String address) throws UnknownHostException {
    assertThat(OutboundHosts.isPrivate(InetAddress.getByName(address))).isFalse();
  }
}
