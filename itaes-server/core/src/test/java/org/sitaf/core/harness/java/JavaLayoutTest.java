package org.sitaf.core.harness.java;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class JavaLayoutTest {
  private static final String LONG = "argument".repeat(6);

  @Test
  void anAssignmentIsBrokenBeforeItsArguments() {
    String left = "    Answers<Double> " + "x".repeat(60) + " =";
    assertThat(JavaLayout.format(left + " testCase.answers(\"column\", Double.class, 0.0);\n"))
        .isEqualTo(left + "\n        testCase.answers(\"column\", Double.class, 0.0);\n");
  }

  @Test
  void argumentsThatFitOnNoLineGetOneEach() {
    assertThat(JavaLayout.format("    call(" + LONG + ", " + LONG + ", b);\n"))
        .isEqualTo("    call(\n        " + LONG + ",\n        " + LONG + ",\n        b);\n");
  }

  @Test
  void aThrowsClauseMovesToTheNextLineFirst() {
    String head = "  abstract double " + "c".repeat(50) + "(Component component, int a)";
    assertThat(JavaLayout.format(head + " throws Exception;\n"))
        .isEqualTo(head + "\n      throws Exception;\n");
  }

  @Test
  void aCommentOfOneParagraphIsOneLineIfItFits() {
    assertThat(JavaLayout.format("  /**\n   * Short.\n   */\n  int a;\n"))
        .isEqualTo("  /** Short. */\n  int a;\n");
  }

  @Test
  void paragraphsAreWrappedAndSeparatedAndTagsIndented() {
    String words = "word ".repeat(20).strip();
    assertThat(
            JavaLayout.format(
                "/**\n * First.\n *\n * <p>" + words + "\n * @param a " + words + "\n */\n"))
        .isEqualTo(
            """
            /**
             * First.
             *
             * <p>word word word word word word word word word word word word word word word word word word word
             * word
             *
             * @param a word word word word word word word word word word word word word word word word word
             *     word word word
             */
            """);
  }
}
