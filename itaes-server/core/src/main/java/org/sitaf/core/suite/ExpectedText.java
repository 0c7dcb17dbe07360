package org.sitaf.core.suite;

import java.util.Optional;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.type.Type;
import org.sitaf.core.model.Value;

/** The text of an expected value: an expression, or an outcome without quotes. */
public final class ExpectedText {
  private static final Pattern OUTCOME =
      Pattern.compile(
          Pattern.quote(Value.ERROR_PREFIX) + "\\w+|" + Value.ANY_ERROR + "|" + Value.ANY);

  private ExpectedText() {}

  /** The expression: an outcome such as {@code !error:NoEcho} becomes a string. */
  public static String expression(@Nullable String expected) {
    String stripped = expected == null ? "" : expected.strip();
    return OUTCOME.matcher(stripped).matches() ? '"' + stripped + '"' : stripped;
  }

  /** Why the expression cannot give a value of the output's type; empty if it can. */
  public static Optional<String> problem(Expression expression, DataType output) {
    Type given = expression.type();
    if (output.isVoid()) {
      boolean fits = given.equals(Type.NULL) || given.equals(Type.OUTCOME) || given.isOpen();
      return fits
          ? Optional.empty()
          : Optional.of(
              "the method returns nothing; expect null, or an error such as \"!error:NAME\", not '"
                  + expression.text()
                  + "'");
    }
    Type wanted = Type.of(output);
    // 0 and 1 are booleans in documents, and any value without parts has a text.
    boolean isText =
        output instanceof DataType.Scalar scalar
            && (scalar.type() == ScalarType.STRING || scalar.type() == ScalarType.CHAR);
    boolean hasLiteral = given.mayBeNumber() || given.equals(Type.BOOLEAN);
    if (Type.join(wanted, given) != null
        || wanted.equals(Type.BOOLEAN) && given.equals(Type.WHOLE)
        || isText && hasLiteral) {
      return Optional.empty();
    }
    return Optional.of(
        "the type of '"
            + expression.text()
            + "' is "
            + given.name()
            + ", but that of the output is "
            + output.typeName());
  }
}
