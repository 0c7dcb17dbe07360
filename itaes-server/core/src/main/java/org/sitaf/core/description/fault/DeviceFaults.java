package org.sitaf.core.description.fault;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.Device;
import org.sitaf.core.description.WorldSignals;

/** Which faults the devices of a world can have, as the simulator defines it. */
public final class DeviceFaults {
  private static final double MAX_DELAY_S = 10;

  /** The numbers of a reading that are truth values. */
  private static final Set<String> TRUTHS = Set.of("contact.pressed", "digital_io.level");

  private DeviceFaults() {}

  /** Why a world cannot have a fault; empty if it can. */
  public static Optional<String> problem(FaultName name, WorldDescription world) {
    Optional<Device> device =
        world.devices().stream().filter(d -> d.name().equals(name.device())).findFirst();
    if (device.isEmpty()) {
      return Optional.of(
          world.path()
              + " has no device "
              + name.device()
              + "; it has "
              + world.devices().stream().map(Device::name).collect(Collectors.joining(", ")));
    }
    String kind = device.get().kind();
    if (fits(name, kind)) {
      return Optional.empty();
    }
    List<FaultKind> fitting = of(kind);
    return Optional.of(
        "does not fit "
            + name.device()
            + ", a "
            + kind
            + (fitting.isEmpty()
                ? ", which has no faults"
                : "; its faults: "
                    + fitting.stream().map(FaultKind::text).collect(Collectors.joining(", "))
                    + "; its fields: "
                    + String.join(", ", fields(kind))));
  }

  /** Why a fault cannot have a value; empty if it can. */
  public static Optional<String> problem(FaultName name, double value) {
    double low = Double.NEGATIVE_INFINITY;
    double high = Double.POSITIVE_INFINITY;
    String range = "must be a finite number";
    FaultKind kind = name.kind();
    if (name.part() == FaultName.Part.FAULT) {
      if (kind.isSwitch()) {
        return value == 0 || value == 1 ? Optional.empty() : Optional.of("must be 0 or 1");
      }
      if (kind == FaultKind.INTERMITTENT) {
        low = 0;
        high = 1;
        range = "must be a probability from 0 to 1";
      } else if (kind == FaultKind.DELAY) {
        low = 0;
        high = MAX_DELAY_S;
        range = "must be 0 to " + MAX_DELAY_S + " s";
      } else if (kind == FaultKind.NOISE) {
        low = 0;
        range = "must be a standard deviation of 0 or more";
      }
    } else if (name.part() != FaultName.Part.VALUE) {
      low = 0;
      range = "must be 0 s or more";
    }
    return value >= low && value <= high && !Double.isInfinite(value)
        ? Optional.empty()
        : Optional.of(range);
  }

  /** The faults that a whole device of a kind can have; none of a kind without faults. */
  public static List<FaultKind> of(String deviceKind) {
    return Arrays.stream(FaultKind.values())
        .filter(kind -> fits(new FaultName("device", "", kind, FaultName.Part.FAULT), deviceKind))
        .toList();
  }

  private static boolean fits(FaultName name, String deviceKind) {
    if (name.kind().isOfCommands()) {
      List<String> commands = WorldSignals.commands(deviceKind);
      if (commands.isEmpty() || name.field().isEmpty()) {
        return !commands.isEmpty()
            && (name.kind() == FaultKind.IGNORED || !deviceKind.equals("digital_io"));
      }
      return name.kind() == FaultKind.IGNORED
          && deviceKind.equals("differential_drive")
          && commands.contains(name.field());
    }
    if (deviceKind.equals("laser_scan")) {
      return name.field().isEmpty() || name.field().matches("ranges(\\.\\d{1,6})?");
    }
    return WorldSignals.readings(deviceKind).stream()
        .filter(f -> !name.kind().isOfNumbers() || !TRUTHS.contains(deviceKind + "." + f))
        .anyMatch(
            f ->
                name.field().isEmpty()
                    || f.equals(name.field())
                    || f.startsWith(name.field() + "."));
  }

  private static Set<String> fields(String deviceKind) {
    Set<String> fields = new LinkedHashSet<>();
    if (deviceKind.equals("laser_scan")) {
      fields.add("ranges.0");
    }
    for (String field : WorldSignals.readings(deviceKind)) {
      int dot = field.indexOf('.');
      if (dot > 0) {
        fields.add(field.substring(0, dot));
      }
      fields.add(field);
    }
    return fields;
  }
}
