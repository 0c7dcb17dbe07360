package org.sitaf.server.preview;

import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.diagnostic.Severity;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.verdict.StateDiagram;
import org.sitaf.server.activity.StoredActivities;
import org.sitaf.server.computation.Computations;
import org.sitaf.server.error.ComputationTimeoutException;
import org.sitaf.server.preview.PreviewView.CallValues;
import org.sitaf.server.preview.PreviewView.CaseCounts;
import org.sitaf.server.preview.PreviewView.InputValues;
import org.sitaf.server.result.states.StateDiagramView;
import org.sitaf.server.web.DiagnosticView;
import org.springframework.stereotype.Service;

/** Previews of test models. */
@Service
class Previews {
  private final StoredActivities activities;
  private final Computations computations;

  Previews(StoredActivities activities, Computations computations) {
    this.activities = activities;
    this.computations = computations;
  }

  /**
   * Previews a draft; its errors are part of the result.
   *
   * @param cases whether to generate and count the cases, which may take long
   * @param heartbeat called while the preview is computed; an exception from it cancels the preview
   */
  PreviewView preview(
      String activityId, byte[] draft, boolean cases, long seed, Runnable heartbeat) {
    Activity activity = activities.activity(activityId);
    try {
      return computations.preview(
          "The preview", () -> preview(activity, draft, cases, seed), heartbeat);
    } catch (ComputationTimeoutException e) {
      return failed(e);
    }
  }

  /** A preview that was cancelled, with the reason. */
  static PreviewView failed(RuntimeException reason) {
    Diagnostic problem = Diagnostic.error("model", 0, "", String.valueOf(reason.getMessage()));
    return PreviewView.of(views(List.of(problem)));
  }

  private static PreviewView preview(Activity activity, byte[] draft, boolean cases, long seed) {
    TestModel model;
    try {
      model = activity.resolve(TestModelXml.read(new ByteArrayInputStream(draft), "model"));
    } catch (InvalidInputException e) {
      return PreviewView.of(views(e.diagnostics()));
    }
    List<Diagnostic> diagnostics = new ArrayList<>(activity.verify(model));
    CaseCounts counts = null;
    boolean hasErrors = diagnostics.stream().anyMatch(d -> d.severity() == Severity.ERROR);
    if (cases && !hasErrors) {
      counts = count(model, seed, diagnostics);
    }
    StateDiagramView states =
        hasErrors
            ? null
            : StateDiagram.planned(model, seed)
                .map(d -> StateDiagramView.of(d, model.target().settle()))
                .orElse(null);
    return new PreviewView(
        views(diagnostics), values(model, seed), calls(model, seed), states, counts);
  }

  private static List<InputValues> values(TestModel model, long seed) {
    return model.inputs().stream().map(input -> InputValues.of(input, seed)).toList();
  }

  private static List<CallValues> calls(TestModel model, long seed) {
    return model.sequence() == null
        ? List.of()
        : model.sequence().calls().stream()
            .map(call -> new CallValues(call.name(), values(call.model(), seed)))
            .toList();
  }

  private static @Nullable CaseCounts count(
      TestModel model, long seed, List<Diagnostic> diagnostics) {
    try {
      GeneratedSuite generated =
          TestCaseGenerator.generate(
              model, new GenerationOptions(null, null, seed, Effort.DEFAULT));
      diagnostics.addAll(generated.notes());
      return CaseCounts.of(generated.suite());
    } catch (InvalidInputException e) {
      diagnostics.addAll(e.diagnostics());
      return null;
    }
  }

  private static List<DiagnosticView> views(List<Diagnostic> diagnostics) {
    return diagnostics.stream().map(DiagnosticView::of).toList();
  }
}
