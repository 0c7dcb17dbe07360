package org.sitaf.core.harness.python;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PythonLayoutTest {
  private static final String LONG = "argument".repeat(5);

  @Test
  void argumentsThatFitTogetherStayOnOneLine() {
    assertThat(
            PythonLayout.format(
                "        result = self.call(" + LONG + ", a, b, c, d, e, f, g, h, i)\n"))
        .isEqualTo(
            "        result = self.call(\n            "
                + LONG
                + ", a, b, c, d, e, f, g, h, i\n        )\n");
  }

  @Test
  void otherwiseEachGetsALineWithAComma() {
    assertThat(PythonLayout.format("call(" + LONG + ", " + LONG + ", " + LONG + ")\n"))
        .isEqualTo("call(\n    " + LONG + ",\n    " + LONG + ",\n    " + LONG + ",\n)\n");
  }

  @Test
  void parametersOfAFunctionAreBrokenAndNotItsResult() {
    assertThat(
            PythonLayout.format(
                "def f(self, " + LONG + ": int, b: int) -> tuple[int, float, float]:\n"))
        .isEqualTo("def f(\n    self, " + LONG + ": int, b: int\n) -> tuple[int, float, float]:\n");
  }

  @Test
  void aTupleOfOneStaysATuple() {
    assertThat(PythonLayout.format("NAMES = (\"" + "n".repeat(90) + "\",)\n"))
        .isEqualTo("NAMES = (\n    \"" + "n".repeat(90) + "\",\n)\n");
  }

  @Test
  void importsThatDoNotFitGetALineEach() {
    assertThat(PythonLayout.format("from a.b import " + LONG + ", " + LONG + "2\n"))
        .isEqualTo("from a.b import (\n    " + LONG + ",\n    " + LONG + "2,\n)\n");
  }

  @Test
  void aDocstringOfOneParagraphIsOneLineIfItFits() {
    assertThat(PythonLayout.format("    \"\"\"\n    Short.\n    \"\"\"\n"))
        .isEqualTo("    \"\"\"Short.\"\"\"\n");
    assertThat(PythonLayout.format("\"\"\"First.\n\nSecond.\n\"\"\"\n"))
        .isEqualTo("\"\"\"First.\n\nSecond.\n\"\"\"\n");
  }
}
