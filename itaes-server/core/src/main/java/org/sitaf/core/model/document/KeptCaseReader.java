package org.sitaf.core.model.document;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.KeptCase;
import org.sitaf.core.model.Value;
import org.sitaf.schemas.CaseType;

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
      String where = "case_list/case " + (testCase.getNo() == null ? "" : testCase.getNo());
      if (testCase.getValues().size() != inputs.size()) {
        problems.error(
            line,
            where,
            "has "
                + testCase.getValues().size()
                + " values for "
                + inputs.size()
                + " input elements");
        continue;
      }
      List<Value> values = new ArrayList<>();
      for (int i = 0; i < inputs.size(); i++) {
        InputElement element = inputs.get(i);
        String literal = testCase.getValues().get(i);
        problems
            .attempt(
                line,
                where + "/" + element.name(),
                () ->
                    element.kind() == InputKind.TDTS
                        ? Value.parseAnswer(literal, element.type())
                        : Value.parse(literal, element.type()))
            .ifPresent(values::add);
      }
      kept.add(new KeptCase(testCase.getNo() == null ? 0 : testCase.getNo(), values, line));
    }
    return kept;
  }
}
