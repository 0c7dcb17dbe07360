package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestCase;
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
      @Schema(description = "by name of the output") Map<String, String> expected) {
    static CaseView of(TestCase testCase) {
      Map<String, String> expected = new LinkedHashMap<>();
      testCase
          .expected()
          .forEach(
              e ->
                  expected.put(
                      e.output().isEmpty() ? OutputElement.RETURN_NAME : e.output(), e.literal()));
      return new CaseView(testCase.no(), testCase.valid(), testCase.values(), expected);
    }
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
