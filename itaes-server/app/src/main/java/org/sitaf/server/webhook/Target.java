package org.sitaf.server.webhook;

import java.net.InetAddress;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import org.apache.hc.client5.http.DnsResolver;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.network.OutboundHosts;

/**
 * Prevents server-side request forgery by webhooks. The host name is checked when a webhook is
 * created, and its IP addresses are checked each time a message is sent; the connection uses the
 * checked addresses.
 */
final class Target implements DnsResolver {
  private static final int MAX_LENGTH = 2000;

  private final OutboundHosts hosts;

  Target(WebhookSettings settings) {
    this.hosts =
        new OutboundHosts("webhooks", settings.allowedHosts(), settings.privateAddresses());
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
    if (!hosts.isAllowed(address.getHost())) {
      throw RequestException.malformed(
          "url: webhooks are not allowed to "
              + address.getHost()
              + "; the administrator can add hosts to sitaf.webhooks.allowed-hosts.");
    }
    return address;
  }

  @Override
  public InetAddress[] resolve(String host) throws UnknownHostException {
    return hosts.resolve(host);
  }

  @Override
  public String resolveCanonicalHostname(String host) {
    return host;
  }
}
