package org.sitaf.core.expression;

import com.google.errorprone.annotations.FormatMethod;
import dev.cel.common.ast.CelExpr;
import dev.cel.common.values.CelByteString;
import dev.cel.runtime.CelEvaluationListener;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Counts the steps of one evaluation. Stops the evaluation if there are too many steps, a value is
 * too large, or the thread is interrupted. CEL calls the listener after each node, also in loops.
 */
final class StepMeter implements CelEvaluationListener {
  private static final int CHARACTERS_PER_STEP = 16;

  /** The regular expression automaton processes each character once per thread. */
  private static final int STEPS_PER_SEARCHED_CHARACTER = 20;

  private static final int STEPS_PER_CHECK = 512;

  /** Parts of a list or map that CEL visits in the time of one step. */
  private static final int PARTS_PER_STEP = 4;

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  private final NodeRoles roles;
  private int parts;
  private long left = ExpressionLimits.MAX_STEPS;
  private int untilCheck = STEPS_PER_CHECK;

  /** Time of the thread at the first check; 0 before. */
  private long checkedNanos;

  /**
   * Stops an evaluation. This is an Error because CEL treats exceptions within {@code &&} and
   * {@code ||} as values and continues.
   */
  static final class Stopped extends Error {
    private static final long serialVersionUID = 1L;

    private final boolean interrupted;

    Stopped(String message, boolean interrupted) {
      super(message, null, false, false);
      this.interrupted = interrupted;
    }

    /** Whether the thread was interrupted; otherwise the expression exceeded a limit. */
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
      visitString(text, role);
    } else if (role == NodeRoles.COMPARED) {
      visitAll(value, 0);
    } else if (role == NodeRoles.MULTIPLIED) {
      visitAll(value, 0);
      visitMatrix(value);
    } else {
      visitContainer(value, 0);
    }
  }

  private void visitMatrix(Object value) {
    if (value instanceof List<?> rows && !rows.isEmpty()) {
      long columns = rows.get(0) instanceof List<?> row ? row.size() : 1;
      // Both factors of a product count, so the longest of its three sides counts twice.
      spend(rows.size() * columns * Math.max(rows.size(), columns));
    }
  }

  private void visitString(String text, byte role) {
    int length = text.length();
    checkLength(length, "a string of %,d characters");
    spend(length / CHARACTERS_PER_STEP);
    if (role == NodeRoles.CREATED) {
      spend(length / 4);
    } else if (role == NodeRoles.SEARCHED) {
      spend((long) length * STEPS_PER_SEARCHED_CHARACTER);
    } else if (role == NodeRoles.PATTERN) {
      long size = PatternSize.of(text);
      if (size > ExpressionLimits.MAX_PATTERN) {
        throw limitExceeded(
            "a regular expression in it has size %,d with expanded repetitions, more than the limit"
                + " of %,d; use smaller numbers in {}",
            size, ExpressionLimits.MAX_PATTERN);
      }
      spend(10 * size);
    }
  }

  /** CEL visits all parts of a list or map that a variable, a function or a loop gives. */
  private void visitContainer(Object value, int depth) {
    if (value instanceof CelByteString bytes) {
      checkLength(bytes.size(), "%,d bytes");
      spend(bytes.size() / 4);
    } else if (value instanceof List<?> list) {
      checkLength(list.size(), "a list of %,d elements");
      checkDepth(depth);
      for (Object element : list) {
        visitPart(element, depth);
      }
    } else if (value instanceof Map<?, ?> map) {
      checkDepth(depth);
      for (Object element : map.values()) {
        visitPart(element, depth);
      }
    }
  }

  private void visitPart(Object part, int depth) {
    if (++parts == PARTS_PER_STEP) {
      parts = 0;
      spend(1);
    }
    if (!(part instanceof Double || part instanceof Long || part instanceof String)) {
      visitContainer(part, depth + 1);
    }
  }

  private static void checkDepth(int depth) {
    if (depth > ExpressionLimits.MAX_DEPTH) {
      throw limitExceeded(
          "lists in it are nested more than %,d levels deep", ExpressionLimits.MAX_DEPTH);
    }
  }

  /**
   * Counts all parts of a value. Shared parts count each time, since they are processed each time.
   */
  private void visitAll(Object value, int depth) {
    spend(1);
    checkDepth(depth);
    if (value instanceof String text) {
      spend(text.length() / CHARACTERS_PER_STEP);
    } else if (value instanceof CelByteString bytes) {
      spend(bytes.size() / CHARACTERS_PER_STEP);
    } else if (value instanceof List<?> list) {
      for (Object element : list) {
        visitAll(element, depth + 1);
      }
    } else if (value instanceof Map<?, ?> map) {
      for (Map.Entry<?, ?> entry : map.entrySet()) {
        visitAll(entry.getKey(), depth + 1);
        visitAll(entry.getValue(), depth + 1);
      }
    }
  }

  private void spend(long steps) {
    left -= steps;
    if (left < 0) {
      throw limitExceeded(
          "it took more than %,d steps; simplify it, or let it iterate over fewer elements",
          ExpressionLimits.MAX_STEPS);
    }
    if (--untilCheck == 0) {
      untilCheck = STEPS_PER_CHECK;
      check();
    }
  }

  /**
   * The time is that of the processor, so that other load does not change a verdict. It matters for
   * errors that CEL absorbs: each is an exception, which takes the time of hundreds of steps.
   */
  private void check() {
    if (Thread.currentThread().isInterrupted()) {
      throw new Stopped("the evaluation was interrupted", true);
    }
    long now = THREADS.getCurrentThreadCpuTime();
    if (checkedNanos == 0) {
      checkedNanos = now;
    } else if (now - checkedNanos > ExpressionLimits.MAX_TIME.toNanos()) {
      throw limitExceeded(
          "it took more than %,d s of processor time; simplify it, or let it iterate over fewer"
              + " elements",
          ExpressionLimits.MAX_TIME.toSeconds());
    }
  }

  private static void checkLength(int length, String what) {
    if (length > ExpressionLimits.MAX_LENGTH) {
      throw new Stopped(
          String.format(Locale.ROOT, "it creates " + what, length)
              + String.format(Locale.ROOT, "; at most %,d", ExpressionLimits.MAX_LENGTH)
              + " are allowed",
          false);
    }
  }

  @FormatMethod
  private static Stopped limitExceeded(String format, Object... numbers) {
    return new Stopped(String.format(Locale.ROOT, format, numbers), false);
  }
}
