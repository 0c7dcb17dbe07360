package org.sitaf.core.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.timing.Timing;

/**
 * The test specifications of one method (paper, Fig. 4).
 *
 * @param definitions named sub-expressions
 * @param constants constants and enumeration literals of the activity's interfaces by name: Long,
 *     Double, Boolean or String
 * @param maxCases maximum number of cases, at least 1
 * @param timing how often calls are repeated; null if the model does not say
 * @param sequence which sequences of calls are generated; null if a case is one call
 * @param surroundings of a call in a sequence: the types of the names besides the inputs that its
 *     expected values and post-conditions can use, in order; empty otherwise
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
    @Nullable SequenceSpec sequence,
    Map<String, DataType> surroundings,
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
    surroundings = Collections.unmodifiableMap(new LinkedHashMap<>(surroundings));
  }

  /** The model of one call per case. */
  public TestModel(
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
    this(
        name,
        description,
        target,
        definitions,
        constants,
        preConditions,
        inputs,
        outputs,
        postConditions,
        trajectoryConditions,
        relations,
        invalidValues,
        strength,
        mixedStrengths,
        keptCases,
        maxCases,
        timing,
        null,
        Map.of(),
        source);
  }

  /** A copy with other input elements. */
  public TestModel withInputs(List<InputElement> replaced) {
    Copy copy = new Copy();
    copy.inputs = replaced;
    return copy.model();
  }

  /** A copy with the constants of interfaces, also for the calls of a sequence. */
  public TestModel withConstants(Map<String, Object> named) {
    Copy copy = new Copy();
    copy.constants = named;
    copy.sequence = sequence == null ? null : sequence.withModels(m -> m.withConstants(named));
    return copy.model();
  }

  /** A copy with other output elements. */
  public TestModel withOutputs(List<OutputElement> replaced) {
    Copy copy = new Copy();
    copy.outputs = replaced;
    return copy.model();
  }

  /** A copy that only has inputs and what restricts them. */
  public TestModel withoutOutputs() {
    Copy copy = new Copy();
    copy.outputs = List.of();
    copy.postConditions = List.of();
    copy.trajectoryConditions = List.of();
    copy.relations = List.of();
    copy.sequence = null;
    copy.surroundings = Map.of();
    copy.keptCases = List.of();
    return copy.model();
  }

  /** A copy with other mixed strengths. */
  public TestModel withMixedStrengths(List<MixedStrength> replaced) {
    Copy copy = new Copy();
    copy.mixedStrengths = replaced;
    return copy.model();
  }

  /** A copy with other cases to keep. */
  public TestModel withKeptCases(List<KeptCase> replaced) {
    Copy copy = new Copy();
    copy.keptCases = replaced;
    return copy.model();
  }

  /** A copy without relations. */
  public TestModel withoutRelations() {
    Copy copy = new Copy();
    copy.relations = List.of();
    return copy.model();
  }

  /** A copy with other sequences. */
  public TestModel withSequence(@Nullable SequenceSpec replaced) {
    Copy copy = new Copy();
    copy.sequence = replaced;
    return copy.model();
  }

  /** A copy of the model of a call in a sequence with other surroundings. */
  public TestModel withSurroundings(Map<String, DataType> replaced) {
    Copy copy = new Copy();
    copy.surroundings = replaced;
    return copy.model();
  }

  /** A copy that only describes the calls: without definitions, conditions and kept cases. */
  public TestModel withoutConditions() {
    Copy copy = new Copy();
    copy.definitions = List.of();
    copy.preConditions = List.of();
    copy.postConditions = List.of();
    copy.trajectoryConditions = List.of();
    copy.relations = List.of();
    copy.keptCases = List.of();
    copy.timing = null;
    return copy.model();
  }

  /** A copy without repeated calls. */
  public TestModel withoutTiming() {
    Copy copy = new Copy();
    copy.timing = null;
    return copy.model();
  }

  /** The parts of a copy. */
  private final class Copy {
    private List<Definition> definitions = TestModel.this.definitions;
    private Map<String, Object> constants = TestModel.this.constants;
    private List<Condition> preConditions = TestModel.this.preConditions;
    private List<InputElement> inputs = TestModel.this.inputs;
    private List<OutputElement> outputs = TestModel.this.outputs;
    private List<Condition> postConditions = TestModel.this.postConditions;
    private List<TrajectoryCondition> trajectoryConditions = TestModel.this.trajectoryConditions;
    private List<Relation> relations = TestModel.this.relations;
    private List<MixedStrength> mixedStrengths = TestModel.this.mixedStrengths;
    private List<KeptCase> keptCases = TestModel.this.keptCases;
    private @Nullable Timing timing = TestModel.this.timing;
    private @Nullable SequenceSpec sequence = TestModel.this.sequence;
    private Map<String, DataType> surroundings = TestModel.this.surroundings;

    TestModel model() {
      return new TestModel(
          name,
          description,
          target,
          definitions,
          constants,
          preConditions,
          inputs,
          outputs,
          postConditions,
          trajectoryConditions,
          relations,
          invalidValues,
          strength,
          mixedStrengths,
          keptCases,
          maxCases,
          timing,
          sequence,
          surroundings,
          source);
    }
  }

  /** Finds an output by name. An empty name selects the only output. */
  public Optional<OutputElement> output(String outputName) {
    if (outputName.isEmpty()) {
      return outputs.size() == 1 ? Optional.of(outputs.get(0)) : Optional.empty();
    }
    return outputs.stream().filter(o -> o.name().equals(outputName)).findFirst();
  }
}
