package org.sitaf.core.model;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.timing.Timing;

/**
 * The test specifications of one method (paper, Fig. 4).
 *
 * @param definitions named sub-expressions
 * @param constants constants and enumeration literals of the activity's interfaces by name: Long,
 *     Double, Boolean or String
 * @param maxCases maximum number of cases, at least 1
 * @param timing how often calls are repeated; null if the model does not say
 * @param source name of the document
 */
public record TestModel(
    String name,
    String description,
    Target target,
    List<Definition> definitions,
    Map<String, Object> constants,
    List<Condition> preConditions,
    List<InputElement> inputs,
    List<OutputElement> outputs,
    List<Condition> postConditions,
    List<TrajectoryCondition> trajectoryConditions,
    List<Relation> relations,
    InvalidValues invalidValues,
    Strength strength,
    List<MixedStrength> mixedStrengths,
    List<KeptCase> keptCases,
    int maxCases,
    @Nullable Timing timing,
    String source) {
  /** The number of cases is not bounded by the model. */
  public static final int UNBOUNDED = Integer.MAX_VALUE;

  public TestModel {
    Objects.requireNonNull(name);
    Objects.requireNonNull(description);
    Objects.requireNonNull(target);
    Objects.requireNonNull(invalidValues);
    Objects.requireNonNull(strength);
    Objects.requireNonNull(source);
    definitions = List.copyOf(definitions);
    constants = Map.copyOf(constants);
    preConditions = List.copyOf(preConditions);
    inputs = List.copyOf(inputs);
    outputs = List.copyOf(outputs);
    postConditions = List.copyOf(postConditions);
    trajectoryConditions = List.copyOf(trajectoryConditions);
    relations = List.copyOf(relations);
    mixedStrengths = List.copyOf(mixedStrengths);
    keptCases = List.copyOf(keptCases);
  }

  /** A copy with other input elements. */
  public TestModel withInputs(List<InputElement> replaced) {
    return copy(constants, replaced, outputs, relations, timing);
  }

  /** A copy with the constants of interfaces. */
  public TestModel withConstants(Map<String, Object> named) {
    return copy(named, inputs, outputs, relations, timing);
  }

  /** A copy with other output elements. */
  public TestModel withOutputs(List<OutputElement> replaced) {
    return copy(constants, inputs, replaced, relations, timing);
  }

  /** A copy without relations. */
  public TestModel withoutRelations() {
    return copy(constants, inputs, outputs, List.of(), timing);
  }

  /** A copy that only describes the calls: without definitions, conditions and kept cases. */
  public TestModel withoutConditions() {
    return new TestModel(
        name,
        description,
        target,
        List.of(),
        constants,
        List.of(),
        inputs,
        outputs,
        List.of(),
        List.of(),
        List.of(),
        invalidValues,
        strength,
        mixedStrengths,
        List.of(),
        maxCases,
        null,
        source);
  }

  /** A copy without repeated calls. */
  public TestModel withoutTiming() {
    return copy(constants, inputs, outputs, relations, null);
  }

  private TestModel copy(
      Map<String, Object> newConstants,
      List<InputElement> newInputs,
      List<OutputElement> newOutputs,
      List<Relation> newRelations,
      @Nullable Timing newTiming) {
    return new TestModel(
        name,
        description,
        target,
        definitions,
        newConstants,
        preConditions,
        newInputs,
        newOutputs,
        postConditions,
        trajectoryConditions,
        newRelations,
        invalidValues,
        strength,
        mixedStrengths,
        keptCases,
        maxCases,
        newTiming,
        source);
  }

  /** Finds an output by name. An empty name selects the only output. */
  public Optional<OutputElement> output(String outputName) {
    if (outputName.isEmpty()) {
      return outputs.size() == 1 ? Optional.of(outputs.get(0)) : Optional.empty();
    }
    return outputs.stream().filter(o -> o.name().equals(outputName)).findFirst();
  }
}
