package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.server.web.DiagnosticView;

/** A suite in the REST interface. */
@Schema(name = "Suite")
record SuiteView(
    String id,
    String activityId,
    String model,
    String name,
    long seed,
    @Schema(description = "number of cases") int total,
    @Schema(description = "cases without invalid values") int valid,
    @Schema(description = "cases with an invalid value") int invalid,
    Instant created,
    @Schema(description = "increases with each change; for If-Match") long version,
    @Schema(description = "number of changes that can be undone") int undoable,
    List<ParameterView> parameters,
    @Schema(description = "notes of the generator, such as omitted values")
        List<DiagnosticView> notes) {

  @Schema(name = "Parameter")
  record ParameterView(
      String name,
      @Schema(description = "direct input, simulation or test stub") InputKind type,
      String realType) {
    static ParameterView of(CaseParameter parameter) {
      return new ParameterView(parameter.name(), parameter.kind(), parameter.realType());
    }
  }

  @Schema(name = "SuiteCase")
  record CaseView(
      @Schema(description = "from 1") int no,
      boolean valid,
      @Schema(description = "in the order of the suite's parameters") List<String> values,
      @Schema(description = "by name of the output") Map<String, String> expected,
      @Schema(description = "the steps of a sequence; empty if the case is a single call")
          List<StepView> steps) {
    static CaseView of(TestCase testCase, TestSuite suite) {
      return new CaseView(
          testCase.no(),
          testCase.valid(),
          testCase.values(),
          byOutput(testCase.expected()),
          testCase.steps().stream()
              .map(step -> StepView.of(step, suite.stepParameters(step.name())))
              .toList());
    }
  }

  @Schema(name = "SuiteStep")
  record StepView(
      @Schema(description = "the call or event of the test model") String name,
      @Schema(description = "false if the call is forbidden here or has an invalid value")
          boolean valid,
      @Schema(description = "by name of the input; empty for an event") Map<String, String> inputs,
      @Schema(description = "by name of the output") Map<String, String> expected) {
    static StepView of(TestStep step, List<CaseParameter> parameters) {
      Map<String, String> inputs = new LinkedHashMap<>();
      for (int i = 0; i < Math.min(parameters.size(), step.values().size()); i++) {
        inputs.put(parameters.get(i).name(), step.values().get(i));
      }
      return new StepView(step.name(), step.valid(), inputs, byOutput(step.expected()));
    }
  }

  private static Map<String, String> byOutput(List<ExpectedValue> values) {
    Map<String, String> expected = new LinkedHashMap<>();
    values.forEach(
        e ->
            expected.put(
                e.output().isEmpty() ? OutputElement.RETURN_NAME : e.output(), e.literal()));
    return expected;
  }

  static SuiteView of(StoredSuite stored, int undoable) {
    return new SuiteView(
        stored.id(),
        stored.activityId(),
        stored.model(),
        stored.name(),
        stored.seed(),
        stored.total(),
        stored.valid(),
        stored.total() - stored.valid(),
        stored.created(),
        stored.version(),
        undoable,
        stored.parameters().stream().map(ParameterView::of).toList(),
        stored.notes().stream().map(DiagnosticView::of).toList());
  }
}
