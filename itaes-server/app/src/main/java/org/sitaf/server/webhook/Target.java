package org.sitaf.server.webhook;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.Locale;
import org.apache.hc.client5.http.DnsResolver;
import org.apache.hc.client5.http.SystemDefaultDnsResolver;
import org.sitaf.server.error.RequestException;

/**
 * Prevents server-side request forgery by webhooks. The host name is checked when a webhook is
 * created, and its IP addresses are checked each time a message is sent; the connection uses the
 * checked addresses.
 */
final class Target implements DnsResolver {
  private static final int SHARED_FIRST = 100;
  private static final int SHARED_SECOND_MASK = 0xC0;
  private static final int SHARED_SECOND = 64;
  private static final int UNIQUE_LOCAL_MASK = 0xFE;
  private static final int UNIQUE_LOCAL = 0xFC;
  private static final int MAX_LENGTH = 2000;

  private final WebhookSettings settings;

  Target(WebhookSettings settings) {
    this.settings = settings;
  }

  /**
   * Parses and checks the URL of a webhook.
   *
   * @throws RequestException if the URL is invalid or its host is not allowed
   */
  URI verify(String url) {
    URI address;
    try {
      address = new URI(url);
    } catch (URISyntaxException e) {
      throw RequestException.malformed("url: " + e.getReason() + ".");
    }
    boolean web = "https".equals(address.getScheme()) || "http".equals(address.getScheme());
    if (!web
        || address.getHost() == null
        || address.getUserInfo() != null
        || url.length() > MAX_LENGTH) {
      throw RequestException.malformed(
          "url: must be an http or https URL with a host and without a user, at most "
              + MAX_LENGTH
              + " characters.");
    }
    if (!isAllowed(address.getHost())) {
      throw RequestException.malformed(
          "url: webhooks are not allowed to "
              + address.getHost()
              + "; the administrator can add hosts to sitaf.webhooks.allowed-hosts.");
    }
    return address;
  }

  private boolean isAllowed(String host) {
    String name = host.toLowerCase(Locale.ROOT);
    return settings.allowedHosts().stream()
        .map(allowed -> allowed.toLowerCase(Locale.ROOT))
        .anyMatch(
            allowed ->
                allowed.startsWith("*.")
                    ? name.endsWith(allowed.substring(1))
                    : name.equals(allowed));
  }

  @Override
  public InetAddress[] resolve(String host) throws UnknownHostException {
    if (!isAllowed(host)) {
      throw new UnknownHostException("webhooks are not allowed to " + host);
    }
    InetAddress[] addresses = SystemDefaultDnsResolver.INSTANCE.resolve(host);
    if (!settings.privateAddresses()) {
      for (InetAddress address : addresses) {
        if (isPrivate(address)) {
          throw new UnknownHostException(
              host
                  + " resolves to "
                  + address.getHostAddress()
                  + ", which is not a public address");
        }
      }
    }
    return Arrays.copyOf(addresses, addresses.length);
  }

  @Override
  public String resolveCanonicalHostname(String host) {
    return host;
  }

  /** Whether an address belongs to this machine, to a private network, or to no network. */
  static boolean isPrivate(InetAddress address) {
    if (address.isLoopbackAddress()
        || address.isAnyLocalAddress()
        || address.isLinkLocalAddress()
        || address.isSiteLocalAddress()
        || address.isMulticastAddress()) {
      return true;
    }
    byte[] bytes = address.getAddress();
    if (address instanceof Inet6Address) {
      // fc00::/7; 64:ff9b::/96 and 2002::/16 contain arbitrary IPv4 addresses.
      return (bytes[0] & UNIQUE_LOCAL_MASK) == UNIQUE_LOCAL
          || bytes[0] == 0 && bytes[1] == 0x64
          || bytes[0] == 0x20 && bytes[1] == 0x02
          || startsWithZeros(bytes);
    }
    // 0.0.0.0/8, 100.64.0.0/10, 240.0.0.0/4.
    return bytes[0] == 0
        || bytes[0] == SHARED_FIRST && (bytes[1] & SHARED_SECOND_MASK) == SHARED_SECOND
        || (bytes[0] & 0xF0) == 0xF0;
  }

  private static boolean startsWithZeros(byte[] bytes) {
    for (int i = 0; i < 10; i++) {
      if (bytes[i] != 0) {
        return false;
      }
    }
    return true;
  }
}
