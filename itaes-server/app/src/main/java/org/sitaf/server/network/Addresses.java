package org.sitaf.server.network;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Pattern;

/** Addresses as text: read without asking anybody for a name. */
public final class Addresses {
  private static final Pattern V4 = Pattern.compile("\\d{1,3}(\\.\\d{1,3}){3}");
  private static final Pattern V6 = Pattern.compile("[0-9A-Fa-f:.]*:[0-9A-Fa-f:.]*");

  /** What one customer of a network gets at least: its addresses are one's. */
  private static final int NETWORK_BYTES = 8;

  private Addresses() {}

  /**
   * What limits count: an address of IPv4, or the network of 64 bits of one of IPv6, for anyone who
   * has one of these has all of them.
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

  /** An address; empty where it is a name, or nothing. */
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
      throw new IllegalStateException("it has the length of an address", e);
    }
  }
}
