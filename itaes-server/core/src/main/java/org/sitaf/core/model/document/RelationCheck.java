package org.sitaf.core.model.document;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.diagnostic.NearestName;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.RelatedOffset;
import org.sitaf.core.model.TestSpec;

/** Verifies that inputs follow existing inputs of the same type, without cycles. */
final class RelationCheck {
  private final Problems problems;
  private final Map<String, InputElement> inputs = new LinkedHashMap<>();

  RelationCheck(Problems problems, List<InputElement> inputs) {
    this.problems = problems;
    inputs.forEach(input -> this.inputs.putIfAbsent(input.name(), input));
  }

  void verify() {
    inputs.values().forEach(input -> related(input).forEach(spec -> verify(input, spec)));
    Set<String> finished = new HashSet<>();
    inputs.values().forEach(input -> findCycle(input, new ArrayList<>(), finished));
  }

  private void verify(InputElement input, TestSpec.Related spec) {
    InputElement to = inputs.get(spec.to());
    if (to == null) {
      error(
          input,
          "to names '"
              + spec.to()
              + "', which is not an element of input_spec_list"
              + NearestName.hint(spec.to(), inputs.keySet()));
    } else if (!to.type().typeName().equals(input.type().typeName())) {
      error(
          input,
          "to needs an input of the same type, but "
              + to.name()
              + " is "
              + to.realType()
              + " and "
              + input.name()
              + " is "
              + input.realType());
    } else if (input.type() instanceof DataType.Scalar scalar
        && !scalar.type().isNumeric()
        && scalar.type() != ScalarType.VOID) {
      error(
          input,
          "RELATED needs numbers, rotations, directions or poses, but the real_type is "
              + input.realType());
    } else if (!(input.type() instanceof DataType.Scalar)) {
      for (RelatedOffset offset : spec.offsets()) {
        if (offset.unit() != RelatedOffset.Unit.NUMBER) {
          error(
              input,
              "the offset "
                  + offset.text()
                  + " needs numbers; for whole values, an offset is an angle in radians");
        }
      }
    }
  }

  private void findCycle(InputElement input, List<String> path, Set<String> finished) {
    int start = path.indexOf(input.name());
    if (start >= 0) {
      List<String> cycle = new ArrayList<>(path.subList(start, path.size()));
      cycle.add(input.name());
      error(
          input,
          "the inputs follow each other in a cycle: "
              + String.join(" -> ", cycle)
              + "; give one of them values of its own");
    }
    if (start >= 0 || finished.contains(input.name())) {
      return;
    }
    path.add(input.name());
    for (TestSpec.Related spec : related(input)) {
      InputElement to = inputs.get(spec.to());
      if (to != null) {
        findCycle(to, path, finished);
      }
    }
    path.remove(path.size() - 1);
    finished.add(input.name());
  }

  private static List<TestSpec.Related> related(InputElement input) {
    return input.specs().stream()
        .filter(TestSpec.Related.class::isInstance)
        .map(TestSpec.Related.class::cast)
        .toList();
  }

  private void error(InputElement input, String message) {
    problems.error(input.line(), "test_element " + input.name() + "/test_spec", message);
  }
}
