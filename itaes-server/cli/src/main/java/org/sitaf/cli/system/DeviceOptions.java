package org.sitaf.cli.system;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.hardware.DeviceBackend;
import org.sitaf.core.diagnostic.NearestName;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** Where the providers of real devices are. */
public final class DeviceOptions {
  @Option(
      names = "--device",
      paramLabel = "NAME=ADDRESS",
      description =
          "Real device that tests may use: its name in their worlds, and the address of its"
              + " provider, unix:/PATH or HOST:PORT. It replaces the address in activity.yaml."
              + " Can be repeated.")
  private Map<String, String> devices = new LinkedHashMap<>();

  /** Rejects devices for tests on another machine, whose agents offer their own ones. */
  public void requireNone(CommandSpec command) {
    if (!devices.isEmpty()) {
      throw new ParameterException(
          command.commandLine(), "--device is not available with --server; start an agent with it");
    }
  }

  /** The addresses by device. */
  Map<String, String> addresses(CommandSpec command) {
    devices.forEach(
        (device, address) -> {
          if (!DeviceBackend.isAddress(address)) {
            throw new ParameterException(
                command.commandLine(),
                "--device "
                    + device
                    + "="
                    + address
                    + ": the address must be "
                    + DeviceBackend.ADDRESS_FORM);
          }
        });
    return devices;
  }

  /** The addresses by device; each must be a real device of the activity. */
  public Map<String, String> addresses(CommandSpec command, Activity activity) {
    List<String> real =
        activity.profile().hardware().stream()
            .filter(DeviceBackend::isReal)
            .map(DeviceBackend::device)
            .toList();
    for (String device : devices.keySet()) {
      if (!real.contains(device)) {
        throw new ParameterException(
            command.commandLine(),
            "--device "
                + device
                + ": activity.yaml has no real device of that name"
                + NearestName.hint(device, real));
      }
    }
    return addresses(command);
  }
}
