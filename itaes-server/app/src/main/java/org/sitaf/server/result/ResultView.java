package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.Verdict;

/** A result, without its cases, as people and programs see it. */
@Schema(name = "Result")
record ResultView(
    String name, SummaryView summary, List<ParameterView> parameters, ProvenanceView provenance) {

  @Schema(name = "ResultParameter")
  record ParameterView(String name, InputKind type, String realType) {
    static ParameterView of(CaseParameter parameter) {
      return new ParameterView(parameter.name(), parameter.kind(), parameter.realType());
    }
  }

  @Schema(name = "ResultSummary", description = "total = pass + fail + error + dont")
  record SummaryView(
      int total,
      int pass,
      int fail,
      int error,
      @Schema(description = "not executed") int dont,
      @Schema(description = "passed without an expected value or post-condition") int unjudged,
      @Nullable TimesView processingTime) {
    static SummaryView of(Summary summary) {
      return new SummaryView(
          summary.total(),
          summary.pass(),
          summary.fail(),
          summary.error(),
          summary.dont(),
          summary.unjudged(),
          summary.times() == null ? null : TimesView.of(summary.times()));
    }
  }

  @Schema(
      name = "ProcessingTime",
      description = "of PASS and FAIL cases; absent where there is none")
  record TimesView(
      @Schema(description = "always us, microseconds") String unit,
      double min,
      double max,
      double average,
      @Schema(description = "of the sample") double standardDeviation) {
    static TimesView of(Summary.Times times) {
      return new TimesView(
          "us", times.min(), times.max(), times.average(), times.standardDeviation());
    }
  }

  @Schema(name = "Provenance", description = "what ran, by SHA-256, where and when")
  record ProvenanceView(
      String suite,
      long seed,
      String harness,
      String component,
      String agent,
      String bridge,
      @Schema(description = "ISO 8601, UTC") String started,
      @Schema(description = "ISO 8601, UTC") String finished) {
    static ProvenanceView of(Provenance provenance) {
      return new ProvenanceView(
          provenance.suite(),
          provenance.seed(),
          provenance.harness(),
          provenance.component(),
          provenance.agent(),
          provenance.bridge(),
          provenance.started(),
          provenance.finished());
    }
  }

  @Schema(name = "ResultCase")
  record CaseView(
      @Schema(description = "from 1") int no,
      @Schema(description = "in the order of the result's parameters") List<String> values,
      @Schema(description = "by name of the output") Map<String, String> expected,
      @Schema(description = "by name of the output") Map<String, String> actual,
      Verdict verdict,
      @Schema(description = "the component's own, in microseconds")
          @Nullable Double processingTimeUs,
      @Schema(description = "of it, spent in virtual hardware") @Nullable Double hardwareUs,
      @Schema(description = "of it, spent in stubs") @Nullable Double stubUs,
      @Schema(description = "why the verdict is not PASS") @Nullable String message) {
    static CaseView of(CaseResult result) {
      CaseResult.ProcessingTime time = result.time();
      return new CaseView(
          result.no(),
          result.values(),
          byOutput(result.expected()),
          byOutput(result.actual()),
          result.verdict(),
          time == null ? null : time.total(),
          time == null ? null : time.hardware(),
          time == null ? null : time.stub(),
          result.message().isEmpty() ? null : result.message());
    }
  }

  static ResultView of(Overview overview) {
    return new ResultView(
        overview.name(),
        SummaryView.of(overview.summary()),
        overview.parameters().stream().map(ParameterView::of).toList(),
        ProvenanceView.of(overview.provenance()));
  }

  private static Map<String, String> byOutput(List<NamedValue> values) {
    Map<String, String> byName = new LinkedHashMap<>();
    values.forEach(
        v ->
            byName.put(v.output().isEmpty() ? OutputElement.RETURN_NAME : v.output(), v.literal()));
    return byName;
  }
}
