package org.sitaf.server.webhook;

import java.util.List;
import org.springframework.boot.context.properties.ConfigurationProperties;
import org.springframework.boot.context.properties.bind.DefaultValue;

/**
 * Settings {@code sitaf.webhooks.*} of the server.
 *
 * @param allowedHosts hosts that webhooks may call, such as {@code ci.example.org} or {@code
 *     *.example.org}; empty allows none
 * @param privateAddresses whether such a host may have a private or loopback address
 */
@ConfigurationProperties("sitaf.webhooks")
record WebhookSettings(
    @DefaultValue List<String> allowedHosts, @DefaultValue("false") boolean privateAddresses) {
  WebhookSettings {
    allowedHosts = List.copyOf(allowedHosts);
  }
}
