package org.sitaf.server.network;

import java.net.InetAddress;

/** A range of IP addresses in CIDR notation, such as {@code 10.0.0.0/8}. */
final class AddressRange {
  private final byte[] network;
  private final int bits;

  private AddressRange(byte[] network, int bits) {
    this.network = network;
    this.bits = bits;
  }

  /**
   * Parses a range or a single address.
   *
   * @throws IllegalArgumentException if the text is neither
   */
  static AddressRange parse(String text) {
    int slash = text.indexOf('/');
    String address = slash < 0 ? text : text.substring(0, slash);
    byte[] network =
        Addresses.parse(address).map(InetAddress::getAddress).orElseThrow(() -> invalid(text));
    int maxBits = network.length * Byte.SIZE;
    int bits;
    try {
      bits = slash < 0 ? maxBits : Integer.parseInt(text.substring(slash + 1).strip());
    } catch (NumberFormatException e) {
      throw invalid(text);
    }
    if (bits < 0 || bits > maxBits) {
      throw invalid(text);
    }
    return new AddressRange(network, bits);
  }

  boolean contains(InetAddress address) {
    byte[] other = address.getAddress();
    if (other.length != network.length) {
      return false;
    }
    for (int bit = 0; bit < bits; bit++) {
      int mask = 1 << (Byte.SIZE - 1 - bit % Byte.SIZE);
      if ((other[bit / Byte.SIZE] & mask) != (network[bit / Byte.SIZE] & mask)) {
        return false;
      }
    }
    return true;
  }

  private static IllegalArgumentException invalid(String text) {
    return new IllegalArgumentException(
        "sitaf.trusted-proxies: '"
            + text
            + "' is neither an IP address nor a range such as 10.0.0.0/8");
  }
}
