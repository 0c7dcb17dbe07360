package org.sitaf.server.webhook;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.InvalidKeyException;
import java.security.NoSuchAlgorithmException;
import java.time.Clock;
import java.util.HexFormat;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import org.apache.hc.client5.http.classic.methods.HttpPost;
import org.apache.hc.client5.http.config.ConnectionConfig;
import org.apache.hc.client5.http.config.RequestConfig;
import org.apache.hc.client5.http.impl.classic.CloseableHttpClient;
import org.apache.hc.client5.http.impl.classic.HttpClients;
import org.apache.hc.client5.http.impl.io.PoolingHttpClientConnectionManagerBuilder;
import org.apache.hc.core5.http.ContentType;
import org.apache.hc.core5.http.io.entity.StringEntity;
import org.apache.hc.core5.util.Timeout;
import org.springframework.boot.context.properties.EnableConfigurationProperties;
import org.springframework.context.annotation.Configuration;
import org.springframework.scheduling.annotation.EnableScheduling;

/**
 * Sends signed messages. The header is {@code Sitaf-Signature: t=SECONDS,v1=HEX}, where HEX is the
 * HMAC-SHA-256 of {@code SECONDS.BODY} with the webhook's secret. Redirects are not followed.
 */
@Configuration(proxyBeanMethods = false)
@EnableScheduling
@EnableConfigurationProperties(WebhookSettings.class)
class Sender implements AutoCloseable {
  private static final Timeout TIMEOUT = Timeout.ofSeconds(5);
  private static final String ALGORITHM = "HmacSHA256";

  private final CloseableHttpClient client;
  private final Target target;
  private final Clock clock;

  Sender(WebhookSettings settings, Clock clock) {
    this.clock = clock;
    this.target = new Target(settings);
    this.client =
        HttpClients.custom()
            .setConnectionManager(
                PoolingHttpClientConnectionManagerBuilder.create()
                    .setDnsResolver(target)
                    .setDefaultConnectionConfig(
                        ConnectionConfig.custom()
                            .setConnectTimeout(TIMEOUT)
                            .setSocketTimeout(TIMEOUT)
                            .build())
                    .build())
            .setDefaultRequestConfig(
                RequestConfig.custom()
                    .setResponseTimeout(TIMEOUT)
                    .setConnectionRequestTimeout(TIMEOUT)
                    .build())
            .disableRedirectHandling()
            .disableAutomaticRetries()
            .disableCookieManagement()
            .disableAuthCaching()
            .setUserAgent("sitaf-webhook")
            .build();
  }

  /** Sends a message and returns the HTTP status; the response body is ignored. */
  int send(String url, String secret, String id, String payload) throws IOException {
    HttpPost request = new HttpPost(target.verify(url));
    long seconds = clock.instant().getEpochSecond();
    request.setHeader("Sitaf-Delivery", id);
    request.setHeader(
        "Sitaf-Signature", "t=" + seconds + ",v1=" + hmac(secret, seconds + "." + payload));
    request.setEntity(new StringEntity(payload, ContentType.APPLICATION_JSON));
    return client.execute(
        request,
        response -> {
          // Close the connection instead of reading a body of unknown length.
          request.abort();
          return response.getCode();
        });
  }

  /** HMAC-SHA-256 in hexadecimal. */
  static String hmac(String secret, String text) {
    try {
      Mac mac = Mac.getInstance(ALGORITHM);
      mac.init(new SecretKeySpec(secret.getBytes(StandardCharsets.UTF_8), ALGORITHM));
      return HexFormat.of().formatHex(mac.doFinal(text.getBytes(StandardCharsets.UTF_8)));
    } catch (NoSuchAlgorithmException | InvalidKeyException e) {
      throw new IllegalStateException("every Java has " + ALGORITHM, e);
    }
  }

  @Override
  public void close() throws IOException {
    client.close();
  }
}
