package org.sitaf.core.description;

import java.math.BigInteger;
import org.jspecify.annotations.Nullable;

/** Scalar types. */
public enum ScalarType {
  VOID("void", 0, false),
  BOOLEAN("boolean", 1, false),
  CHAR("char", 8, false),
  INT8("int8", 8, true),
  UINT8("uint8", 8, false),
  INT16("int16", 16, true),
  UINT16("uint16", 16, false),
  INT32("int32", 32, true),
  UINT32("uint32", 32, false),
  INT64("int64", 64, true),
  UINT64("uint64", 64, false),
  FLOAT("float", 32, true),
  DOUBLE("double", 64, true),
  STRING("string", 0, false);

  private final String typeName;
  private final int bits;
  private final boolean signed;

  ScalarType(String typeName, int bits, boolean signed) {
    this.typeName = typeName;
    this.bits = bits;
    this.signed = signed;
  }

  /** The canonical name. */
  public String typeName() {
    return typeName;
  }

  /** Whether values are whole numbers. */
  public boolean isInteger() {
    return switch (this) {
      case INT8, UINT8, INT16, UINT16, INT32, UINT32, INT64, UINT64 -> true;
      default -> false;
    };
  }

  /** Whether values are floating-point numbers. */
  public boolean isFloating() {
    return this == FLOAT || this == DOUBLE;
  }

  /** Whether values are numbers. */
  public boolean isNumeric() {
    return isInteger() || isFloating();
  }

  /** The minimum of an integer type; null for other types. */
  public @Nullable BigInteger minimum() {
    if (!isInteger()) {
      return null;
    }
    return signed ? BigInteger.ONE.shiftLeft(bits - 1).negate() : BigInteger.ZERO;
  }

  /** The maximum of an integer type; null for other types. */
  public @Nullable BigInteger maximum() {
    if (!isInteger()) {
      return null;
    }
    return BigInteger.ONE.shiftLeft(signed ? bits - 1 : bits).subtract(BigInteger.ONE);
  }
}
