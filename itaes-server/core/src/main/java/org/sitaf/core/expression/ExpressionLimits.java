package org.sitaf.core.expression;

import dev.cel.common.CelOptions;

/**
 * What an expression may be and may take. A step is the evaluation of one node of the syntax tree,
 * or as much work as one: some dozens of nanoseconds.
 */
final class ExpressionLimits {
  /** Characters of an expression. */
  static final int MAX_CHARACTERS = 20_000;

  /** Operands and operators of an expression. */
  static final int MAX_NODES = 20_000;

  /** Brackets, operators and macros within each other. */
  static final int MAX_NESTING = 250;

  /** Parts of the type of a value, such as 3 of a list of lists of numbers. */
  static final int MAX_TYPE_PARTS = 1_000;

  /** Steps of one evaluation: below a second. */
  static final long MAX_STEPS = 5_000_000;

  /** Characters of a text and elements of a list that an expression makes. */
  static final int MAX_LENGTH = 1_000_000;

  /** How deep lists and maps may lie in each other. */
  static final int MAX_DEPTH = 100;

  /** Instructions of a regular expression, its repetitions written out. */
  static final int MAX_PATTERN = 1_000;

  /** Whole and floating-point numbers compare across types. */
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
