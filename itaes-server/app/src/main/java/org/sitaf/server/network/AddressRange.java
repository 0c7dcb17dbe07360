package org.sitaf.server.network;

import java.net.InetAddress;

/** Addresses that begin alike, such as {@code 10.0.0.0/8}. */
final class AddressRange {
  private final byte[] network;
  private final int bits;

  private AddressRange(byte[] network, int bits) {
    this.network = network;
    this.bits = bits;
  }

  /**
   * Reads a range, or a single address.
   *
   * @throws IllegalArgumentException when it is neither
   */
  static AddressRange parse(String text) {
    int slash = text.indexOf('/');
    String address = slash < 0 ? text : text.substring(0, slash);
    byte[] network =
        Addresses.parse(address).map(InetAddress::getAddress).orElseThrow(() -> wrong(text));
    int most = network.length * Byte.SIZE;
    int bits;
    try {
      bits = slash < 0 ? most : Integer.parseInt(text.substring(slash + 1).strip());
    } catch (NumberFormatException e) {
      throw wrong(text);
    }
    if (bits < 0 || bits > most) {
      throw wrong(text);
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

  private static IllegalArgumentException wrong(String text) {
    return new IllegalArgumentException(
        "sitaf.trusted-proxies: '"
            + text
            + "' is no address and no range of addresses such as 10.0.0.0/8");
  }
}
