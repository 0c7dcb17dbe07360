package org.sitaf.core.harness.layout;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class CodeLineTest {
  @Test
  void commasInNestedBracketsTypeArgumentsAndLiteralsSeparateNothing() {
    CodeLine line =
        new CodeLine("call(Map<String, Double> map, f(a, b), \"x, (y\", '\"', a < b, {1, 2});");
    assertThat(line.last().orElseThrow().parts())
        .isEqualTo(
            List.of("Map<String, Double> map", "f(a, b)", "\"x, (y\"", "'\"'", "a < b", "{1, 2}"));
  }

  @Test
  void arrowsCloseNoTypeArguments() {
    CodeLine line = new CodeLine("list<A> x = make(() -> a->b(c, d), e);");
    assertThat(line.last().orElseThrow().parts()).isEqualTo(List.of("() -> a->b(c, d)", "e"));
    assertThat(line.left()).isEqualTo("list<A> x =");
    assertThat(line.right()).isEqualTo("make(() -> a->b(c, d), e);");
  }

  @Test
  void anEqualsSignInBracketsIsNoAssignment() {
    assertThat(new CodeLine("call(a = 1, \" = \");").isAssignment()).isFalse();
    assertThat(new CodeLine("if (a == b) {").isAssignment()).isFalse();
  }

  @Test
  void unclosedBracketsAreNoGroups() {
    CodeLine line = new CodeLine("void call(int a) {");
    assertThat(line.groups()).hasSize(1);
    assertThat(line.last().orElseThrow().parts()).isEqualTo(List.of("int a"));
  }

  @Test
  void aCommaAtTheEndOfATupleIsKept() {
    CodeLine line = new CodeLine("NAMES = (\"a\",)");
    assertThat(line.last().orElseThrow().parts()).isEqualTo(List.of("\"a\""));
    assertThat(line.last().orElseThrow().commaAtEnd()).isTrue();
  }

  @Test
  void escapedQuotesEndNoLiteral() {
    assertThat(new CodeLine("f(\"a\\\", b\", c)").last().orElseThrow().parts())
        .isEqualTo(List.of("\"a\\\", b\"", "c"));
  }
}
