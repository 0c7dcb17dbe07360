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
import org.sitaf.core.model.TestModelXml;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.server.activity.Workspaces;
import org.sitaf.server.computation.Computations;
import org.sitaf.server.preview.PreviewView.CaseCounts;
import org.sitaf.server.preview.PreviewView.InputValues;
import org.sitaf.server.refusal.OvertimeException;
import org.sitaf.server.web.DiagnosticView;
import org.springframework.stereotype.Service;

/** Previews of test models. */
@Service
class Previews {
  private final Workspaces workspaces;
  private final Computations computations;

  Previews(Workspaces workspaces, Computations computations) {
    this.workspaces = workspaces;
    this.computations = computations;
  }

  /**
   * What a draft gives; what is wrong with it is part of the answer.
   *
   * @param cases whether its cases are counted, which may take as long as generating them
   */
  PreviewView preview(String activityId, byte[] draft, boolean cases, long seed) {
    Activity activity = workspaces.activity(activityId);
    try {
      return computations.preview("The preview", () -> preview(activity, draft, cases, seed));
    } catch (OvertimeException e) {
      Diagnostic overtime = Diagnostic.error("model", 0, "", String.valueOf(e.getMessage()));
      return new PreviewView(views(List.of(overtime)), List.of(), null);
    }
  }

  private static PreviewView preview(Activity activity, byte[] draft, boolean cases, long seed) {
    TestModel model;
    try {
      model = activity.resolve(TestModelXml.read(new ByteArrayInputStream(draft), "model"));
    } catch (InvalidInputException e) {
      return new PreviewView(views(e.diagnostics()), List.of(), null);
    }
    List<Diagnostic> found = new ArrayList<>(activity.verify(model));
    List<InputValues> inputs =
        model.inputs().stream().map(input -> InputValues.of(input, seed)).toList();
    CaseCounts counts = null;
    boolean wrong = found.stream().anyMatch(d -> d.severity() == Severity.ERROR);
    if (cases && !wrong) {
      counts = count(model, seed, found);
    }
    return new PreviewView(views(found), inputs, counts);
  }

  private static @Nullable CaseCounts count(TestModel model, long seed, List<Diagnostic> found) {
    try {
      GeneratedSuite generated =
          TestCaseGenerator.generate(
              model, new GenerationOptions(null, null, seed, Effort.DEFAULT));
      found.addAll(generated.notes());
      return CaseCounts.of(generated.suite());
    } catch (InvalidInputException e) {
      found.addAll(e.diagnostics());
      return null;
    }
  }

  private static List<DiagnosticView> views(List<Diagnostic> diagnostics) {
    return diagnostics.stream().map(DiagnosticView::of).toList();
  }
}
