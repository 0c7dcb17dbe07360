package org.sitaf.core.score.mutation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class MutationsTest {
  private static List<String> changes(String source, boolean python) {
    return Mutations.of("a", source, python).stream()
        .map(m -> m.line() + " " + m.change())
        .toList();
  }

  private static List<String> sources(String source, boolean python) {
    return Mutations.of("a", source, python).stream().map(m -> m.applied(source)).toList();
  }

  @Test
  void comparisonsAndArithmeticAreChanged() {
    String source = "if (a < b && c == -d) {\n  e = f + 1;\n}";
    assertThat(changes(source, false))
        .containsExactly(
            "1 < replaced by <=",
            "1 < replaced by >=",
            "1 && replaced by ||",
            "1 == replaced by !=",
            "1 sign - left out",
            "2 + replaced by -");
    assertThat(sources(source, false)).contains("if (a < b && c == d) {\n  e = f + 1;\n}");
  }

  @Test
  void returnedValuesAreReplaced() {
    assertThat(sources("return a;", false)).containsExactly("return 0;");
    assertThat(sources("return 0.0;", false)).containsExactly("return 1;");
    assertThat(sources("return true;", false)).containsExactly("return false;");
    assertThat(sources("return a == b;", false)).contains("return !(a == b);");
    assertThat(sources("return f(a,\n  b);", false)).containsExactly("return 0;");
    assertThat(sources("return;", false)).isEmpty();
    assertThat(sources("def f():\n    return f(a,\n      b)\n    x = 1\n", true))
        .containsExactly("def f():\n    return None\n    x = 1\n");
    assertThat(sources("return not a", true)).containsExactly("return not (not a)", "return  a");
  }

  @Test
  void callsWhoseResultIsNotUsedAreLeftOut() {
    assertThat(sources("{ base.drive(x(1), 0); y = z(2); }", false))
        .containsExactly("{ ; y = z(2); }");
    assertThat(sources("{ super(a); if (b) { c(); } }", false))
        .containsExactly("{ super(a); if (b) { ; } }");
    assertThat(sources("if b:\n    self.base.drive(\n        1,\n    )\nx = y(2)\n", true))
        .containsExactly("if b:\n    pass\nx = y(2)\n");
    assertThat(changes("{ std::sort(a); }", false)).containsExactly("1 call of std::sort left out");
  }

  @Test
  void commentsTextsAndTemplatesAreLeftAlone() {
    String java =
        "// a < b\n/* c * d\n - e */ @Get(x)\nString s = \"f < g\\\" + h\";\nList<String> l;\nchar c = '<';";
    assertThat(changes(java, false)).isEmpty();
    assertThat(changes("#include <a>\n#define B(x) \\\n  x < 1\nstd::vector<int> v;", false))
        .isEmpty();
    assertThat(changes("# a < b\ns = '''c < d\n e'''\nt = f\"{g}\" 'h < i'\n@j < k\n", true))
        .isEmpty();
  }

  @Test
  void wordsOfPythonAreOperators() {
    assertThat(sources("x = a and b", true)).containsExactly("x = a or b");
    assertThat(sources("x = a not in b", true)).containsExactly("x = a  in b");
    assertThat(sources("x = a is not b", true)).isEmpty();
    assertThat(sources("x = a // b ** c", true))
        .containsExactly("x = a * b ** c", "x = a // b * c");
    assertThat(sources("x = true and false", false)).contains("x = false and false");
  }

  @Test
  void longTextsAreReadWithoutDeepRecursion() {
    String comment = "/*" + "* ".repeat(200_000) + "*/";
    String text = "\"" + "\\\\ab".repeat(200_000) + "\"";
    assertThat(changes(comment + "\nx = " + text + " < 3;", false)).hasSize(2);
    assertThat(changes("'" + "a".repeat(100_000), true)).isEmpty();
    assertThat(changes("(".repeat(20_000) + "return a" + ")".repeat(20_000), false)).isEmpty();
  }
}
