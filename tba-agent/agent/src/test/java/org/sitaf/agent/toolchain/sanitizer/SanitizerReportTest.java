package org.sitaf.agent.toolchain.sanitizer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SanitizerReportTest {
  private static final String OVERFLOW =
      """
      =================================================================
      ==17==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x602000000118 at pc 0x1 bp 0x2 sp 0x3
      WRITE of size 8 at 0x602000000118 thread T0
          #0 0x55d0c in std::vector<double>::operator[](unsigned long) /usr/include/c++/12/bits/stl_vector.h:1123
          #1 0x55d0d in arm::ArmHold::Step(double) activity/component/src/arm_hold.cpp:38
          #2 0x55d0e in main harness/hold/main.cpp:5

      0x602000000118 is located 0 bytes to the right of 8-byte region [0x602000000110,0x602000000118)
      allocated by thread T0 here:
          #0 0x7f in operator new(unsigned long) (/lib/libasan.so.8+0xb9)
          #1 0x55d0f in arm::ArmHold::ArmHold() activity/component/src/arm_hold.cpp:12

      SUMMARY: AddressSanitizer: heap-buffer-overflow /usr/include/c++/12/bits/stl_vector.h:1123 in operator[]
      ==17==ABORTING
      """;

  @Test
  void namesTheKindAndTheFirstLineInTheUsersSources() {
    assertThat(SanitizerReport.cause("output before\n" + OVERFLOW))
        .contains("heap-buffer-overflow at arm_hold.cpp:38");
  }

  @Test
  void readsUndefinedBehaviour() {
    String report =
        "activity/component/gain.cpp:7:12: runtime error: signed integer overflow: 2147483647 + 1"
            + " cannot be represented in type 'int'\n";
    assertThat(SanitizerReport.cause(report))
        .contains(
            "signed integer overflow: 2147483647 + 1 cannot be represented in type 'int'"
                + " at gain.cpp:7");
  }

  @Test
  void readsUndefinedBehaviourInAHeaderOfTheMachineWithItsStack() {
    String report =
        """
        /usr/include/c++/12/bits/stl_vector.h:1123:9: runtime error: reference binding to null pointer
            #0 0x55 in std::vector<double>::operator[](unsigned long) /usr/include/c++/12/bits/stl_vector.h:1123
            #1 0x56 in Gain::At(int) activity/component/gain.cpp:9:4
        SUMMARY: UndefinedBehaviorSanitizer: undefined-behavior /usr/include/c++/12/bits/stl_vector.h:1123:9 in
        """;
    assertThat(SanitizerReport.cause(report))
        .contains("reference binding to null pointer at gain.cpp:9");
  }

  @Test
  void readsDataRaces() {
    String report =
        """
        ==================
        WARNING: ThreadSanitizer: data race (pid=4242)
          Write of size 4 at 0x7b0400000010 by thread T2:
            #0 std::vector<int>::push_back(int const&) /usr/include/c++/12/bits/stl_vector.h:1287 (hold+0x1a2b)
            #1 Arm::Move(int) activity/component/arm.cpp:21 (hold+0x1a2b)

          Previous write of size 4 at 0x7b0400000010 by thread T1:
            #0 Arm::Stop() activity/component/arm.cpp:44 (hold+0x1a2b)

        SUMMARY: ThreadSanitizer: data race activity/component/arm.cpp:21 in Arm::Move(int)
        ==================
        """;
    assertThat(SanitizerReport.cause(report)).contains("data race at arm.cpp:21");
  }

  @Test
  void aReportOutsideOfTheUsersSourcesHasNoLine() {
    assertThat(SanitizerReport.cause(OVERFLOW.replace("activity/", "harness/")))
        .contains("heap-buffer-overflow");
  }

  @Test
  void otherOutputIsNoReport() {
    assertThat(SanitizerReport.cause("terminate called\nSUMMARY: AddressSanitizer: nothing\n"))
        .isEmpty();
  }

  @Test
  void endlessLinesAreReadQuickly() {
    String hostile = ("    #1 0x5 in " + " ".repeat(5_000) + "x:1:1:\n").repeat(12);
    assertThat(SanitizerReport.cause("==1==ERROR: AddressSanitizer: x\n" + hostile)).isEmpty();
  }
}
