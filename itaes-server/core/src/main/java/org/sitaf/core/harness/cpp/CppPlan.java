package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.harness.cpp.syntax.CppNames;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.cpp.syntax.CppType;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.Words;

/**
 * The plan of a test application with its names in C++.
 *
 * @param plan language-independent plan
 * @param namespace innermost namespace
 * @param header header that declares the component
 * @param callName name of the driver's method that makes the call
 * @param steps of a sequence; empty if a case is one call
 */
record CppPlan(
    HarnessPlan plan,
    String namespace,
    String header,
    List<Argument> arguments,
    List<Setting> settings,
    List<Stub> stubs,
    String callName,
    List<Step> steps) {

  /**
   * A step of a sequence.
   *
   * @param method name of the driver's method that executes it
   * @param prepare name of the test stub's method that sets the answers of a call
   * @param call the plan of a call; null for an event
   * @param event null for a call
   */
  record Step(
      String name,
      String method,
      String prepare,
      @Nullable CppPlan call,
      HarnessPlan.@Nullable EventStep event) {}

  /** Whether a case is a sequence of steps. */
  boolean isSequence() {
    return !steps.isEmpty();
  }

  /** The plans of the calls: those of a sequence, or this one. */
  List<CppPlan> calls() {
    List<CppPlan> calls = new ArrayList<>();
    for (Step step : steps) {
      CppPlan call = step.call();
      if (call != null) {
        calls.add(call);
      }
    }
    return steps.isEmpty() ? List.of(this) : calls;
  }

  /** The inputs that are properties of the component. */
  List<String> properties() {
    HarnessPlan.Sequence sequence = plan.sequence();
    return sequence == null
        ? List.of()
        : sequence.properties().stream().map(HarnessPlan.Given::column).toList();
  }

  /** An argument of the call under test and its local variable. */
  record Argument(HarnessPlan.Argument argument, String local) {
    Parameter parameter() {
      return argument.parameter();
    }

    /** Whether it is read from the case as a whole, so the variable can be const. */
    boolean isConstant() {
      return parameter().direction() == Direction.IN
          && argument.given().size() == 1
          && argument.given().get(0).path().isEmpty();
    }
  }

  /** A parameter of the world and its local variable. */
  record Setting(HarnessPlan.World.Setting setting, String local) {}

  /**
   * A required interface.
   *
   * @param className class of the stub
   * @param name name of the getter, and with {@code _} of the member
   */
  record Stub(HarnessPlan.Stub stub, String className, String name, List<StubMethod> methods) {}

  /** A method of a required interface. */
  record StubMethod(HarnessPlan.StubMethod method, List<Answers> answers) {
    /** The answers for the return value, delays and errors; null if there are none. */
    @Nullable Answers returned() {
      return answers.stream().filter(a -> a.parameter() == null).findFirst().orElse(null);
    }
  }

  /**
   * The answers for the return value or one out-parameter.
   *
   * @param member member of the stub's class, without {@code _}
   * @param byCall answers that the cases set; none if only steps set them
   */
  record Answers(String member, @Nullable Parameter parameter, String type, List<Answer> byCall) {}

  /** An answer and its local variable. */
  record Answer(HarnessPlan.Answer answer, String local) {}

  static CppPlan of(HarnessPlan plan, String header) {
    return of(plan, header, "call");
  }

  private static CppPlan of(HarnessPlan plan, String header, String callName) {
    CppNames locals = new CppNames();
    List<Argument> arguments =
        plan.arguments().stream().map(a -> new Argument(a, locals.local(a.name()))).toList();
    List<Setting> settings =
        plan.world() == null
            ? List.of()
            : plan.world().settings().stream()
                .map(s -> new Setting(s, locals.local(s.name())))
                .toList();
    CppNames members = new CppNames();
    List<Stub> stubs =
        plan.stubs().stream()
            .map(
                s ->
                    new Stub(
                        s,
                        s.name() + "Stub",
                        members.local(s.name()),
                        stubMethods(s, answeredInSteps(plan, s.name()), locals)))
            .toList();
    return new CppPlan(
        plan,
        CppNames.namespace(plan.modelName()),
        header,
        arguments,
        settings,
        stubs,
        callName,
        steps(plan, header));
  }

  private static List<Step> steps(HarnessPlan plan, String header) {
    HarnessPlan.Sequence sequence = plan.sequence();
    List<Step> steps = new ArrayList<>();
    if (sequence == null) {
      return steps;
    }
    CppNames methods = new CppNames();
    for (HarnessPlan.CallStep step : sequence.calls()) {
      String suffix = Words.raised(methods.local(step.name()));
      steps.add(
          new Step(
              step.name(),
              "step" + suffix,
              "prepare" + suffix,
              of(step.call(), header, "call" + suffix),
              null));
    }
    for (HarnessPlan.EventStep step : sequence.events()) {
      String suffix = Words.raised(methods.local(step.name()));
      steps.add(new Step(step.name(), "event" + suffix, "", null, step));
    }
    return steps;
  }

  /** The answers that steps set, by the method of an interface. */
  private static Map<Method, List<HarnessPlan.Answer>> answeredInSteps(
      HarnessPlan plan, String interfaceName) {
    Map<Method, List<HarnessPlan.Answer>> answers = new LinkedHashMap<>();
    if (plan.sequence() != null) {
      for (HarnessPlan.CallStep step : plan.sequence().calls()) {
        step.call().stubs().stream()
            .filter(s -> s.name().equals(interfaceName))
            .flatMap(s -> s.methods().stream())
            .forEach(
                m ->
                    answers
                        .computeIfAbsent(m.method(), method -> new ArrayList<>())
                        .addAll(m.answers()));
      }
    }
    return answers;
  }

  private static List<StubMethod> stubMethods(
      HarnessPlan.Stub stub, Map<Method, List<HarnessPlan.Answer>> inSteps, CppNames locals) {
    CppNames members = new CppNames();
    // The name of a member, with its trailing underscore, must differ from all method names.
    stub.methods().stream()
        .map(m -> m.method().name())
        .filter(name -> name.endsWith("_"))
        .forEach(name -> members.take(name.substring(0, name.length() - 1)));
    List<StubMethod> methods = new ArrayList<>();
    for (HarnessPlan.StubMethod method : stub.methods()) {
      List<Answers> answers = new ArrayList<>();
      for (HarnessPlan.Answer answer : method.answers()) {
        Parameter parameter = answer.parameter();
        Answer planned = new Answer(answer, locals.local(answer.column()));
        Answers last = answers.isEmpty() ? null : answers.get(answers.size() - 1);
        if (last != null && Objects.equals(last.parameter(), parameter)) {
          List<Answer> more = new ArrayList<>(last.byCall());
          more.add(planned);
          answers.set(answers.size() - 1, new Answers(last.member(), parameter, last.type(), more));
          continue;
        }
        answers.add(answers(method, answer, members, List.of(planned)));
      }
      for (HarnessPlan.Answer answer : inSteps.getOrDefault(method.method(), List.of())) {
        if (answers.stream().noneMatch(a -> Objects.equals(a.parameter(), answer.parameter()))) {
          answers.add(answers(method, answer, members, List.of()));
        }
      }
      methods.add(new StubMethod(method, answers));
    }
    return methods;
  }

  private static Answers answers(
      HarnessPlan.StubMethod method,
      HarnessPlan.Answer answer,
      CppNames members,
      List<Answer> byCall) {
    Parameter parameter = answer.parameter();
    String name =
        method.method().name() + (parameter == null ? "" : Words.raised(parameter.name()));
    String type = answer.type().isVoid() ? "runtime::Nothing" : CppType.of(answer.type());
    return new Answers(members.local(name), parameter, type, byCall);
  }

  /** All answers, in the order of interfaces, methods, parameters and calls. */
  List<Answer> answers() {
    return answerSets().flatMap(a -> a.byCall().stream()).toList();
  }

  private Stream<Answers> answerSets() {
    return stubs.stream().flatMap(s -> s.methods().stream()).flatMap(m -> m.answers().stream());
  }

  /** The type of an answer. */
  String typeOf(Answer answer) {
    return answerSets().filter(a -> a.byCall().contains(answer)).findFirst().orElseThrow().type();
  }

  boolean hasWorld() {
    return plan.world() != null;
  }

  boolean isPeriodic() {
    return plan.component().period() != null;
  }

  /** Whether simulation time passes after the call. */
  boolean runsOn() {
    return plan.world() != null && !plan.world().runFor().isZero();
  }

  boolean observes() {
    return calls().stream()
        .flatMap(c -> c.plan.outputs().stream())
        .anyMatch(o -> o.source() instanceof HarnessPlan.Source.Observation);
  }

  /** The qualified name of the class under test. */
  String component() {
    return "::" + plan.component().className();
  }

  String returnType() {
    return CppType.of(plan.method().returnType());
  }

  /** The declaration of the function that makes the call. */
  String callHead() {
    List<String> parameters = new ArrayList<>();
    parameters.add("Component& component");
    arguments.forEach(a -> parameters.add(CppType.parameter(a.parameter(), a.local(), false)));
    return CppText.list(returnType() + " " + callName + "(", parameters, ")");
  }

  /** {@code Interface.Method} or the interface of a sequence, escaped for a comment. */
  String called() {
    return CppText.comment(
        isSequence() ? "sequences of " + plan.interfaceName() : plan.methodName());
  }
}
