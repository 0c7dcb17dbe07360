package org.sitaf.core.activity.ros;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.activity.ros.RosNode.EndKind;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;

/**
 * Test elements that only models of ROS 2 nodes have: when inputs are published ({@code
 * publish.NAME}), parameters of the node ({@code parameter.NAME}) and the order of callbacks.
 */
public final class RosElements {
  /** The order in which callbacks of one instant run (TDSD). */
  public static final String CALLBACK_ORDER = "ros.callback_order";

  /** The prefix of a parameter of the node (TDI). */
  public static final String PARAMETER = "parameter.";

  private static final String COUNT = ".count";
  private static final Pattern PUBLISH =
      Pattern.compile("publish\\.(\\w+?)(?:\\.(rate_hz|at|for))?");
  private static final Pattern PARAMETER_NAME =
      Pattern.compile("parameter\\.[A-Za-z_]\\w*(\\.\\w+)*");

  private RosElements() {}

  /** Whether an input is one of these elements. */
  public static boolean isOne(InputElement input) {
    String root = MemberPath.root(input.name());
    return switch (input.kind()) {
      case TDI -> root.equals(RosNode.PUBLISH) || root.equals("parameter");
      case TDSD -> input.name().equals(CALLBACK_ORDER);
      case TDTS -> false;
    };
  }

  /** Whether an output counts messages: {@code NAME.count}. */
  public static boolean isCount(String output) {
    return output.equals(MemberPath.root(output) + COUNT);
  }

  /** What is wrong with one of these elements that holds from the start of a sequence. */
  public static Optional<String> initialProblem(InputElement input) {
    return MemberPath.root(input.name()).equals(RosNode.PUBLISH)
        ? Optional.of("says when a call publishes its input; move it to the call of a sequence")
        : ofStart(input);
  }

  /** What is wrong with the order of callbacks or a parameter. */
  private static Optional<String> ofStart(InputElement input) {
    if (input.kind() == InputKind.TDSD) {
      return isInteger(input.type())
          ? Optional.empty()
          : Optional.of("is a whole number, such as abstract_type NUMERIC, real_type int");
    }
    return PARAMETER_NAME.matcher(input.name()).matches()
        ? Optional.empty()
        : Optional.of("is not the name of a parameter, such as parameter.max_speed");
  }

  /** What is wrong with one of these elements in a model of a method. */
  public static Optional<String> problem(InputElement input, Method method, RosNode node) {
    if (input.kind() == InputKind.TDSD || input.name().startsWith(PARAMETER)) {
      return ofStart(input);
    }
    Matcher publish = PUBLISH.matcher(input.name());
    boolean known =
        publish.matches()
            && node.topicsWith(EndKind.INPUT).stream()
                .map(t -> t.end(EndKind.INPUT).orElseThrow())
                .filter(i -> method.name().equals(RosNode.PUBLISH) || method.name().equals(i))
                .anyMatch(publish.group(1)::equals);
    if (!known) {
      return Optional.of(
          "is not publish.NAME, publish.NAME.rate_hz, publish.NAME.at or publish.NAME.for of an"
              + " input NAME that "
              + method.name()
              + " publishes");
    }
    ScalarType type =
        input.type() instanceof DataType.Scalar scalar ? scalar.type() : ScalarType.VOID;
    boolean fits = publish.group(2) == null ? type == ScalarType.BOOLEAN : type.isNumeric();
    return fits
        ? Optional.empty()
        : Optional.of(
            publish.group(2) == null
                ? "is true or false; write abstract_type BOOLEAN, real_type boolean"
                : "is a number; write abstract_type NUMERIC, real_type double");
  }

  private static boolean isInteger(DataType type) {
    return type instanceof DataType.Scalar scalar && scalar.type().isInteger();
  }
}
