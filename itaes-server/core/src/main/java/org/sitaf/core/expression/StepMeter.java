package org.sitaf.core.expression;

import com.google.errorprone.annotations.FormatMethod;
import dev.cel.common.ast.CelExpr;
import dev.cel.common.values.CelByteString;
import dev.cel.runtime.CelEvaluationListener;
import dev.cel.runtime.ConcatenatedListView;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Counts the steps of one evaluation, and ends it where they are too many, a value grows too large,
 * or the thread is interrupted. CEL calls it after each node, in loops too.
 */
final class StepMeter implements CelEvaluationListener {
  private static final int CHARACTERS_PER_STEP = 16;

  /** A character costs as much for each thread of the automaton. */
  private static final int STEPS_PER_SEARCHED_CHARACTER = 20;

  private static final int ASK_EVERY = 512;

  private final NodeRoles roles;
  private long left = ExpressionLimits.MAX_STEPS;
  private int untilAsked = ASK_EVERY;

  /**
   * Ends an evaluation. An error, since CEL takes every exception within {@code &&} and {@code ||}
   * for a value and goes on.
   */
  static final class Stopped extends Error {
    private static final long serialVersionUID = 1L;

    private final boolean interrupted;

    Stopped(String message, boolean interrupted) {
      super(message, null, false, false);
      this.interrupted = interrupted;
    }

    /** Whether the thread was interrupted, and the expression is not to blame. */
    boolean interrupted() {
      return interrupted;
    }
  }

  StepMeter(NodeRoles roles) {
    this.roles = roles;
  }

  @Override
  public void callback(CelExpr node, Object value) {
    spend(1);
    byte role = roles.of(node);
    if (value instanceof Long || value instanceof Boolean || value instanceof Double) {
      return;
    }
    if (value instanceof String text) {
      text(text, role);
    } else if (role == NodeRoles.COMPARED) {
      whole(value, 0);
    } else if (role == NodeRoles.MADE) {
      made(value);
    }
  }

  private void text(String text, byte role) {
    int length = text.length();
    limit(length, "a text of %,d characters");
    spend(length / CHARACTERS_PER_STEP);
    if (role == NodeRoles.MADE) {
      spend(length / 4);
    } else if (role == NodeRoles.SEARCHED) {
      spend((long) length * STEPS_PER_SEARCHED_CHARACTER);
    } else if (role == NodeRoles.PATTERN) {
      long size = PatternSize.of(text);
      if (size > ExpressionLimits.MAX_PATTERN) {
        throw stopped(
            "a regular expression in it is of size %,d, its repetitions written out; at most %,d"
                + " are allowed: use smaller numbers in {}",
            size, ExpressionLimits.MAX_PATTERN);
      }
      spend(10 * size);
    }
  }

  /** The list that a loop collects is a view that grows in place: it costs nothing again. */
  private void made(Object value) {
    if (value instanceof CelByteString bytes) {
      limit(bytes.size(), "%,d bytes");
      spend(bytes.size() / 4);
    } else if (value instanceof List<?> list && !(value instanceof ConcatenatedListView)) {
      limit(list.size(), "a list of %,d elements");
      spend(list.size() / 4);
    } else if (value instanceof ConcatenatedListView<?> list) {
      limit(list.size(), "a list of %,d elements");
    }
  }

  /** All that lies in a value, as often as it occurs: parts may be shared, work on them is not. */
  private void whole(Object value, int depth) {
    spend(1);
    if (depth > ExpressionLimits.MAX_DEPTH) {
      throw stopped("lists in it lie more than %,d deep in each other", ExpressionLimits.MAX_DEPTH);
    }
    if (value instanceof String text) {
      spend(text.length() / CHARACTERS_PER_STEP);
    } else if (value instanceof CelByteString bytes) {
      spend(bytes.size() / CHARACTERS_PER_STEP);
    } else if (value instanceof List<?> list) {
      for (Object element : list) {
        whole(element, depth + 1);
      }
    } else if (value instanceof Map<?, ?> map) {
      for (Map.Entry<?, ?> entry : map.entrySet()) {
        whole(entry.getKey(), depth + 1);
        whole(entry.getValue(), depth + 1);
      }
    }
  }

  private void spend(long steps) {
    left -= steps;
    if (left < 0) {
      throw stopped(
          "it took more than %,d steps: simplify it, or have fewer elements in what it goes"
              + " through",
          ExpressionLimits.MAX_STEPS);
    }
    if (--untilAsked == 0) {
      untilAsked = ASK_EVERY;
      if (Thread.currentThread().isInterrupted()) {
        throw new Stopped("the evaluation was interrupted", true);
      }
    }
  }

  private static void limit(int length, String what) {
    if (length > ExpressionLimits.MAX_LENGTH) {
      throw new Stopped(
          String.format(Locale.ROOT, "it makes " + what, length)
              + String.format(Locale.ROOT, "; at most %,d", ExpressionLimits.MAX_LENGTH)
              + " are allowed",
          false);
    }
  }

  @FormatMethod
  private static Stopped stopped(String format, Object... numbers) {
    return new Stopped(String.format(Locale.ROOT, format, numbers), false);
  }
}
