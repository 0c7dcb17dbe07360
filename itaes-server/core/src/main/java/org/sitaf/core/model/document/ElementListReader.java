package org.sitaf.core.model.document;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.OutputElement;
import org.sitaf.schemas.TestElementType;

/** Reads the test elements of one {@code input_spec_list} or {@code output_spec_list}. */
final class ElementListReader {
  private final Problems problems;

  ElementListReader(Problems problems) {
    this.problems = problems;
  }

  List<InputElement> inputs(List<TestElementType> elements) {
    List<InputElement> inputs = new ArrayList<>();
    InputReader reader = new InputReader(problems);
    elements.forEach(e -> reader.read(e).ifPresent(inputs::add));
    new RelationCheck(problems, inputs).verify();
    checkUniqueNames(
        inputs.stream().map(InputElement::name).toList(),
        inputs.stream().map(InputElement::line).toList());
    return inputs;
  }

  List<OutputElement> outputs(List<TestElementType> elements) {
    List<OutputElement> outputs = new ArrayList<>();
    OutputReader reader = new OutputReader(problems);
    elements.forEach(e -> reader.read(e).ifPresent(outputs::add));
    checkUniqueNames(
        outputs.stream().map(OutputElement::name).toList(),
        outputs.stream().map(OutputElement::line).toList());
    return outputs;
  }

  private void checkUniqueNames(List<String> names, List<Integer> lines) {
    Set<String> seen = new HashSet<>();
    for (int i = 0; i < names.size(); i++) {
      if (!seen.add(names.get(i))) {
        problems.error(
            lines.get(i), "test_element " + names.get(i), "another element has this name");
      }
    }
  }
}
