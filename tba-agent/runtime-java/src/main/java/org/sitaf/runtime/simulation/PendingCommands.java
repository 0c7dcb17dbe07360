package org.sitaf.runtime.simulation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.sim.v1.CommandBound;
import org.sitaf.sim.v1.CommandNumber;
import org.sitaf.sim.v1.DeviceCommand;
import org.sitaf.sim.v1.DeviceDescription;
import org.sitaf.sim.v1.WorldDescription;

/**
 * Commands that travel with the next step, in the order given, because their devices are known to
 * accept them. Thread-safe.
 */
final class PendingCommands {
  /** Commands without a step between them are sent when there are so many. */
  private static final int MAX_COMMANDS = 1024;

  private final Map<String, Map<String, CommandNumber>> accepted = new HashMap<>();
  private final Map<String, List<CommandBound>> bounds = new HashMap<>();
  private List<DeviceCommand> commands = new ArrayList<>();

  PendingCommands(WorldDescription world) {
    for (DeviceDescription device : world.getDevicesList()) {
      Map<String, CommandNumber> numbers = new HashMap<>();
      device.getCommandsList().forEach(number -> numbers.put(number.getName(), number));
      accepted.put(device.getName(), numbers);
      bounds.put(device.getName(), device.getBoundsList());
    }
  }

  /** Whether its device is known to accept a command: the numbers are finite and within limits. */
  boolean isAcceptable(DeviceCommand command) {
    return switch (command.getCommandCase()) {
      case JOINT ->
          switch (command.getJoint().getTargetCase()) {
            case POSITION -> isWithin(command, "position", command.getJoint().getPosition());
            case VELOCITY -> isWithin(command, "velocity", command.getJoint().getVelocity());
            case EFFORT -> isWithin(command, "effort", command.getJoint().getEffort());
            case TARGET_NOT_SET -> false;
          };
      case DRIVE ->
          isWithin(command, "linear", command.getDrive().getLinear())
              && isWithin(command, "angular", command.getDrive().getAngular())
              && isInside(command);
      case GRIPPER -> isWithin(command, "width", command.getGripper().getWidthM());
      case LEVEL -> isWithin(command, "level", command.getLevel() ? 1 : 0);
      case COMMAND_NOT_SET -> false;
    };
  }

  /** Whether the commands must be sent before another one is added. */
  synchronized boolean isFull() {
    return commands.size() >= MAX_COMMANDS;
  }

  /** Adds a command that is acceptable. */
  synchronized void add(DeviceCommand command) {
    commands.add(command);
  }

  /** Removes and returns all commands. */
  synchronized List<DeviceCommand> take() {
    if (commands.isEmpty()) {
      return List.of();
    }
    List<DeviceCommand> taken = commands;
    commands = new ArrayList<>();
    return taken;
  }

  /** Whether the numbers of a drive are together within the limits of its wheels. */
  private boolean isInside(DeviceCommand command) {
    return bounds.getOrDefault(command.getDevice(), List.of()).stream()
        .allMatch(
            bound -> {
              double sum =
                  bound.getFactorsOrDefault("linear", 0) * command.getDrive().getLinear()
                      + bound.getFactorsOrDefault("angular", 0) * command.getDrive().getAngular();
              return bound.getMin() <= sum && sum <= bound.getMax();
            });
  }

  private boolean isWithin(DeviceCommand command, String name, double value) {
    @Nullable CommandNumber number = accepted.getOrDefault(command.getDevice(), Map.of()).get(name);
    return number != null
        && Double.isFinite(value)
        && number.getMin() <= value
        && value <= number.getMax();
  }
}
