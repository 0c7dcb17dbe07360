package org.sitaf.server.network;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.settings.SitafSettings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.stereotype.Component;

/**
 * Finds the client of a request behind proxies. Only headers of {@code sitaf.trusted-proxies} are
 * used.
 */
@Component
public class TrustedProxies {
  private static final String FORWARDED = "Forwarded";
  private static final String FORWARDED_FOR = "X-Forwarded-For";
  private static final String FORWARDED_PROTO = "X-Forwarded-Proto";

  private static final Logger log = LoggerFactory.getLogger(TrustedProxies.class);

  private final List<AddressRange> ranges;
  private final AtomicBoolean warned = new AtomicBoolean();

  @Autowired
  TrustedProxies(SitafSettings settings) {
    this(settings.trustedProxies());
  }

  TrustedProxies(List<String> ranges) {
    this.ranges = ranges.stream().map(AddressRange::parse).toList();
  }

  /**
   * The client of a request.
   *
   * @param secure whether the client used TLS; null if unknown
   */
  public record Client(String address, @Nullable Boolean secure) {}

  /**
   * Returns the client of a request.
   *
   * @param remote address of the peer that opened the connection
   * @param headers returns all values of a header in their order
   */
  public Client client(String remote, Function<String, List<String>> headers) {
    List<String> forwardedForChain = parts(headers.apply(FORWARDED_FOR));
    List<String> forwardedChain = parameters(headers.apply(FORWARDED), "for");
    if (!isTrusted(remote)) {
      warnOfUntrustedProxy(remote, !forwardedForChain.isEmpty() || !forwardedChain.isEmpty());
      return new Client(remote, null);
    }
    Optional<String> forwardedFor = lastUntrusted(forwardedForChain);
    Optional<String> forwarded = lastUntrusted(forwardedChain);
    // A proxy that sets one of the headers passes on the other one as the client sent it.
    boolean contradict =
        forwardedFor.isPresent() && forwarded.isPresent() && !forwardedFor.equals(forwarded);
    String address = contradict ? remote : forwardedFor.or(() -> forwarded).orElse(remote);
    List<String> schemes = parts(headers.apply(FORWARDED_PROTO));
    if (schemes.isEmpty()) {
      schemes = parameters(headers.apply(FORWARDED), "proto");
    }
    return new Client(address, schemes.isEmpty() ? null : isTls(schemes.get(schemes.size() - 1)));
  }

  /** Warns only once, so that clients cannot fill the log. */
  private void warnOfUntrustedProxy(String remote, boolean forwarded) {
    if (forwarded && warned.compareAndSet(false, true)) {
      log.warn(
          "{} sends forwarded requests but is not in sitaf.trusted-proxies: the audit log contains"
              + " the proxy's address, and cookies are not Secure. Add it if it is your proxy.",
          Addresses.group(remote));
    }
  }

  private boolean isTrusted(String address) {
    return Addresses.parse(address)
        .filter(known -> ranges.stream().anyMatch(range -> range.contains(known)))
        .isPresent();
  }

  /** The last address that is not a trusted proxy; proxies append to the list. */
  private Optional<String> lastUntrusted(List<String> chain) {
    List<String> backwards = new ArrayList<>(chain);
    Collections.reverse(backwards);
    for (String hop : backwards) {
      Optional<String> address = Addresses.parse(hop).map(InetAddress::getHostAddress);
      if (address.isEmpty() || !isTrusted(address.get())) {
        return address;
      }
    }
    return Optional.empty();
  }

  private static boolean isTls(String scheme) {
    return scheme.equalsIgnoreCase("https");
  }

  private static List<String> parts(List<String> headers) {
    return headers.stream()
        .flatMap(header -> List.of(header.split(",", -1)).stream())
        .map(String::strip)
        .filter(part -> !part.isEmpty())
        .toList();
  }

  /**
   * Values of a parameter of RFC 7239, such as {@code for="[2001:db8::1]:47011";proto=https,
   * for=192.0.2.60}.
   */
  private static List<String> parameters(List<String> headers, String name) {
    List<String> found = new ArrayList<>();
    for (String element : parts(headers)) {
      for (String pair : element.split(";", -1)) {
        int equals = pair.indexOf('=');
        if (equals > 0 && pair.substring(0, equals).strip().toLowerCase(Locale.ROOT).equals(name)) {
          found.add(pair.substring(equals + 1).strip().replace("\"", ""));
        }
      }
    }
    return found;
  }
}
