package org.sitaf.server.network;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.List;
import java.util.Locale;

/**
 * Prevents server-side request forgery: which hosts the server may connect to for its users.
 *
 * @param purpose for messages, such as {@code webhooks}
 * @param allowed names such as {@code ci.example.org} or {@code *.example.org}; {@code *} allows
 *     all
 * @param privateAddresses whether such a host may have a private or loopback address
 */
public record OutboundHosts(String purpose, List<String> allowed, boolean privateAddresses) {
  private static final int SHARED_FIRST = 100;
  private static final int SHARED_SECOND_MASK = 0xC0;
  private static final int SHARED_SECOND = 64;
  private static final int UNIQUE_LOCAL_MASK = 0xFE;
  private static final int UNIQUE_LOCAL = 0xFC;

  public OutboundHosts {
    allowed = List.copyOf(allowed);
  }

  /** Whether the name is allowed; its addresses are checked by {@link #resolve}. */
  public boolean isAllowed(String host) {
    String name = host.toLowerCase(Locale.ROOT);
    return allowed.stream()
        .map(pattern -> pattern.toLowerCase(Locale.ROOT))
        .anyMatch(
            pattern ->
                pattern.startsWith("*")
                    ? name.endsWith(pattern.substring(1))
                    : name.equals(pattern));
  }

  /**
   * Finds the addresses of a host.
   *
   * @throws UnknownHostException if it has none, or is not allowed
   */
  public InetAddress[] resolve(String host) throws UnknownHostException {
    if (!isAllowed(host)) {
      throw new UnknownHostException(purpose + " are not allowed to " + host);
    }
    InetAddress[] addresses = InetAddress.getAllByName(host);
    if (!privateAddresses) {
      for (InetAddress address : addresses) {
        if (isPrivate(address)) {
          throw new UnknownHostException(
              host
                  + " resolves to "
                  + address.getHostAddress()
                  + ", which is not a public address");
        }
      }
    }
    return addresses.clone();
  }

  /** Whether an address belongs to this machine, to a private network, or to no network. */
  public static boolean isPrivate(InetAddress address) {
    if (address.isLoopbackAddress()
        || address.isAnyLocalAddress()
        || address.isLinkLocalAddress()
        || address.isSiteLocalAddress()
        || address.isMulticastAddress()) {
      return true;
    }
    byte[] bytes = address.getAddress();
    if (address instanceof Inet6Address) {
      // fc00::/7; 64:ff9b::/96 and 2002::/16 contain arbitrary IPv4 addresses.
      return (bytes[0] & UNIQUE_LOCAL_MASK) == UNIQUE_LOCAL
          || bytes[0] == 0 && bytes[1] == 0x64
          || bytes[0] == 0x20 && bytes[1] == 0x02
          || startsWithZeros(bytes);
    }
    // 0.0.0.0/8, 100.64.0.0/10, 240.0.0.0/4.
    return bytes[0] == 0
        || bytes[0] == SHARED_FIRST && (bytes[1] & SHARED_SECOND_MASK) == SHARED_SECOND
        || (bytes[0] & 0xF0) == 0xF0;
  }

  private static boolean startsWithZeros(byte[] bytes) {
    for (int i = 0; i < 10; i++) {
      if (bytes[i] != 0) {
        return false;
      }
    }
    return true;
  }
}
