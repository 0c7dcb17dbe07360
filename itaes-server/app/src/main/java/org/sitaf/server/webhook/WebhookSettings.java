package org.sitaf.server.webhook;

import java.util.List;
import org.springframework.boot.context.properties.ConfigurationProperties;
import org.springframework.boot.context.properties.bind.DefaultValue;

/**
 * Settings {@code sitaf.webhooks.*} of the server.
 *
 * @param allowedHosts hosts to which webhooks may go, such as {@code ci.example.org}, or {@code
 *     *.example.org} for all below one; none where empty
 * @param privateAddresses whether such a host may be one of a private network, or this machine
 */
@ConfigurationProperties("sitaf.webhooks")
record WebhookSettings(
    @DefaultValue List<String> allowedHosts, @DefaultValue("false") boolean privateAddresses) {
  WebhookSettings {
    allowedHosts = List.copyOf(allowedHosts);
  }
}
