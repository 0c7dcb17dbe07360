package org.sitaf.agent.sandbox.seccomp;

import java.util.List;

/**
 * A blocked system call.
 *
 * @param name as in its manual page
 * @param x86 its number on x86_64; {@link #NONE} where it does not exist
 * @param arm its number on aarch64; {@link #NONE} where it does not exist
 * @param errno error code that the call returns; 0 for success without effect
 * @param when conditions on the arguments, all of which must hold; always if empty
 */
record SystemCallRule(String name, int x86, int arm, int errno, List<Condition> when) {
  static final int NONE = -1;

  /** Operation not permitted, for calls that administer the machine. */
  static final int EPERM = 1;

  /** Function not implemented; programs then fall back to another call. */
  static final int ENOSYS = 38;

  static final int EAFNOSUPPORT = 97;

  /** A condition on the lower 32 bits of an argument; no call of the table uses the upper ones. */
  sealed interface Condition {
    /** Index of the argument, from 0. */
    int argument();
  }

  /** The argument equals one of these values. */
  record OneOf(int argument, List<Integer> values) implements Condition {
    OneOf {
      values = List.copyOf(values);
    }
  }

  /** The argument equals none of these values. */
  record NoneOf(int argument, List<Integer> values) implements Condition {
    NoneOf {
      values = List.copyOf(values);
    }
  }

  /** The argument has at least one of these bits. */
  record AnyBit(int argument, int bits) implements Condition {}

  SystemCallRule {
    when = List.copyOf(when);
  }

  static SystemCallRule of(String name, int x86, int arm, int errno, Condition... when) {
    return new SystemCallRule(name, x86, arm, errno, List.of(when));
  }

  int number(Architecture architecture) {
    return switch (architecture) {
      case X86_64 -> x86;
      case AARCH64 -> arm;
    };
  }
}
