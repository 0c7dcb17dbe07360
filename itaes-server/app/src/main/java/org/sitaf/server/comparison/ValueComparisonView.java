package org.sitaf.server.comparison;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceClass;
import org.sitaf.core.compare.DifferenceGroup;
import org.sitaf.core.compare.NotComparable;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.server.result.ResultView.ProvenanceView;

/** The comparison of the values of two results in the REST interface. */
@Schema(
    name = "ValueComparison",
    description =
        "what two results do differently, without expected values; differences are not confirmed by"
            + " further runs")
record ValueComparisonView(
    ProvenanceView base,
    ProvenanceView now,
    @Schema(description = "packages and tools that the builds do not share, such as numpy 1 -> 2")
        List<String> otherTools,
    @Schema(description = "the inputs, in the order of the model") List<String> parameters,
    @Schema(description = "number of cases that both builds executed") int cases,
    @Schema(description = "number of cases with differences") int differingCases,
    @Schema(description = "number of differences") int differences,
    @Schema(description = "number of groups of differences") int groupCount,
    @Schema(description = "the largest last; at most the 300 largest") List<GroupView> groups,
    @Schema(description = "number of outputs that differ in the last bits only") int lastBits,
    @Schema(description = "number of cases that are slower by statistics") int slower,
    @Schema(description = "number of entries") int notComparable) {
  private static final int MAX_GROUPS = 300;
  private static final int MAX_INPUT = 200;

  /** What differs. */
  enum Kind {
    value,
    error,
    calls,
    commands,
    observed,
    trajectory,
    verdict,
    coverage_lost,
    slower;

    static Kind of(DifferenceClass kind) {
      return valueOf(kind.id());
    }
  }

  @Schema(name = "DifferenceGroup")
  record GroupView(
      @Schema(description = "from 0, for the list of its differences") int index,
      @Schema(description = "what changed, and for which values of the inputs") String text,
      Kind kind,
      @Schema(description = "output, signal or called method; empty for the whole case")
          String output,
      @Schema(description = "number of differences") int size,
      @Schema(description = "number of those in valid cases") int valid,
      DifferenceView first) {
    static GroupView of(int index, ComparedBuilds compared) {
      DifferenceGroup group = compared.groups().get(index);
      return new GroupView(
          index,
          group.text(),
          Kind.of(group.kind()),
          group.output(),
          group.differences().size(),
          (int) group.differences().stream().filter(Difference::valid).count(),
          DifferenceView.of(group.differences().get(0), compared));
    }
  }

  @Schema(name = "Difference")
  record DifferenceView(
      @Schema(description = "number of the case in this result; 0 for all cases") int no,
      @Schema(description = "number of the case in the other result; 0 for all cases") int baseNo,
      @Schema(description = "whether all inputs of the case are valid") boolean valid,
      Kind kind,
      @Schema(description = "output, signal or called method; empty for the whole case")
          String output,
      @Schema(description = "literals by name, shortened to 200 characters")
          Map<String, String> inputs,
      @Schema(description = "what the other result has, at most 10,000 characters") String base,
      @Schema(description = "what this result has, at most 10,000 characters") String now,
      @Schema(description = "seconds after the call of the first divergent step")
          @Nullable Double at,
      @Schema(description = "sequences: number of the first step that differs, from 1")
          @Nullable Integer step,
      @Schema(description = "sequences: that step, such as Read(1, 7)") @Nullable String call) {
    static DifferenceView of(Difference found, ComparedBuilds compared) {
      Map<String, String> inputs = new LinkedHashMap<>();
      found.inputs().forEach((name, literal) -> inputs.put(name, shortened(literal)));
      Difference.Step step = found.step();
      return new DifferenceView(
          found.no(),
          compared.numberInBase(found.no()),
          found.valid(),
          Kind.of(found.kind()),
          found.output(),
          inputs,
          found.base(),
          found.now(),
          found.at(),
          step == null ? null : step.number(),
          step == null ? null : step.call());
    }

    private static String shortened(String literal) {
      return literal.length() <= MAX_INPUT ? literal : literal.substring(0, MAX_INPUT) + "…";
    }
  }

  @Schema(name = "NotComparable")
  record NotComparableView(
      @Schema(description = "number of the case in this result; 0 for all cases") int no,
      @Schema(description = "empty for the whole case") String output,
      String reason) {
    static NotComparableView of(NotComparable found) {
      return new NotComparableView(found.no(), found.output(), found.reason());
    }
  }

  static ValueComparisonView of(ComparedBuilds compared) {
    List<DifferenceGroup> groups = compared.groups();
    List<GroupView> shown = new ArrayList<>();
    for (int i = Math.max(0, groups.size() - MAX_GROUPS); i < groups.size(); i++) {
      shown.add(GroupView.of(i, compared));
    }
    return new ValueComparisonView(
        ProvenanceView.of(compared.base()),
        ProvenanceView.of(compared.now()),
        compared.otherTools(),
        compared.parameters().stream().map(CaseParameter::name).toList(),
        compared.cases(),
        compared.differingCases(),
        compared.differences().size(),
        groups.size(),
        shown,
        compared.lastBits().size(),
        compared.slower().size(),
        compared.notComparable().size());
  }
}
