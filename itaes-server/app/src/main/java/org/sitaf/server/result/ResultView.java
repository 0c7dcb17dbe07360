package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.RelationCount;
import org.sitaf.core.verdict.Summary;

/** A result in the REST interface, without its cases. */
@Schema(name = "Result")
public record ResultView(
    String name,
    SummaryView summary,
    List<ParameterView> parameters,
    ProvenanceView provenance,
    @Schema(description = "why the verdicts cannot be trusted; empty if they can")
        List<String> suspicions,
    @Schema(description = "the relations between two runs, in the order of the model")
        List<RelationView> relations) {

  @Schema(name = "RelationCount", description = "in how many cases a relation was checked")
  public record RelationView(
      String name,
      @Schema(description = "in which it holds or is broken") int checked,
      int broken,
      @Schema(description = "to which it does not apply") int skipped,
      @Schema(description = "in which it could not be checked") int errors) {
    static RelationView of(RelationCount count) {
      return new RelationView(
          count.name(), count.checked(), count.broken(), count.skipped(), count.errors());
    }
  }

  @Schema(name = "ResultParameter")
  public record ParameterView(String name, InputKind type, String realType) {
    static ParameterView of(CaseParameter parameter) {
      return new ParameterView(parameter.name(), parameter.kind(), parameter.realType());
    }
  }

  @Schema(name = "ResultSummary", description = "total = pass + fail + error + dont")
  public record SummaryView(
      int total,
      int pass,
      int fail,
      int error,
      @Schema(description = "not executed") int dont,
      @Schema(description = "passed without an expected value or post-condition") int unjudged,
      @Schema(description = "passed by an exception, which says nothing about values") int byError,
      @Nullable TimesView processingTime) {
    static SummaryView of(Summary summary) {
      return new SummaryView(
          summary.total(),
          summary.pass(),
          summary.fail(),
          summary.error(),
          summary.dont(),
          summary.unjudged(),
          summary.byError(),
          summary.times() == null ? null : TimesView.of(summary.times()));
    }
  }

  @Schema(
      name = "ProcessingTime",
      description =
          "of the cases with verdict PASS or FAIL, absent if there are none: the median of a case"
              + " with repeated calls, else the time of its call")
  public record TimesView(
      @Schema(description = "always us (microseconds)") String unit,
      double min,
      double max,
      double average,
      @Schema(description = "sample standard deviation") double standardDeviation,
      @Schema(
              description =
                  "time of the first call of a process, which also loads and compiles code and is"
                      + " left out of the other numbers; absent if nothing is left out")
          @Nullable Double first) {
    static TimesView of(Summary.Times times) {
      return new TimesView(
          "us",
          times.min(),
          times.max(),
          times.average(),
          times.standardDeviation(),
          times.first());
    }
  }

  @Schema(name = "Provenance", description = "SHA-256 of what was executed, where and when")
  public record ProvenanceView(
      String suite,
      long seed,
      String harness,
      String component,
      String agent,
      String bridge,
      @Schema(
              description =
                  "compiler or interpreter with its version and options; empty in results of"
                      + " earlier releases")
          String compiler,
      @Schema(
              description =
                  "the packages that the component uses, with those that they need, by name")
          List<PackageView> packages,
      @Schema(description = "ISO 8601, UTC") String started,
      @Schema(description = "ISO 8601, UTC") String finished) {
    public static ProvenanceView of(Provenance provenance) {
      return new ProvenanceView(
          provenance.suite(),
          provenance.seed(),
          provenance.harness(),
          provenance.component(),
          provenance.agent(),
          provenance.bridge(),
          provenance.compiler(),
          provenance.packages().stream().map(PackageView::of).toList(),
          provenance.started(),
          provenance.finished());
    }
  }

  @Schema(name = "ResolvedPackage")
  public record PackageView(
      @Schema(description = "GROUP:ARTIFACT for a Maven package") String name,
      String version,
      @Schema(description = "of the downloaded file") String sha256) {
    static PackageView of(ResolvedPackage resolved) {
      return new PackageView(resolved.name(), resolved.version(), resolved.sha256());
    }
  }

  static ResultView of(Overview overview) {
    return new ResultView(
        overview.name(),
        SummaryView.of(overview.summary()),
        overview.parameters().stream().map(ParameterView::of).toList(),
        ProvenanceView.of(overview.provenance()),
        overview.suspicions() == null ? List.of() : overview.suspicions(),
        overview.relations() == null
            ? List.of()
            : overview.relations().stream().map(RelationView::of).toList());
  }
}
