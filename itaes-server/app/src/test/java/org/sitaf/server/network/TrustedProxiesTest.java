package org.sitaf.server.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.server.network.TrustedProxies.Client;

class TrustedProxiesTest {
  private static final String FOR = "X-Forwarded-For";
  private static final String PROTO = "X-Forwarded-Proto";
  private static final String FORWARDED = "Forwarded";

  private final TrustedProxies proxies =
      new TrustedProxies(List.of("10.0.0.0/8", "192.0.2.7", "2001:db8:1::/48"));

  @Test
  void headersOfUntrustedClientsAreIgnored() {
    Map<String, List<String>> headers =
        Map.of(
            FOR,
            List.of("203.0.113.1"),
            PROTO,
            List.of("https"),
            FORWARDED,
            List.of("for=1.2.3.4"));
    assertThat(client("198.51.100.9", headers)).isEqualTo(new Client("198.51.100.9", null));
    assertThat(client("192.0.2.8", headers)).isEqualTo(new Client("192.0.2.8", null));
  }

  @Test
  void headersOfTrustedProxiesAreUsed() {
    assertThat(client("10.1.2.3", Map.of(FOR, List.of("203.0.113.1"), PROTO, List.of("https"))))
        .isEqualTo(new Client("203.0.113.1", true));
    assertThat(
            client(
                "192.0.2.7", Map.of(FORWARDED, List.of("for=\"[2001:db8::5]:4711\";proto=http"))))
        .isEqualTo(new Client("2001:db8:0:0:0:0:0:5", false));
    assertThat(client("2001:db8:1::9", Map.of(FOR, List.of("203.0.113.1:5000"))))
        .isEqualTo(new Client("203.0.113.1", null));
    assertThat(client("10.1.2.3", Map.of())).isEqualTo(new Client("10.1.2.3", null));
  }

  @Test
  void addressesThatTheClientAddedAreIgnored() {
    Client proxy = new Client("10.1.2.3", null);
    assertThat(client("10.1.2.3", Map.of(FOR, List.of("127.0.0.1, 203.0.113.1", "10.9.9.9"))))
        .isEqualTo(new Client("203.0.113.1", null));
    assertThat(
            client(
                "10.1.2.3",
                Map.of(FOR, List.of("203.0.113.1"), FORWARDED, List.of("for=127.0.0.1"))))
        .isEqualTo(proxy);
    assertThat(client("10.1.2.3", Map.of(FOR, List.of("not an address")))).isEqualTo(proxy);
    assertThat(client("10.1.2.3", Map.of(FOR, List.of("localhost")))).isEqualTo(proxy);
  }

  @Test
  void ipv6AddressesAreGroupedByNetwork() {
    assertThat(Addresses.group("2001:db8:5:6:7:8:9:a")).isEqualTo("2001:db8:5:6:0:0:0:0/64");
    assertThat(Addresses.group("2001:db8:5:6::1")).isEqualTo("2001:db8:5:6:0:0:0:0/64");
    assertThat(Addresses.group("::ffff:203.0.113.1")).isEqualTo("203.0.113.1");
    assertThat(Addresses.group("203.0.113.1")).isEqualTo("203.0.113.1");
  }

  @Test
  void invalidRangeIsReported() {
    for (String wrong : List.of("10.0.0.0/33", "proxy.example", "10.0.0.0/x", "::/129", "")) {
      assertThatThrownBy(() -> new TrustedProxies(List.of(wrong)))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("sitaf.trusted-proxies")
          .hasMessageContaining(wrong);
    }
  }

  private Client client(String remote, Map<String, List<String>> headers) {
    return proxies.client(remote, name -> headers.getOrDefault(name, List.of()));
  }
}
