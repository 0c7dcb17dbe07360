package org.sitaf.agent.simulation;

import com.google.protobuf.ByteString;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import org.sitaf.core.activity.hardware.DeviceBackend;
import org.sitaf.core.activity.hardware.DeviceBackend.Range;
import org.sitaf.sim.v1.ProviderBackend;
import org.sitaf.sim.v1.ReplayBackend;

/**
 * The devices of a build that are not simulated.
 *
 * @param addresses gRPC targets of the providers by device
 * @param recordings contents of the recordings by device
 * @param parameters names of the parameters that the test sets
 */
public record HardwareOrder(
    List<DeviceBackend> backends,
    Map<String, String> addresses,
    Map<String, byte[]> recordings,
    Set<String> parameters) {
  public HardwareOrder {
    backends = List.copyOf(backends);
    addresses = Map.copyOf(addresses);
    recordings = Map.copyOf(recordings);
    parameters = Set.copyOf(parameters);
  }

  /** Whether any device is real, so that a guard is needed. */
  boolean hasRealDevices() {
    return !addresses.isEmpty();
  }

  /** The configuration of the guard, as JSON. */
  String guardFile(Map<String, Map<String, Range>> world) {
    StringBuilder json = new StringBuilder("{");
    for (DeviceBackend backend : backends) {
      String address = addresses.get(backend.device());
      if (address == null) {
        continue;
      }
      json.append(json.length() == 1 ? "" : ", ")
          .append(quoted(backend.device()))
          .append(": {\"address\": ")
          .append(quoted(address))
          .append(", \"limits\": {");
      Map<String, Range> limits = new HashMap<>(world.getOrDefault(backend.device(), Map.of()));
      backend.envelope().forEach((name, range) -> limits.merge(name, range, HardwareOrder::both));
      String between = "";
      for (Map.Entry<String, Range> limit : new TreeMap<>(limits).entrySet()) {
        json.append(between)
            .append(quoted(limit.getKey()))
            .append(": [")
            .append(number(limit.getValue().min()))
            .append(", ")
            .append(number(limit.getValue().max()))
            .append(']');
        between = ", ";
      }
      json.append("}, \"rates\": {");
      between = "";
      for (Map.Entry<String, Double> rate : backend.rates().entrySet()) {
        json.append(between).append(quoted(rate.getKey())).append(": ").append(rate.getValue());
        between = ", ";
      }
      json.append("}}");
    }
    return json.append('}').toString();
  }

  private static Range both(Range one, Range other) {
    return new Range(Math.max(one.min(), other.min()), Math.min(one.max(), other.max()));
  }

  /** Names and addresses were checked; they contain no control characters. */
  private static String quoted(String text) {
    return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }

  private static String number(double value) {
    return Double.isInfinite(value) ? "null" : Double.toString(value);
  }

  /**
   * The order for a bridge.
   *
   * @param guard gRPC target of the guard; empty if there is none
   */
  org.sitaf.sim.v1.HardwareOrder message(String guard) {
    var order = org.sitaf.sim.v1.HardwareOrder.newBuilder().setGuard(guard);
    for (DeviceBackend backend : backends) {
      var device =
          order
              .addDevicesBuilder()
              .setDevice(backend.device())
              .addAllIndependentOf(backend.independentOf());
      ProviderBackend real = ProviderBackend.newBuilder().setMaxAgeS(backend.maxAgeS()).build();
      switch (backend.kind()) {
        case PROVIDER -> device.setProvider(real);
        case SHADOW -> device.setShadow(real);
        case REPLAY ->
            device.setReplay(
                ReplayBackend.newBuilder()
                    .setFile(Objects.requireNonNullElse(backend.file(), ""))
                    .setContent(
                        ByteString.copyFrom(recordings.getOrDefault(backend.device(), new byte[0])))
                    .setTopic(backend.topic())
                    .setMaxAgeS(backend.maxAgeS()));
      }
    }
    return order.build();
  }
}
