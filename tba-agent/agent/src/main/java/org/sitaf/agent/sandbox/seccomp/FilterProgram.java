package org.sitaf.agent.sandbox.seccomp;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.sitaf.agent.sandbox.seccomp.SystemCallRule.AnyBit;
import org.sitaf.agent.sandbox.seccomp.SystemCallRule.Condition;
import org.sitaf.agent.sandbox.seccomp.SystemCallRule.NoneOf;
import org.sitaf.agent.sandbox.seccomp.SystemCallRule.OneOf;

/**
 * Encodes rules as classic BPF, see {@code linux/filter.h} and {@code linux/seccomp.h}. Both
 * architectures are little-endian.
 */
final class FilterProgram {
  private static final int LOAD = 0x20;
  private static final int JUMP = 0x05;
  private static final int JUMP_IF_EQUAL = 0x15;
  private static final int JUMP_IF_ABOVE = 0x25;
  private static final int JUMP_IF_ANY_BIT = 0x45;
  private static final int RETURN = 0x06;

  private static final int ALLOW = 0x7FFF0000;
  private static final int FAIL = 0x00050000;

  /** Offsets in {@code struct seccomp_data}. */
  private static final int NUMBER = 0;

  private static final int ARCHITECTURE = 4;
  private static final int ARGUMENTS = 16;

  private static final int INSTRUCTION_BYTES = 8;

  /** One {@code struct sock_filter}. */
  private record Instruction(int code, int ifTrue, int ifFalse, int operand) {}

  private final List<Instruction> instructions = new ArrayList<>();

  private FilterProgram() {}

  /**
   * The program that blocks the calls of the rules and allows all others. Calls of another
   * architecture (such as 32-bit programs), of x32, and calls newer than the table fail with {@code
   * ENOSYS}.
   */
  static byte[] of(Architecture architecture, List<SystemCallRule> rules) {
    FilterProgram program = new FilterProgram();
    program.add(LOAD, 0, 0, ARCHITECTURE);
    program.add(JUMP_IF_EQUAL, 1, 0, architecture.audit());
    program.fail(SystemCallRule.ENOSYS);
    program.add(LOAD, 0, 0, NUMBER);
    // x32 call numbers have bit 30 set and are covered too.
    program.add(JUMP_IF_ABOVE, 0, 1, SystemCallRules.NEWEST);
    program.fail(SystemCallRule.ENOSYS);
    for (SystemCallRule rule : rules) {
      int number = rule.number(architecture);
      if (number != SystemCallRule.NONE) {
        program.block(number, rule);
      }
    }
    program.add(RETURN, 0, 0, ALLOW);
    return program.bytes();
  }

  private void block(int number, SystemCallRule rule) {
    FilterProgram body = new FilterProgram();
    rule.when().forEach(body::require);
    body.fail(rule.errno());
    if (!rule.when().isEmpty()) {
      // A condition does not hold: load the number again for the next rule.
      body.add(LOAD, 0, 0, NUMBER);
    }
    add(JUMP_IF_EQUAL, 0, body.instructions.size(), number);
    int end = body.instructions.size() - 1;
    for (int i = 0; i < body.instructions.size(); i++) {
      Instruction instruction = body.instructions.get(i);
      // Jumps are relative to the next instruction.
      instructions.add(
          instruction.code() == JUMP ? new Instruction(JUMP, 0, 0, end - i - 1) : instruction);
    }
  }

  /** Continues if the condition holds; otherwise {@link #JUMP}, whose target the caller sets. */
  private void require(Condition condition) {
    add(LOAD, 0, 0, ARGUMENTS + 8 * condition.argument());
    if (condition instanceof AnyBit any) {
      add(JUMP_IF_ANY_BIT, 1, 0, any.bits());
      add(JUMP, 0, 0, 0);
    } else if (condition instanceof OneOf one) {
      int left = one.values().size();
      for (int value : one.values()) {
        add(JUMP_IF_EQUAL, left--, 0, value);
      }
      add(JUMP, 0, 0, 0);
    } else if (condition instanceof NoneOf none) {
      int left = none.values().size();
      for (int value : none.values()) {
        add(JUMP_IF_EQUAL, left--, 0, value);
      }
      add(JUMP_IF_EQUAL, 1, 1, 0);
      add(JUMP, 0, 0, 0);
    }
  }

  private void fail(int errno) {
    add(RETURN, 0, 0, FAIL | errno);
  }

  private void add(int code, int ifTrue, int ifFalse, int operand) {
    instructions.add(new Instruction(code, ifTrue, ifFalse, operand));
  }

  private byte[] bytes() {
    ByteBuffer buffer =
        ByteBuffer.allocate(instructions.size() * INSTRUCTION_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    for (Instruction instruction : instructions) {
      buffer
          .putShort((short) instruction.code())
          .put((byte) instruction.ifTrue())
          .put((byte) instruction.ifFalse())
          .putInt(instruction.operand());
    }
    return buffer.array();
  }
}
