package org.sitaf.core.harness.cpp;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CppLayoutTest {
  @Test
  void argumentsArePackedAfterTheBracket() {
    String part = "p".repeat(30);
    assertThat(CppLayout.format("  call(" + part + ", " + part + ", " + part + ", b);\n"))
        .isEqualTo("  call(" + part + ", " + part + ",\n       " + part + ", b);\n");
  }

  @Test
  void initialisersOfAConstructorMoveToTheNextLine() {
    String head = "Driver::Driver(runtime::TestRun& run)";
    String initialisers =
        "SuiteDriver(run, runtime::LifeCycle::perCase), control_(run), stub_(run)";
    assertThat(CppLayout.format(head + " : " + initialisers + " {}\n"))
        .isEqualTo(head + "\n    : " + initialisers + " {}\n");
  }

  @Test
  void aBodyThatDoesNotFitGetsLinesOfItsOwn() {
    String head = "void Control::set(const std::string& parameter, double value)";
    String body = "simulation_.setTheParameterOfTheWorld(parameter, value);";
    assertThat(CppLayout.format(head + " { " + body + " }\n"))
        .isEqualTo(head + " {\n  " + body + "\n}\n");
  }

  @Test
  void commentsAreWrappedAndIncludesAreNot() {
    String words = "word ".repeat(24).strip();
    assertThat(CppLayout.format("  /// " + words + "\n#include \"" + words + "\"\n"))
        .isEqualTo(
            "  /// "
                + "word ".repeat(19).strip()
                + "\n  /// "
                + "word ".repeat(5).strip()
                + "\n#include \""
                + words
                + "\"\n");
  }
}
