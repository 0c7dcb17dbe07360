package org.sitaf.core.trajectory;

/** A formula is not valid. */
public final class FormulaException extends Exception {
  private static final long serialVersionUID = 1L;

  private final int line;
  private final int column;

  FormulaException(String message, int line, int column) {
    super(message);
    this.line = line;
    this.column = column;
  }

  /** Line in the formula, from 1. */
  public int line() {
    return line;
  }

  /** Column in the line, from 1. */
  public int column() {
    return column;
  }
}
