package org.sitaf.server.build.analysis;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.explain.Explanation.Boundary;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.explain.report.CauseText;
import org.sitaf.core.verdict.Verdict;

/** The causes of the failures of a build, in the REST interface and in the database. */
@Schema(name = "Explanation")
public record ExplanationView(
    List<CauseView> causes,
    @Schema(description = "number of executed cases beyond the suite") int executions,
    @Schema(description = "numbers of the failed cases without a cause") List<Integer> unexplained,
    @Schema(description = "the cases that were executed beyond the suite, at most 1,000")
        List<FurtherView> further,
    @Schema(description = "the inputs of the model, in its order") List<InputView> inputs) {
  /** Sentences for clients that escape them. */
  public static final CauseText SENTENCES =
      new CauseText(UnaryOperator.identity(), UnaryOperator.identity());

  /** A literal of an input. */
  @Schema(name = "NamedLiteral")
  public record LiteralView(String name, String literal) {}

  /** A cause. */
  @Schema(name = "Cause")
  public record CauseView(
      @Schema(
              description =
                  "the minimal values that fail with any other values; empty if every case fails,"
                      + " or the cause is a relation or a sequence")
          List<LiteralView> parameters,
      @Schema(description = "such as A == B; absent if there is none") @Nullable String relation,
      Verdict verdict,
      @Schema(description = "of the simplest case") String message,
      @Schema(description = "numbers of the failed cases that have this cause") List<Integer> cases,
      @Schema(description = "the simplest failing case, all inputs") List<LiteralView> simplest,
      @Schema(description = "where a numeric input begins to fail; absent if there is none")
          @Nullable BoundaryView boundary,
      @Schema(description = "number of executed cases beyond the suite for this cause")
          int executions,
      @Schema(description = "the shortest sequence of calls that fails; empty for single calls")
          List<String> steps,
      @Schema(description = "the cause in words, with the component as the subject")
          String sentence,
      @Schema(
              description =
                  "what the execution of the simplest case gave, for a bundle; empty if there is"
                      + " none")
          List<LiteralView> record) {
    /** The cause with its sentence. */
    public static CauseView of(Cause cause, Map<String, String> record) {
      Boundary boundary = cause.boundary();
      return new CauseView(
          literals(cause.parameters()),
          cause.relation(),
          cause.verdict(),
          cause.message(),
          cause.cases(),
          literals(cause.simplest()),
          boundary == null
              ? null
              : new BoundaryView(boundary.parameter(), boundary.passes(), boundary.fails()),
          cause.executions(),
          cause.steps(),
          SENTENCES.sentence(cause),
          literals(record));
    }

    /** The cause without its sentence. */
    public Cause toCause() {
      return new Cause(
          map(parameters),
          relation,
          verdict,
          message,
          cases,
          map(simplest),
          boundary == null
              ? null
              : new Boundary(boundary.parameter(), boundary.passes(), boundary.fails()),
          executions,
          steps);
    }

    /** The entries of its record by name. */
    public Map<String, String> records() {
      return map(record);
    }

    private static List<LiteralView> literals(Map<String, String> values) {
      return values.entrySet().stream()
          .map(v -> new LiteralView(v.getKey(), v.getValue()))
          .toList();
    }

    private static Map<String, String> map(List<LiteralView> values) {
      Map<String, String> map = new LinkedHashMap<>();
      values.forEach(v -> map.put(v.name(), v.literal()));
      return map;
    }
  }

  /** Two neighbouring values of an input. */
  @Schema(name = "FailureBoundary")
  public record BoundaryView(String parameter, String passes, String fails) {}

  /** A case beyond the suite. */
  @Schema(name = "FurtherCase")
  public record FurtherView(
      @Schema(description = "literals in the order of the inputs") List<String> values,
      boolean failed) {}

  /** An input of the model. */
  @Schema(name = "ExplainedInput")
  public record InputView(
      String name,
      boolean numeric,
      @Schema(description = "the literals of the suite, at most 100") List<String> values,
      @Schema(description = "those of values that the specification calls invalid")
          List<String> invalid) {}
}
