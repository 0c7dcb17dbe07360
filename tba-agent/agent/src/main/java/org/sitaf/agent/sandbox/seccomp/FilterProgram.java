package org.sitaf.agent.sandbox.seccomp;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.sitaf.agent.sandbox.seccomp.Refusal.AnyBit;
import org.sitaf.agent.sandbox.seccomp.Refusal.Condition;
import org.sitaf.agent.sandbox.seccomp.Refusal.NoneOf;
import org.sitaf.agent.sandbox.seccomp.Refusal.OneOf;

/**
 * A table as classic BPF, see {@code linux/filter.h} and {@code linux/seccomp.h}. Both
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
   * The program that refuses these calls and allows the others. Calls of another architecture (as
   * 32-bit programs make them), of x32, and calls that are newer than the table are unknown.
   */
  static byte[] of(Architecture architecture, List<Refusal> refusals) {
    FilterProgram program = new FilterProgram();
    program.add(LOAD, 0, 0, ARCHITECTURE);
    program.add(JUMP_IF_EQUAL, 1, 0, architecture.audit());
    program.fail(Refusal.ENOSYS);
    program.add(LOAD, 0, 0, NUMBER);
    // The numbers of x32 have bit 30 and are above too.
    program.add(JUMP_IF_ABOVE, 0, 1, Refusals.NEWEST);
    program.fail(Refusal.ENOSYS);
    for (Refusal refusal : refusals) {
      int number = refusal.number(architecture);
      if (number != Refusal.NONE) {
        program.refuse(number, refusal);
      }
    }
    program.add(RETURN, 0, 0, ALLOW);
    return program.bytes();
  }

  private void refuse(int number, Refusal refusal) {
    FilterProgram body = new FilterProgram();
    refusal.when().forEach(body::require);
    body.fail(refusal.errno());
    if (!refusal.when().isEmpty()) {
      // Where a condition does not hold: the next refusal looks at the number again.
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

  /** Goes on where the condition holds; else {@link #JUMP}, whose end is set by the caller. */
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
