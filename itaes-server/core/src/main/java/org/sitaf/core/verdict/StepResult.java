package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * The result of a step of a sequence.
 *
 * @param name of the call or event in the test model
 * @param afterFailure whether an earlier step of the case failed, so that this verdict may be a
 *     consequence
 * @param inputs by name, in the order of the call's inputs; none for an event
 * @param at simulation time in seconds at which it began, since the first step began; null if it
 *     was not executed
 * @param time of the call; null for an event and if it did not end
 * @param message why the verdict is not PASS; empty otherwise
 * @param before the abstract state before the step; null if it is unknown or was not reached
 * @param after the abstract state after the step; null if it is unknown or was not reached
 */
public record StepResult(
    String name,
    Kind kind,
    Verdict verdict,
    boolean afterFailure,
    List<NamedValue> inputs,
    List<NamedValue> expected,
    List<NamedValue> actual,
    @Nullable Double at,
    CaseResult.@Nullable ProcessingTime time,
    String message,
    @Nullable String before,
    @Nullable String after) {

  /** Whether a step may be executed where it is. */
  public enum Kind {
    VALID(""),
    /** The guard of the call is false. */
    FORBIDDEN("forbidden"),
    /** The call has an invalid value. */
    INVALID("invalid value");

    private final String words;

    Kind(String words) {
      this.words = words;
    }

    /** As messages name it; empty for a valid step. */
    public String words() {
      return words;
    }
  }

  public StepResult {
    Objects.requireNonNull(name);
    // Stored results of earlier versions have neither a kind nor names of inputs.
    kind = kind == null ? Kind.VALID : kind;
    Objects.requireNonNull(verdict);
    inputs = inputs == null ? List.of() : List.copyOf(inputs);
    expected = List.copyOf(expected);
    actual = List.copyOf(actual);
    Objects.requireNonNull(message);
  }

  /** The step as messages name it: {@code step 3 (Read)}. */
  public static String label(int number, String name) {
    return "step " + number + " (" + name + ")";
  }

  /** The step as messages name it: {@code step 3 (Read)} or {@code step 3 (Read, forbidden)}. */
  public String label(int number) {
    return label(number, kind == Kind.VALID ? name : name + ", " + kind.words());
  }

  /** The step as a call: {@code Read(1, 7)}. */
  public String call() {
    return name + "(" + String.join(", ", values()) + ")";
  }

  /** The literals of the inputs. */
  public List<String> values() {
    return inputs.stream().map(NamedValue::literal).toList();
  }

  /**
   * Whether this step decides the verdict of its case: the first one that did not pass. A step that
   * was not reached does not.
   */
  public boolean decides() {
    return verdict != Verdict.PASS && !afterFailure && (verdict != Verdict.DONT || at != null);
  }
}
