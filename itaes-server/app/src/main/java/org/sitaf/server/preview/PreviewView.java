package org.sitaf.server.preview;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.value.TestData;
import org.sitaf.core.value.TestDataGenerator;
import org.sitaf.server.result.states.StateDiagramView;
import org.sitaf.server.web.DiagnosticView;

/** The preview of a draft of a test model. */
@Schema(name = "ModelPreview")
record PreviewView(
    @Schema(description = "problems of the draft, and notes") List<DiagnosticView> diagnostics,
    @Schema(description = "in the order of the draft; empty if the draft cannot be read")
        List<InputValues> inputs,
    @Schema(description = "the calls of a sequence in the order of the draft")
        List<CallValues> calls,
    @Schema(
            description =
                "what the sequences may do; absent if the draft has errors or no sequence")
        @Nullable StateDiagramView states,
    @Schema(description = "absent if the draft has errors, or if cases were not requested")
        @Nullable CaseCounts counts) {
  /** A preview without values. */
  static PreviewView of(List<DiagnosticView> diagnostics) {
    return new PreviewView(diagnostics, List.of(), List.of(), null, null);
  }

  @Schema(name = "CallValues", description = "the values of a call's inputs")
  record CallValues(String name, List<InputValues> inputs) {}

  @Schema(name = "InputValues")
  record InputValues(
      String name,
      InputKind type,
      @Schema(description = "numbers in ascending order") List<PreviewValue> values,
      @Schema(description = "generated values that the type cannot represent")
          List<String> leftOut) {
    static InputValues of(InputElement element, long seed) {
      TestData data;
      try {
        data = TestDataGenerator.generate(element, seed);
      } catch (IllegalArgumentException e) {
        // The diagnostics of the model say that the type cannot hold the values.
        data = new TestData(List.of(), List.of());
      }
      return new InputValues(
          element.name(),
          element.kind(),
          data.values().stream()
              .map(v -> new PreviewValue(v.value().literal(), v.valid()))
              .toList(),
          data.unrepresentable());
    }
  }

  @Schema(name = "PreviewValue")
  record PreviewValue(String literal, boolean valid) {}

  @Schema(name = "CaseCounts", description = "numbers of generated cases")
  record CaseCounts(int total, int valid, int invalid) {
    static CaseCounts of(TestSuite suite) {
      int valid = Math.toIntExact(suite.validCount());
      return new CaseCounts(suite.cases().size(), valid, suite.cases().size() - valid);
    }
  }
}
