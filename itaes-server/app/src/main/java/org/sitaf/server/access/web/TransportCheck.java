package org.sitaf.server.access.web;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.AccessSettings;
import org.springframework.core.env.Environment;
import org.springframework.stereotype.Component;

/**
 * Checks at startup that the server uses TLS unless it listens on the loopback interface, so that
 * passwords, tokens and keys cannot be read on the network. A launcher's secrets are only valid on
 * the loopback interface.
 */
@Component
class TransportCheck {
  TransportCheck(Environment environment, AccessSettings settings) {
    verify(
        environment,
        settings,
        "server.address",
        settings.launcherToken(),
        "server.ssl.bundle",
        "server.ssl.key-store",
        "server.ssl.certificate");
    verify(
        environment,
        settings,
        "spring.grpc.server.address",
        settings.launcherEnrolment(),
        "spring.grpc.server.ssl.bundle");
  }

  private static void verify(
      Environment environment,
      AccessSettings settings,
      String addressProperty,
      @Nullable String launcherSecret,
      String... tlsProperties) {
    String address = environment.getProperty(addressProperty, "0.0.0.0");
    if (isLoopback(address)) {
      return;
    }
    boolean tls = Stream.of(tlsProperties).anyMatch(environment::containsProperty);
    if (!tls && !settings.plaintext()) {
      throw new InsecureTransportException(
          addressProperty
              + " is "
              + address
              + ": without TLS the server only listens on the loopback interface",
          "Set "
              + tlsProperties[0]
              + " to a bundle of spring.ssl.bundle.pem (see docs/security.md), or"
              + " sitaf.access.plaintext=true if a reverse proxy terminates TLS.");
    }
    if (launcherSecret != null) {
      throw new InsecureTransportException(
          addressProperty
              + " is "
              + address
              + ": a launcher's secrets are only valid on the loopback interface",
          "Remove sitaf.access.launcher-token and sitaf.access.launcher-enrolment.");
    }
  }

  private static boolean isLoopback(String address) {
    try {
      return InetAddress.getByName(address).isLoopbackAddress();
    } catch (UnknownHostException e) {
      // The web server reports the unknown address when it binds to it.
      return false;
    }
  }
}
