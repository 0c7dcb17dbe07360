package org.sitaf.core.trajectory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FormulaParserTest {
  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '`',
      value = {
        "x < 1 ; x < 1",
        "always(x < 1) ; G(x < 1)",
        "always [0, 2.5] ( x < 1 ) ; G[0.0,2.5](x < 1)",
        "eventually[0,2](always(abs(x - goal) <= 0.02)) ; F[0.0,2.0](G(abs(x - goal) <= 0.02))",
        "once[1,2](historically(a)) ; O[1.0,2.0](H(a))",
        "a -> b -> c ; (a -> (b -> c))",
        "a || b && c -> d ; ((a | (b & c)) -> d)",
        "a && b || c && d ; ((a & b) | (c & d))",
        "!a && b ; (!a & b)",
        "!a == b ; !a == b",
        "!(a == b) ; !a == b",
        "!!a ; !!a",
        "a until b && c ; ((a U b) & c)",
        "a && b since[1,2] c ; (a & (b S[1.0,2.0] c))",
        "!a until !b ; (!a U !b)",
        "(a until b) until c ; ((a U b) U c)",
        "(a || b) until always(c) ; ((a | b) U G(c))",
        "(a + b) * 2.0 < c ; (a + b) * 2.0 < c",
        "(a ? b : c) < 3 && d ; ((a ? b : c) < 3 & d)",
        "(a && b ? c : d) ; (a && b ? c : d)",
        "xs.exists(x, x > 1 && y) || b ; (xs.exists(x, x > 1 && y) | b)",
        "always(name == ' until && ') ; G(name == ' until && ')",
        "step.until == 1.0 && once == 2.0 ; (step.until == 1.0 & once == 2.0)",
        "a == -b -> c ; (a == -b -> c)",
        "((a)) ; a",
      })
  void bindsOperatorsByPrecedence(String text, String structure) throws FormulaException {
    assertThat(structure(text)).isEqualTo(structure);
  }

  @Test
  void boundsAreConstantExpressions() throws FormulaException {
    ParsedFormula parsed =
        FormulaParser.parse("always[0.5, horizon](x)", t -> t.equals("horizon") ? 7 : 0.5);

    assertThat(parsed.intervals().get(0).interval()).isEqualTo(new Interval(0.5, 7));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '`',
      value = {
        "always x < 1 ; 1 ; 1 ; operand of always must be in parentheses",
        "always[0,2] x < 1 ; 1 ; 13 ; operand of always must be in parentheses",
        "always[2](x) ; 1 ; 7 ; must be [from, to]",
        "always[2, 1](x) ; 1 ; 7 ; ends before it begins",
        "always[-1, 1](x) ; 1 ; 7 ; 0 or more",
        "always[a, 1](x) ; 1 ; 8 ; constant number of seconds",
        "always[, 1](x) ; 1 ; 8 ; is missing",
        "always(x < 1 ; 1 ; 7 ; not closed",
        "a until b until c ; 1 ; 11 ; cannot be chained",
        "a && ; 1 ; 5 ; missing at the end",
        "&& a ; 1 ; 1 ; missing before '&'",
        "a && -> b ; 1 ; 6 ; missing before '-'",
        "until b ; 1 ; 1 ; missing before until",
        "always() ; 1 ; 8 ; missing before ')'",
        "a) ; 1 ; 2 ; unexpected ')'",
        "a ? b : c ; 1 ; 3 ; in parentheses",
        "always(x) < 1 ; 1 ; 11 ; unexpected '<'",
        "(always(x) ? a : b) ; 1 ; 2 ; cannot be part of",
        "abs(once(x)) < 1 ; 1 ; 5 ; cannot be part of",
        "allways(x < 1) ; 1 ; 1 ; unknown operator 'allways'; did you mean 'always'?",
        "a && eventualy[0, 2] (x) ; 1 ; 6 ; did you mean 'eventually'?",
      })
  void saysWhereAFormulaIsWrong(String text, int line, int column, String message) {
    FormulaException error =
        catchThrowableOfType(
            FormulaException.class, () -> FormulaParser.parse(text, Double::parseDouble));

    assertThat(error).as(text).isNotNull().hasMessageContaining(message);
    assertThat(error.line()).isEqualTo(line);
    assertThat(error.column()).as(error.getMessage()).isEqualTo(column);
  }

  @Test
  void positionsCountLines() {
    FormulaException error =
        catchThrowableOfType(
            FormulaException.class,
            () -> FormulaParser.parse("always(\n  x < 1\n  && )", Double::parseDouble));

    assertThat(error.line()).isEqualTo(3);
    assertThat(error.column()).isEqualTo(6);
  }

  @Test
  void boundsTheSizeOfFormulas() {
    for (String text :
        new String[] {
          "(".repeat(10_000),
          "!".repeat(10_000),
          "a -> ".repeat(3_000) + "a",
          "always(".repeat(101) + "a" + ")".repeat(101),
          "a && ".repeat(600) + "a",
          "x".repeat(20_001)
        }) {
      assertThat(
              catchThrowableOfType(
                  FormulaException.class, () -> FormulaParser.parse(text, Double::parseDouble)))
          .isNotNull();
    }
  }

  private static String structure(String text) throws FormulaException {
    ParsedFormula parsed = FormulaParser.parse(text, Double::parseDouble);
    return structure(parsed.formula(), parsed);
  }

  private static String structure(Formula formula, ParsedFormula parsed) {
    if (formula instanceof Formula.Atom atom) {
      return parsed.atoms().get(atom.index()).text();
    } else if (formula instanceof Formula.Not not) {
      return "!" + structure(not.operand(), parsed);
    } else if (formula instanceof Formula.And and) {
      return binary(and.left(), " & ", and.right(), parsed);
    } else if (formula instanceof Formula.Or or) {
      return binary(or.left(), " | ", or.right(), parsed);
    } else if (formula instanceof Formula.Implies implies) {
      return binary(implies.left(), " -> ", implies.right(), parsed);
    } else if (formula instanceof Formula.Until until) {
      return binary(until.left(), " U" + interval(until.interval()) + " ", until.right(), parsed);
    } else if (formula instanceof Formula.Since since) {
      return binary(since.left(), " S" + interval(since.interval()) + " ", since.right(), parsed);
    } else if (formula instanceof Formula.Window window) {
      String operator =
          switch (window.quantifier()) {
            case ALWAYS -> "G";
            case EVENTUALLY -> "F";
            case HISTORICALLY -> "H";
            case ONCE -> "O";
          };
      return operator
          + interval(window.interval())
          + "("
          + structure(window.operand(), parsed)
          + ")";
    }
    throw new AssertionError(formula);
  }

  private static String binary(Formula left, String operator, Formula right, ParsedFormula parsed) {
    return "(" + structure(left, parsed) + operator + structure(right, parsed) + ")";
  }

  private static String interval(Interval interval) {
    return interval.equals(Interval.UNBOUNDED)
        ? ""
        : "[" + interval.from() + "," + interval.to() + "]";
  }
}
