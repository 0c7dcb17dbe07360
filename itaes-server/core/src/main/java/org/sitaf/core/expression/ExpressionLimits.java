package org.sitaf.core.expression;

import dev.cel.common.CelOptions;
import java.time.Duration;

/**
 * Limits of expressions. A step is the evaluation of one node of the syntax tree or an equivalent
 * amount of work: some dozens of nanoseconds.
 */
final class ExpressionLimits {
  /** Maximum length of an expression in characters. */
  static final int MAX_CHARACTERS = 20_000;

  /** Maximum number of operands and operators. */
  static final int MAX_NODES = 20_000;

  /** Maximum nesting of brackets, operators and macros. */
  static final int MAX_NESTING = 250;

  /** Maximum number of parts of a type. A list of lists of numbers has 3 parts. */
  static final int MAX_TYPE_PARTS = 1_000;

  /** Maximum number of steps of one evaluation; takes less than a second without errors. */
  static final long MAX_STEPS = 5_000_000;

  /** Maximum processor time of one evaluation. */
  static final Duration MAX_TIME = Duration.ofSeconds(3);

  /** Maximum length of a string or list that an expression creates. */
  static final int MAX_LENGTH = 1_000_000;

  /** Maximum nesting of lists and maps in a value. */
  static final int MAX_DEPTH = 100;

  /** Maximum size of a regular expression with expanded repetitions. */
  static final int MAX_PATTERN = 1_000;

  /** Integers and floating-point numbers are comparable. */
  static final CelOptions OPTIONS =
      CelOptions.current()
          .enableHeterogeneousNumericComparisons(true)
          .maxExpressionCodePointSize(MAX_CHARACTERS)
          .maxParseExpressionNodeCount(MAX_NODES)
          .maxParseRecursionDepth(MAX_NESTING)
          .maxRegexProgramSize(2 * MAX_PATTERN)
          .build();

  private ExpressionLimits() {}
}
