package org.sitaf.agent.sandbox.seccomp;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The filter implements the rules, for each architecture. */
class FilterProgramTest {
  private static final int ALLOW = 0x7FFF0000;
  private static final int FAIL = 0x00050000;
  private static final int UNSHARE_OF_AARCH64 = 97;
  private static final int READ_OF_AARCH64 = 63;

  private static List<SystemCallRule> all() {
    List<SystemCallRule> all = new ArrayList<>(SystemCallRules.ALWAYS);
    all.addAll(SystemCallRules.WITHOUT_MEMORY_GROUP);
    all.addAll(SystemCallRules.WITHOUT_CPU_GROUP);
    return all;
  }

  /** Interprets a program like the kernel. */
  private static int verdict(byte[] program, int audit, int number, int... arguments) {
    ByteBuffer data = ByteBuffer.allocate(64).order(ByteOrder.LITTLE_ENDIAN);
    data.putInt(0, number).putInt(4, audit);
    for (int i = 0; i < arguments.length; i++) {
      data.putLong(16 + 8 * i, Integer.toUnsignedLong(arguments[i]));
    }
    ByteBuffer code = ByteBuffer.wrap(program).order(ByteOrder.LITTLE_ENDIAN);
    int accumulator = 0;
    for (int at = 0; ; at++) {
      int operation = code.getShort(at * 8);
      int ifTrue = code.get(at * 8 + 2) & 0xFF;
      int ifFalse = code.get(at * 8 + 3) & 0xFF;
      int operand = code.getInt(at * 8 + 4);
      switch (operation) {
        case 0x20 -> accumulator = data.getInt(operand);
        case 0x05 -> at += operand;
        case 0x15 -> at += accumulator == operand ? ifTrue : ifFalse;
        case 0x25 -> at += Integer.compareUnsigned(accumulator, operand) > 0 ? ifTrue : ifFalse;
        case 0x45 -> at += (accumulator & operand) != 0 ? ifTrue : ifFalse;
        case 0x06 -> {
          return operand;
        }
        default -> throw new AssertionError("operation " + operation);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Architecture.class)
  void blocksEachCallOfTheTable(Architecture architecture) {
    byte[] program = FilterProgram.of(architecture, all());
    for (SystemCallRule rule : all()) {
      int number = rule.number(architecture);
      if (number != SystemCallRule.NONE && rule.when().isEmpty()) {
        assertThat(verdict(program, architecture.audit(), number))
            .as(rule.name())
            .isEqualTo(FAIL | rule.errno());
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Architecture.class)
  void evaluatesConditionsOnArguments(Architecture architecture) {
    byte[] program = FilterProgram.of(architecture, all());
    int audit = architecture.audit();
    int clone = number("clone", architecture);
    int socket = number("socket", architecture);
    int personality = number("personality", architecture);

    assertThat(verdict(program, audit, clone, 0x003d0f00)).isEqualTo(ALLOW);
    assertThat(verdict(program, audit, clone, 0x10000011)).isEqualTo(FAIL | SystemCallRule.EPERM);
    assertThat(verdict(program, audit, socket, 2, 1, 0)).isEqualTo(ALLOW);
    assertThat(verdict(program, audit, socket, 40, 1, 0))
        .isEqualTo(FAIL | SystemCallRule.EAFNOSUPPORT);
    assertThat(verdict(program, audit, socket, 16, 3, 0)).isEqualTo(ALLOW);
    assertThat(verdict(program, audit, socket, 16, 3, 12))
        .isEqualTo(FAIL | SystemCallRule.EAFNOSUPPORT);
    assertThat(verdict(program, audit, personality, -1)).isEqualTo(ALLOW);
    assertThat(verdict(program, audit, personality, 0x40000))
        .isEqualTo(FAIL | SystemCallRule.EPERM);
  }

  @Test
  void rejectsOtherArchitecturesAndNewerCalls() {
    byte[] program = FilterProgram.of(Architecture.X86_64, all());
    int audit = Architecture.X86_64.audit();

    assertThat(verdict(program, audit, 0)).isEqualTo(ALLOW);
    assertThat(verdict(program, 0x40000003, 0)).isEqualTo(FAIL | SystemCallRule.ENOSYS);
    assertThat(verdict(program, audit, 0x40000000)).isEqualTo(FAIL | SystemCallRule.ENOSYS);
    assertThat(verdict(program, audit, SystemCallRules.NEWEST)).isEqualTo(ALLOW);
    assertThat(verdict(program, audit, SystemCallRules.NEWEST + 1))
        .isEqualTo(FAIL | SystemCallRule.ENOSYS);
  }

  @Test
  void usesTheNumbersOfEachArchitecture() {
    byte[] program = FilterProgram.of(Architecture.AARCH64, all());
    int audit = Architecture.AARCH64.audit();

    assertThat(verdict(program, audit, UNSHARE_OF_AARCH64)).isEqualTo(FAIL | SystemCallRule.EPERM);
    assertThat(verdict(program, audit, READ_OF_AARCH64)).isEqualTo(ALLOW);
  }

  private static int number(String name, Architecture architecture) {
    return all().stream()
        .filter(rule -> rule.name().equals(name))
        .findFirst()
        .orElseThrow()
        .number(architecture);
  }
}
