package org.sitaf.agent.sandbox.seccomp;

import java.util.List;

/**
 * A system call that is refused.
 *
 * @param name as in the manual
 * @param x86 its number on x86_64; {@link #NONE} where it does not exist
 * @param arm its number on aarch64; {@link #NONE} where it does not exist
 * @param errno with which it fails; 0 lets it succeed without effect
 * @param when all of these hold for its arguments; always where there are none
 */
record Refusal(String name, int x86, int arm, int errno, List<Condition> when) {
  static final int NONE = -1;

  /** Not permitted: what administers a machine. */
  static final int EPERM = 1;

  /** As if the kernel did not have it: programs then use something else. */
  static final int ENOSYS = 38;

  static final int EAFNOSUPPORT = 97;

  /** What is asked of the lower half of an argument; no call in the table reads the upper one. */
  sealed interface Condition {
    /** Counted from 0. */
    int argument();
  }

  /** The argument is one of these. */
  record OneOf(int argument, List<Integer> values) implements Condition {
    OneOf {
      values = List.copyOf(values);
    }
  }

  /** The argument is none of these. */
  record NoneOf(int argument, List<Integer> values) implements Condition {
    NoneOf {
      values = List.copyOf(values);
    }
  }

  /** The argument has one of these bits. */
  record AnyBit(int argument, int bits) implements Condition {}

  Refusal {
    when = List.copyOf(when);
  }

  static Refusal of(String name, int x86, int arm, int errno, Condition... when) {
    return new Refusal(name, x86, arm, errno, List.of(when));
  }

  int number(Architecture architecture) {
    return switch (architecture) {
      case X86_64 -> x86;
      case AARCH64 -> arm;
    };
  }
}
