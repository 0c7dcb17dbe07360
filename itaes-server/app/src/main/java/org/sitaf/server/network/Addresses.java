package org.sitaf.server.network;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Pattern;

/** Parses IP addresses without DNS lookups. */
public final class Addresses {
  private static final Pattern V4 = Pattern.compile("\\d{1,3}(\\.\\d{1,3}){3}");
  private static final Pattern V6 = Pattern.compile("[0-9A-Fa-f:.]*:[0-9A-Fa-f:.]*");

  /** The prefix of an IPv6 address that identifies a network. */
  private static final int NETWORK_BYTES = 8;

  private Addresses() {}

  /**
   * The key for limits per client: an IPv4 address, or the /64 network of an IPv6 address, because
   * a client can usually use all addresses of its network.
   */
  public static String group(String address) {
    Optional<InetAddress> known = parse(address);
    if (known.isEmpty() || !(known.get() instanceof Inet6Address)) {
      return known.map(InetAddress::getHostAddress).orElse(address);
    }
    byte[] network = Arrays.copyOf(known.get().getAddress(), known.get().getAddress().length);
    Arrays.fill(network, NETWORK_BYTES, network.length, (byte) 0);
    return text(network) + "/64";
  }

  /** Parses an address with an optional port; empty if it is not an IP address. */
  static Optional<InetAddress> parse(String text) {
    String bare = withoutPort(text.strip());
    if (!V4.matcher(bare).matches() && !V6.matcher(bare).matches()) {
      return Optional.empty();
    }
    try {
      return Optional.of(InetAddress.getByName(bare));
    } catch (UnknownHostException e) {
      return Optional.empty();
    }
  }

  private static String withoutPort(String text) {
    if (text.startsWith("[")) {
      int end = text.indexOf(']');
      return end < 0 ? text : withoutZone(text.substring(1, end));
    }
    int colon = text.indexOf(':');
    boolean port = colon >= 0 && colon == text.lastIndexOf(':');
    return port ? text.substring(0, colon) : withoutZone(text);
  }

  private static String withoutZone(String text) {
    int zone = text.indexOf('%');
    return zone < 0 ? text : text.substring(0, zone);
  }

  private static String text(byte[] address) {
    try {
      return InetAddress.getByAddress(address).getHostAddress();
    } catch (UnknownHostException e) {
      throw new IllegalStateException("invalid length of an address", e);
    }
  }
}
