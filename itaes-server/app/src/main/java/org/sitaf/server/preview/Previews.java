package org.sitaf.server.preview;

import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Semaphore;
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
import org.sitaf.server.preview.PreviewView.CaseCounts;
import org.sitaf.server.preview.PreviewView.InputValues;
import org.sitaf.server.web.DiagnosticView;
import org.springframework.stereotype.Service;

/** Previews of test models. */
@Service
class Previews {
  /** Combining is all computation: more at once than this only slows each other down. */
  private final Semaphore combining = new Semaphore(2);

  private final Workspaces workspaces;

  Previews(Workspaces workspaces) {
    this.workspaces = workspaces;
  }

  /**
   * What a draft gives; what is wrong with it is part of the answer.
   *
   * @param cases whether its cases are counted, which may take as long as generating them
   */
  PreviewView preview(String activityId, byte[] draft, boolean cases, long seed) {
    Activity activity = workspaces.activity(activityId);
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

  private @Nullable CaseCounts count(TestModel model, long seed, List<Diagnostic> found) {
    combining.acquireUninterruptibly();
    try {
      GeneratedSuite generated =
          TestCaseGenerator.generate(
              model, new GenerationOptions(null, null, seed, Effort.DEFAULT));
      found.addAll(generated.notes());
      return CaseCounts.of(generated.suite());
    } catch (InvalidInputException e) {
      found.addAll(e.diagnostics());
      return null;
    } finally {
      combining.release();
    }
  }

  private static List<DiagnosticView> views(List<Diagnostic> diagnostics) {
    return diagnostics.stream().map(DiagnosticView::of).toList();
  }
}
