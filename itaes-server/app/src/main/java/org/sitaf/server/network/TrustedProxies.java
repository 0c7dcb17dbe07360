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
 * For whom a proxy speaks. Only those of {@code sitaf.trusted-proxies} are believed; what anybody
 * else says of itself is as good as nothing.
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
   * @param secure whether it spoke TLS; null where the proxy does not say
   */
  public record Client(String address, @Nullable Boolean secure) {}

  /**
   * Who makes a request.
   *
   * @param remote who has opened the connection
   * @param headers all values of a header of that name, in their order
   */
  public Client client(String remote, Function<String, List<String>> headers) {
    List<String> plain = parts(headers.apply(FORWARDED_FOR));
    List<String> standard = parameters(headers.apply(FORWARDED), "for");
    if (!isTrusted(remote)) {
      warnOfProxy(remote, !plain.isEmpty() || !standard.isEmpty());
      return new Client(remote, null);
    }
    Optional<String> one = nearestStranger(plain);
    Optional<String> other = nearestStranger(standard);
    // A proxy that sets one of them hands the other on as a stranger wrote it.
    boolean contradict = one.isPresent() && other.isPresent() && !one.equals(other);
    String address = contradict ? remote : one.or(() -> other).orElse(remote);
    List<String> schemes = parts(headers.apply(FORWARDED_PROTO));
    if (schemes.isEmpty()) {
      schemes = parameters(headers.apply(FORWARDED), "proto");
    }
    return new Client(address, schemes.isEmpty() ? null : isTls(schemes.get(schemes.size() - 1)));
  }

  /** Once: an operator who forgot the setting finds it out, and strangers do not fill the log. */
  private void warnOfProxy(String remote, boolean forwarded) {
    if (forwarded && warned.compareAndSet(false, true)) {
      log.warn(
          "{} forwards requests of others and is not in sitaf.trusted-proxies: audited addresses are"
              + " those of the proxy, and cookies are not Secure. Add it if it is your proxy.",
          Addresses.group(remote));
    }
  }

  private boolean isTrusted(String address) {
    return Addresses.parse(address)
        .filter(known -> ranges.stream().anyMatch(range -> range.contains(known)))
        .isPresent();
  }

  /** From the end, where our own proxies have written, to the first that is none of them. */
  private Optional<String> nearestStranger(List<String> chain) {
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

  /** Of RFC 7239, such as {@code for="[2001:db8::1]:47011";proto=https, for=192.0.2.60}. */
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
