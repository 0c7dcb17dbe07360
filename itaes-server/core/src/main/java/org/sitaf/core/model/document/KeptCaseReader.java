package org.sitaf.core.model.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.diagnostic.NearestName;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.KeptCase;
import org.sitaf.core.model.Value;
import org.sitaf.schemas.CaseType;
import org.sitaf.schemas.StepType;

/** Reads the {@code case_list} of a model. */
final class KeptCaseReader {
  private final Problems problems;

  KeptCaseReader(Problems problems) {
    this.problems = problems;
  }

  List<KeptCase> read(List<CaseType> cases, List<InputElement> inputs) {
    List<KeptCase> kept = new ArrayList<>();
    for (CaseType testCase : cases) {
      int line = XmlDocuments.line(testCase);
      String where = where(testCase);
      if (!testCase.getSteps().isEmpty()) {
        problems.error(line, where, "has steps, but the model has no sequence_spec; remove them");
      }
      values(testCase.getValues(), inputs, line, where)
          .ifPresent(
              values ->
                  kept.add(
                      new KeptCase(testCase.getNo() == null ? 0 : testCase.getNo(), values, line)));
    }
    return kept;
  }

  /**
   * Reads the sequences to keep.
   *
   * @param inputs those that are set before the first step
   * @param calls the inputs of each call by its name, and none for each event
   */
  List<KeptCase> read(
      List<CaseType> cases, List<InputElement> inputs, Map<String, List<InputElement>> calls) {
    List<KeptCase> kept = new ArrayList<>();
    for (CaseType testCase : cases) {
      int line = XmlDocuments.line(testCase);
      String where = where(testCase);
      if (testCase.getSteps().isEmpty()) {
        problems.error(line, where, "has no step; add one");
      }
      List<KeptCase.Step> steps = new ArrayList<>();
      for (StepType step : testCase.getSteps()) {
        String name = Problems.text(step.getName());
        List<InputElement> parameters = calls.get(name);
        if (parameters == null) {
          problems.error(
              XmlDocuments.line(step),
              where + "/step " + name,
              "is neither a call nor an event" + NearestName.hint(name, calls.keySet()));
          continue;
        }
        values(step.getValues(), parameters, XmlDocuments.line(step), where + "/step " + name)
            .ifPresent(values -> steps.add(new KeptCase.Step(name, values)));
      }
      values(testCase.getValues(), inputs, line, where)
          .ifPresent(
              values ->
                  kept.add(
                      new KeptCase(
                          testCase.getNo() == null ? 0 : testCase.getNo(), values, steps, line)));
    }
    return kept;
  }

  private static String where(CaseType testCase) {
    return "case_list/case " + (testCase.getNo() == null ? "" : testCase.getNo());
  }

  private Optional<List<Value>> values(
      List<String> literals, List<InputElement> inputs, int line, String where) {
    if (literals.size() != inputs.size()) {
      problems.error(
          line,
          where,
          "has " + literals.size() + " values for " + inputs.size() + " input elements");
      return Optional.empty();
    }
    List<Value> values = new ArrayList<>();
    for (int i = 0; i < inputs.size(); i++) {
      InputElement element = inputs.get(i);
      String literal = literals.get(i);
      problems
          .attempt(line, where + "/" + element.name(), () -> element.value(literal))
          .ifPresent(values::add);
    }
    return Optional.of(values);
  }
}
