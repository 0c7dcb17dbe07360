package org.sitaf.core.beginning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.StateVariable;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

class SequenceProposalTest {
  private static Activity activity(String idl) {
    byte[] content = idl.getBytes(StandardCharsets.UTF_8);
    var read = InterfaceFiles.read(SourceFiles.of("a", Map.of("A.idl", content), List.of("A.idl")));
    return Activity.read(
        new NewActivity(
                "a",
                Language.PYTHON,
                null,
                List.of("A.idl"),
                read.provided(),
                FileTree.of(Map.of("A.idl", content)),
                FileTree.of(Map.of()),
                null)
            .propose()
            .files());
  }

  private static Optional<SequenceSpec> sequences(String idl) {
    return activity(idl).models().stream()
        .filter(m -> m.sequence() != null)
        .findFirst()
        .map(TestModel::sequence);
  }

  private static List<String> states(SequenceSpec spec) {
    return spec.states().stream().map(StateVariable::name).toList();
  }

  private static String guard(SequenceSpec spec, String call) {
    SequenceCall found =
        spec.calls().stream().filter(c -> c.name().equals(call)).findFirst().orElseThrow();
    return found.guard() == null ? "" : Objects.requireNonNull(found.guard()).expression();
  }

  @ParameterizedTest
  @CsvSource({
    "Enable, Disable, enabled",
    "start_motion, stop_motion, motion_started",
    "openGripper, closeGripper, gripper_open",
    "TurnOn, TurnOff, on",
    "PowerOnMotor, PowerOffMotor, motor_powered",
    "Grasp, Release, holding"
  })
  void aPairOfVerbsIsAState(String on, String off, String state) {
    SequenceSpec spec =
        sequences("interface A { void %s(); void %s(); double Read(); };".formatted(on, off))
            .orElseThrow();

    assertThat(states(spec)).containsExactly(state);
    assertThat(guard(spec, "Read")).isEqualTo(state);
    assertThat(guard(spec, on)).isEmpty();
  }

  @Test
  void aComponentThatDoesNothingPassesAndEveryOrderIsCovered() {
    Activity activity =
        activity(
            """
            interface A {
              void Start(in double speed); void Stop(); boolean IsStarted();
              void SetLimit(in double limit); double GetLimit(); long Move(in double started);
            };
            """);
    TestModel model =
        activity.models().stream().filter(m -> m.sequence() != null).findFirst().orElseThrow();

    var suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT);

    assertThat(activity.warnings()).isEmpty();
    assertThat(suite.suite().cases()).hasSizeBetween(4, 60);
    assertThat(model.name()).isEqualTo("Sequences");
    // A state may not have the name of the parameter of Move.
    assertThat(states(Objects.requireNonNull(model.sequence()))).containsExactly("is_started");
  }

  @Test
  void aLifeCycleIsOneState() {
    SequenceSpec spec =
        sequences(
                "interface A { void onInitialize(); void onStart(); void onStop();"
                    + " void onDestroy(); void Work(); };")
            .orElseThrow();

    assertThat(states(spec)).containsExactly("life_cycle");
    assertThat(guard(spec, "onStart")).isEqualTo("life_cycle == \"ready\"");
    assertThat(guard(spec, "Work")).isEqualTo("life_cycle == \"active\"");
  }

  @Test
  void namesWithoutAPairTellNothing() {
    assertThat(sequences("interface A { void Start(); double Read(); void SetX(in double x); };"))
        .isEmpty();
  }

  @Test
  void a_model_without_states_is_proposed_on_request() {
    byte[] idl =
        "interface Arm { double Reach(in double to); void Home(); };"
            .getBytes(StandardCharsets.UTF_8);
    var read = InterfaceFiles.read(SourceFiles.of("a", Map.of("A.idl", idl), List.of("A.idl")));
    assertThat(SequenceProposal.of(read.provided().get(0), "Sequences")).isEmpty();
    String text = SequenceProposal.always(read.provided().get(0), "Sequences");
    SequenceSpec spec =
        Objects.requireNonNull(
            TestModelXml.read(
                    new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "model")
                .sequence());
    assertThat(spec.states()).isEmpty();
    assertThat(spec.calls()).extracting(SequenceCall::name).containsExactly("Reach", "Home");
    assertThat(spec.calls()).allMatch(c -> c.guard() == null);
    assertThat(text).contains("The names of the methods tell no states");
  }
}
