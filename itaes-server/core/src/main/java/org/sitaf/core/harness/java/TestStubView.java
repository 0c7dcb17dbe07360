package org.sitaf.core.harness.java;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.sitaf.core.description.Direction;
import org.sitaf.core.harness.java.plan.JavaPlan;
import org.sitaf.core.harness.java.plan.JavaPlan.Answered;
import org.sitaf.core.harness.java.plan.JavaPlan.JavaParameter;
import org.sitaf.core.harness.java.plan.JavaPlan.Stub;
import org.sitaf.core.harness.java.plan.JavaPlan.StubMethod;
import org.sitaf.core.harness.java.plan.JavaPlan.StubOut;
import org.sitaf.core.harness.java.plan.JavaText;
import org.sitaf.core.harness.java.plan.JavaType;

/** The view of the test stub. */
record TestStubView(
    String packageName,
    boolean hasStubs,
    SortedSet<String> imports,
    List<String> fields,
    List<String> initialisations,
    List<Interface> interfaces,
    String answers,
    boolean hasSettings,
    List<String> settings,
    List<StepAnswers> steps) {

  /** The method that sets the answers of a step. */
  record StepAnswers(String step, String method, String answers, List<String> settings) {}

  /** A stubbed interface. */
  record Interface(String name, String field, List<Answer> methods) {}

  /**
   * A stubbed method.
   *
   * @param body statements of the method
   * @param last whether it is the last method
   */
  record Answer(String declaration, List<String> body, boolean last) {}

  static TestStubView of(JavaPlan plan) {
    List<StubMethod> methods = plan.stubs().stream().flatMap(s -> s.methods().stream()).toList();
    List<StubOut> outs = methods.stream().flatMap(m -> m.outs().stream()).toList();
    List<String> fields = new ArrayList<>();
    List<String> initialisations = new ArrayList<>();
    methods.forEach(
        m -> {
          fields.add("private final StubbedMethod<" + m.boxed() + "> " + m.field() + ";");
          initialisations.add(initialisation(m));
        });
    outs.forEach(
        o -> {
          JavaType type = o.parameter().type();
          fields.add("private final StubbedOut<" + type.boxed() + "> " + o.field() + ";");
          initialisations.add(
              JavaText.call("this." + o.field() + " =", "new StubbedOut<>", List.of(type.zero())));
        });
    var answers = plan.answers();
    return new TestStubView(
        plan.packageName(),
        !plan.stubs().isEmpty(),
        imports(plan, methods, outs),
        fields,
        initialisations,
        plan.stubs().stream().map(TestStubView::answering).toList(),
        parameters(answers),
        !answers.isEmpty(),
        answers.stream().map(a -> setting(a.local(), a)).toList(),
        steps(plan, methods, outs));
  }

  private static String parameters(List<Answered> answers) {
    return answers.stream()
        .map(a -> "Answers<" + a.boxed() + "> " + a.local())
        .collect(Collectors.joining(", "));
  }

  private static String setting(String field, Answered answer) {
    return JavaText.call("", "this." + field + ".answerWith", List.of(answer.local()));
  }

  private static List<StepAnswers> steps(
      JavaPlan plan, List<StubMethod> methods, List<StubOut> outs) {
    Map<String, String> fields = new HashMap<>();
    methods.forEach(m -> fields.put(m.fullName(), m.field()));
    outs.forEach(o -> fields.put(o.fullName(), o.field()));
    List<StepAnswers> steps = new ArrayList<>();
    for (JavaPlan.Step step : plan.steps()) {
      List<Answered> answers = step.call() == null ? List.of() : step.call().answers();
      if (!answers.isEmpty()) {
        steps.add(
            new StepAnswers(
                JavaText.comment(step.name()),
                step.prepare(),
                parameters(answers),
                answers.stream().map(a -> setting(fields.get(a.column()), a)).toList()));
      }
    }
    return steps;
  }

  private static String initialisation(StubMethod method) {
    List<String> arguments = new ArrayList<>();
    arguments.add("stubbing");
    arguments.add(JavaText.string(method.fullName()));
    JavaType returns = method.signature().returns();
    arguments.add(returns == null ? "null" : returns.zero());
    ingoing(method).forEach(p -> arguments.add(JavaText.string(p.name())));
    return JavaText.call("this." + method.field() + " =", "new StubbedMethod<>", arguments);
  }

  private static List<JavaParameter> ingoing(StubMethod method) {
    return method.signature().parameters().stream()
        .filter(p -> p.direction() != Direction.OUT)
        .toList();
  }

  private static SortedSet<String> imports(
      JavaPlan plan, List<StubMethod> methods, List<StubOut> outs) {
    SortedSet<String> imports = new TreeSet<>();
    imports.add("org.sitaf.runtime.stub.Stubbing");
    if (!methods.isEmpty()) {
      imports.add("org.sitaf.runtime.stub.StubbedMethod");
    }
    if (!outs.isEmpty()) {
      imports.add("org.sitaf.runtime.stub.StubbedOut");
    }
    if (Stream.concat(Stream.of(plan), plan.calls().stream())
        .anyMatch(p -> !p.answers().isEmpty())) {
      imports.add("org.sitaf.runtime.suite.Answers");
    }
    plan.stubs().forEach(s -> imports.add(JavaType.INTERFACES + "." + s.name()));
    methods.forEach(m -> InterfaceView.addTypes(m.signature(), imports));
    return imports;
  }

  private static Interface answering(Stub stub) {
    int count = stub.methods().size();
    return new Interface(
        stub.name(),
        stub.field(),
        IntStream.range(0, count)
            .mapToObj(i -> answer(stub.methods().get(i), i == count - 1))
            .toList());
  }

  private static Answer answer(StubMethod method, boolean last) {
    List<String> arguments =
        ingoing(method).stream()
            .map(p -> p.direction() == Direction.IN ? boxedArray(p) : p.local() + ".get()")
            .toList();
    String call = "TestStub.this." + method.field() + ".call";
    List<String> body = new ArrayList<>();
    boolean returns = method.signature().returns() != null;
    if (method.outs().isEmpty()) {
      body.add(JavaText.call(returns ? "return" : "", call, arguments));
    } else {
      // The value of an inout-parameter is recorded before the answer replaces it.
      String held = returns ? method.signature().returnName() + " answer =" : "";
      body.add(JavaText.call(held, call, arguments));
      for (StubOut out : method.outs()) {
        body.add(
            JavaText.call(
                "", "TestStub.this." + out.field() + ".fill", List.of(out.parameter().local())));
      }
      if (returns) {
        body.add("return answer;");
      }
    }
    return new Answer(
        JavaText.declaration(
            "public " + method.signature().returnName() + " " + method.signature().name(),
            method.signature().parameters().stream().map(JavaParameter::declaration).toList(),
            " {"),
        body,
        last);
  }

  /** Casts an array, which would otherwise be passed as all varargs at once. */
  private static String boxedArray(JavaParameter parameter) {
    return parameter.type().name().endsWith("[]")
        ? "(Object) " + parameter.local()
        : parameter.local();
  }
}
