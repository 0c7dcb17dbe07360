package org.sitaf.core.beginning;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import org.sitaf.core.description.ScalarType;

/**
 * A range of a number that its name tells, by the conventions of ROS (REP 103: SI units, radians).
 *
 * @param reason what the range assumes, for the user who decides
 */
record NumberRange(String min, String max, String offset, String reason) {
  private static final String PI = "3.141592653589793";

  /** The first rule whose words are in the name wins, so units precede quantities. */
  private static final List<Rule> RULES =
      List.of(
          rule("nanosec|nsec|nanoseconds", "0", "999999999", "1", "nanoseconds of a time"),
          rule("percent|percentage", "0", "100", "1", "a percentage"),
          rule("deg|degree|degrees", "-180", "180", "1", "an angle in degrees"),
          rule("latitude|lat", "-90", "90", "1", "degrees of latitude"),
          rule("longitude|lon|lng", "-180", "180", "1", "degrees of longitude"),
          rule(
              "probability|prob|confidence|ratio|fraction|score|similarity|opacity|certainty",
              "0",
              "1",
              "0.1",
              "a share of one"),
          rule("ms|millis|milliseconds|msec", "0", "1000", "10", "milliseconds"),
          rule(
              "timeout|duration|time|period|delay|interval|allowance|sec|secs|seconds|wait",
              "0",
              "10",
              "1",
              "seconds"),
          rule("tolerance|epsilon|threshold|accuracy|resolution", "0", "1", "0.1", "a tolerance"),
          rule("max|maximum|limit", "0", "10", "1", "a limit that is not negative"),
          rule("speed|velocity|vel|linear|twist", "-1", "1", "0.1", "metres per second"),
          rule("acceleration|accel|jerk", "-5", "5", "0.5", "metres per second squared"),
          rule("angular|omega", "-3", "3", "0.1", "radians per second"),
          rule(
              "angle|angles|yaw|roll|pitch|theta|phi|psi|heading|bearing|azimuth|elevation"
                  + "|rotation",
              "-" + PI,
              PI,
              "0.1",
              "an angle in radians"),
          rule("joint|joints", "-" + PI, PI, "0.1", "a joint angle in radians"),
          rule("force|effort|torque|load", "-10", "10", "1", "newtons or newton metres"),
          rule("temperature|temp|celsius", "-20", "60", "1", "degrees Celsius"),
          rule("voltage|volt|volts", "0", "24", "1", "volts"),
          rule("frequency|rate|hz|fps", "0", "100", "1", "hertz"),
          rule("mass|weight|payload|kg", "0", "10", "0.5", "kilograms"),
          rule(
              "distance|dist|range|radius|length|height|width|depth|size|clearance|thickness",
              "0",
              "10",
              "0.5",
              "metres, not negative"),
          rule("gain|kp|ki|kd|factor|scale", "0", "10", "0.5", "a factor"));

  /** Words of integers. */
  private static final List<Rule> WHOLE_RULES =
      List.of(
          rule("port", "1024", "65535", "1", "a port number"),
          rule(
              "id|ids|index|idx|channel|slot|number|num|count|size|length|width|height|depth|level",
              "0",
              "10",
              "1",
              "an index or a count"));

  static NumberRange of(String name, ScalarType type) {
    Optional<NumberRange> found =
        type.isFloating()
            ? match(RULES, name)
            : match(WHOLE_RULES, name).or(() -> match(RULES, name).map(NumberRange::whole));
    NumberRange range =
        found.orElse(
            type.isFloating()
                ? new NumberRange("-1", "1", "0.1", "nothing about its range")
                : small(type));
    return range.within(type);
  }

  private static NumberRange small(ScalarType type) {
    if (type == ScalarType.UINT8 || type == ScalarType.INT8) {
      return new NumberRange(
          String.valueOf(type.minimum()),
          String.valueOf(type.maximum()),
          "1",
          "the whole range of " + type.typeName());
    }
    return new NumberRange("-10", "10", "1", "nothing about its range");
  }

  private static Optional<NumberRange> match(List<Rule> rules, String name) {
    List<String> words = words(name);
    return rules.stream()
        .filter(rule -> words.stream().anyMatch(w -> rule.words().matcher(w).matches()))
        .findFirst()
        .map(Rule::range);
  }

  /** The words of {@code maxSpeed_mps} in lower case. */
  static List<String> words(String name) {
    return List.of(
        name.replaceAll("(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_")
            .toLowerCase(Locale.ROOT)
            .split("[^a-z]+"));
  }

  private NumberRange whole() {
    return new NumberRange(
        String.valueOf(Math.round(Double.parseDouble(min))),
        String.valueOf(Math.round(Double.parseDouble(max))),
        "1",
        reason);
  }

  /** The part of the range that an integer type holds. */
  private NumberRange within(ScalarType type) {
    if (!type.isInteger()) {
      return this;
    }
    var low = new java.math.BigInteger(min).max(type.minimum());
    var high = new java.math.BigInteger(max).min(type.maximum());
    return new NumberRange(low.toString(), high.toString(), offset, reason);
  }

  private static Rule rule(String words, String min, String max, String offset, String reason) {
    return new Rule(Pattern.compile(words), new NumberRange(min, max, offset, reason));
  }

  private record Rule(Pattern words, NumberRange range) {}
}
