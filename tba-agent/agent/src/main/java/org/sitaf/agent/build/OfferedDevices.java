package org.sitaf.agent.build;

import java.util.Map;
import java.util.Optional;
import org.sitaf.core.activity.hardware.DeviceBackend;

/**
 * The real devices that builds may use.
 *
 * @param addresses gRPC targets of their providers by device
 * @param others whether a build may also use the addresses in its activity. An agent allows only
 *     what it offers, because activities come from others, who could name any socket.
 */
public record OfferedDevices(Map<String, String> addresses, boolean others) {
  /** No devices. */
  public static final OfferedDevices NONE = new OfferedDevices(Map.of(), false);

  public OfferedDevices {
    addresses = Map.copyOf(addresses);
  }

  /** The address of a device's provider; empty if builds may not use the device. */
  public Optional<String> address(DeviceBackend backend) {
    String offered = addresses.get(backend.device());
    return offered == null && others
        ? Optional.ofNullable(backend.address())
        : Optional.ofNullable(offered);
  }
}
