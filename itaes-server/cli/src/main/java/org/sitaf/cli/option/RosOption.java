package org.sitaf.cli.option;

import java.util.Arrays;
import java.util.stream.Collectors;
import org.sitaf.core.activity.ros.RosImplementation;
import picocli.CommandLine;
import picocli.CommandLine.Option;

/** What ROS 2 nodes run with. */
public final class RosOption {
  @Option(
      names = "--ros",
      paramLabel = "included|system",
      converter = Converter.class,
      description =
          "What a ROS 2 node runs with: included, the API that comes along, over simulated time"
              + " (default), or system, the ROS 2 of the machine, in real time.")
  private RosImplementation implementation = RosImplementation.INCLUDED;

  public RosImplementation implementation() {
    return implementation;
  }

  static final class Converter implements CommandLine.ITypeConverter<RosImplementation> {
    @Override
    public RosImplementation convert(String value) {
      return RosImplementation.of(value)
          .orElseThrow(
              () ->
                  new CommandLine.TypeConversionException(
                      "must be "
                          + Arrays.stream(RosImplementation.values())
                              .map(RosImplementation::id)
                              .collect(Collectors.joining(" or "))
                          + ", not '"
                          + value
                          + "'"));
    }
  }
}
