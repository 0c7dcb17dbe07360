package org.sitaf.server.access.web;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.AccessSettings;
import org.springframework.core.env.Environment;
import org.springframework.stereotype.Component;

/**
 * Passwords, tokens and keys must not be read on the way: beyond the loopback the server speaks TLS
 * or does not start. What a launcher brings is for its own machine.
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
      @Nullable String launchersSecret,
      String... tlsProperties) {
    String address = environment.getProperty(addressProperty, "0.0.0.0");
    if (isLoopback(address)) {
      return;
    }
    boolean tls = Stream.of(tlsProperties).anyMatch(environment::containsProperty);
    if (!tls && !settings.plaintext()) {
      throw new TransportRefusedException(
          addressProperty
              + " is "
              + address
              + ": without TLS the server listens on the loopback only",
          "Set "
              + tlsProperties[0]
              + " to a bundle of spring.ssl.bundle.pem (see docs/security.md), or"
              + " sitaf.access.plaintext=true where something before the server ends TLS.");
    }
    if (launchersSecret != null) {
      throw new TransportRefusedException(
          addressProperty
              + " is "
              + address
              + ": the secrets of a launcher are for the loopback only",
          "Leave out sitaf.access.launcher-token and sitaf.access.launcher-enrolment.");
    }
  }

  private static boolean isLoopback(String address) {
    try {
      return InetAddress.getByName(address).isLoopbackAddress();
    } catch (UnknownHostException e) {
      // Whoever listens there will say so.
      return false;
    }
  }
}
