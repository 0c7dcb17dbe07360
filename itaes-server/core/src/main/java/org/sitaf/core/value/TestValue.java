package org.sitaf.core.value;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.RelatedOffset;
import org.sitaf.core.model.Value;

/**
 * A test value, and whether it is valid by the specification.
 *
 * @param each whether the value has one case instead of all tuples
 * @param relation the other input that the value follows; its {@code value} is then only a text
 *     that describes it, until a case resolves it; null for all other values
 */
public record TestValue(Value value, boolean valid, boolean each, @Nullable Relation relation) {

  /**
   * A relation to another input of the same case.
   *
   * @param to name of the other input
   */
  public record Relation(String to, RelatedOffset offset) {
    public Relation {
      Objects.requireNonNull(to);
      Objects.requireNonNull(offset);
    }

    /** Such as {@code Limit}, {@code Limit + 1ulp} or {@code Limit - 10%}. */
    public String text() {
      return switch (offset.amount().signum()) {
        case 0 -> to;
        case 1 -> to + " + " + offset.text();
        default -> to + " - " + new RelatedOffset(offset.unit(), offset.amount().negate()).text();
      };
    }
  }

  public TestValue {
    Objects.requireNonNull(value);
  }

  /** A value that is combined with all others. */
  public TestValue(Value value, boolean valid) {
    this(value, valid, false, null);
  }

  static TestValue related(Relation relation) {
    return new TestValue(new Value.Text(relation.text()), true, false, relation);
  }
}
