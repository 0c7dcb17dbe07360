package org.sitaf.cli.run;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.hardware.DeviceBackend;
import org.sitaf.core.diagnostic.NearestName;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** Where the providers of the real devices of an activity are. */
final class DeviceOptions {
  @Option(
      names = "--device",
      paramLabel = "NAME=ADDRESS",
      description =
          "Address of the provider of a real device, unix:/PATH or HOST:PORT, instead of that in"
              + " activity.yaml. Can be repeated.")
  private Map<String, String> devices = new LinkedHashMap<>();

  /** Checks the combination of the options, and the addresses. */
  void check(CommandSpec command, boolean isRemote) {
    if (isRemote && !devices.isEmpty()) {
      throw new ParameterException(
          command.commandLine(), "--device is not available with --server; start an agent with it");
    }
    devices.forEach(
        (device, address) -> {
          if (!DeviceBackend.isAddress(address)) {
            throw new ParameterException(
                command.commandLine(),
                "--device "
                    + device
                    + "="
                    + address
                    + ": the address must be unix:/PATH (at most 107 characters) or HOST:PORT");
          }
        });
  }

  /** The addresses by device; each must be a real device of the activity. */
  Map<String, String> addresses(CommandSpec command, Activity activity) {
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
    return devices;
  }
}
