package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.harness.cpp.syntax.CppNames;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.cpp.syntax.CppType;
import org.sitaf.core.harness.plan.HarnessPlan;

/** The view of the test stub. */
record TestStubView(
    String namespace,
    boolean hasStubs,
    List<String> includes,
    List<Interface> interfaces,
    String answers,
    List<String> settings,
    List<StepAnswers> steps,
    List<Error> errors,
    String constructor,
    String begin) {

  /** The function that sets the answers of a step. */
  record StepAnswers(String step, String name, String answers, List<String> settings) {}

  /** A stubbed interface. */
  record Interface(
      String name,
      String className,
      String field,
      List<String> declarations,
      List<Function> functions,
      List<String> members) {}

  /** The definition of a stubbed method. */
  record Function(String head, List<String> body) {}

  /** An error in answers. */
  record Error(String name, String literal) {}

  static TestStubView of(CppPlan plan) {
    return new TestStubView(
        plan.namespace(),
        !plan.stubs().isEmpty(),
        includes(plan),
        plan.stubs().stream().map(TestStubView::answering).toList(),
        parameters(plan),
        settings(plan),
        steps(plan),
        plan.plan().errors().stream().map(e -> new Error(e, CppText.string(e))).toList(),
        CppText.constructor(
            "TestStub::TestStub(runtime::TestRun& run)",
            Stream.concat(
                    Stream.of("stubbing_(run, raise)"),
                    plan.stubs().stream().map(stub -> stub.name() + "_(stubbing_)"))
                .toList()),
        CppText.list(
            "stubbing_.begin(", List.of("{" + String.join(", ", methodNames(plan)) + "}"), ");"));
  }

  private static String parameters(CppPlan plan) {
    return plan.answers().stream()
        .map(a -> "const runtime::Answer<" + plan.typeOf(a) + ">& " + a.local())
        .collect(Collectors.joining(", "));
  }

  private static List<StepAnswers> steps(CppPlan plan) {
    List<StepAnswers> steps = new ArrayList<>();
    for (CppPlan.Step step : plan.steps()) {
      CppPlan call = step.call();
      if (call != null && !call.answers().isEmpty()) {
        steps.add(
            new StepAnswers(
                CppText.comment(step.name()),
                step.prepare(),
                parameters(call),
                call.stubs().stream().flatMap(s -> replacing(plan, s)).toList()));
      }
    }
    return steps;
  }

  /** Replaces the answers of an interface that a step sets. */
  private static Stream<String> replacing(CppPlan whole, CppPlan.Stub ofStep) {
    CppPlan.Stub stub =
        whole.stubs().stream()
            .filter(s -> s.className().equals(ofStep.className()))
            .findFirst()
            .orElseThrow();
    List<String> statements = new ArrayList<>();
    for (int m = 0; m < ofStep.methods().size(); m++) {
      CppPlan.StubMethod method = stub.methods().get(m);
      for (CppPlan.Answers answers : ofStep.methods().get(m).answers()) {
        String member =
            method.answers().stream()
                .filter(a -> Objects.equals(a.parameter(), answers.parameter()))
                .findFirst()
                .orElseThrow()
                .member();
        statements.add(
            CppText.list(
                stub.name() + "_." + member + "_.replace(",
                List.of(
                    answers.byCall().stream()
                        .map(a -> "{" + a.answer().fromCall() + ", " + a.local() + "}")
                        .collect(Collectors.joining(", ", "{", "}")),
                    "stubbing_.calls("
                        + CppText.string(stub.stub().name() + "." + method.method().method().name())
                        + ")"),
                ");"));
      }
    }
    return statements.stream();
  }

  private static List<String> methodNames(CppPlan plan) {
    return plan.stubs().stream()
        .flatMap(
            s ->
                s.stub().methods().stream()
                    .map(m -> CppText.string(s.stub().name() + "." + m.method().name())))
        .distinct()
        .toList();
  }

  private static List<String> includes(CppPlan plan) {
    List<DataType> types =
        plan.stubs().stream()
            .flatMap(s -> s.stub().methods().stream())
            .flatMap(TestStubView::typesOf)
            .toList();
    Includes includes = new Includes().own("sitaf/runtime/stub.hpp").types(types);
    plan.stubs().forEach(s -> includes.own("sitaf/interfaces/" + s.stub().name() + ".hpp"));
    return includes.lines();
  }

  private static Stream<DataType> typesOf(HarnessPlan.StubMethod method) {
    return Stream.concat(
        Stream.of(method.method().returnType()),
        method.method().parameters().stream().map(Parameter::type));
  }

  private static List<String> settings(CppPlan plan) {
    List<String> statements = new ArrayList<>();
    for (CppPlan.Stub stub : plan.stubs()) {
      for (CppPlan.StubMethod method : stub.methods()) {
        for (CppPlan.Answers answers : method.answers()) {
          String member = stub.name() + "_." + answers.member() + "_";
          statements.add(member + ".reset();");
          for (CppPlan.Answer answer : answers.byCall()) {
            statements.add(
                CppText.list(
                    member + ".set(",
                    List.of(Integer.toString(answer.answer().fromCall()), answer.local()),
                    ");"));
          }
        }
      }
    }
    return statements;
  }

  private static Interface answering(CppPlan.Stub stub) {
    List<String> declarations = new ArrayList<>();
    List<Function> functions = new ArrayList<>();
    List<String> members = new ArrayList<>();
    for (CppPlan.StubMethod method : stub.methods()) {
      Method prototype = method.method().method();
      CppNames scope = new CppNames();
      List<String> locals =
          prototype.parameters().stream().map(p -> scope.local(p.name())).toList();
      List<String> parameters = new ArrayList<>();
      for (int i = 0; i < locals.size(); i++) {
        parameters.add(CppType.parameter(prototype.parameters().get(i), locals.get(i), false));
      }
      String returns = CppType.of(prototype.returnType());
      declarations.add(
          CppText.list(returns + " " + prototype.name() + "(", parameters, ") override;"));
      functions.add(
          new Function(
              CppText.list(
                  returns + " " + stub.className() + "::" + prototype.name() + "(",
                  parameters,
                  ") {"),
              body(stub, method, locals)));
      for (CppPlan.Answers answers : method.answers()) {
        members.add("runtime::Answers<" + answers.type() + "> " + answers.member() + "_;");
      }
    }
    return new Interface(
        stub.stub().name(), stub.className(), stub.name(), declarations, functions, members);
  }

  private static List<String> body(
      CppPlan.Stub stub, CppPlan.StubMethod method, List<String> locals) {
    Method prototype = method.method().method();
    List<String> body = new ArrayList<>();
    List<String> given = new ArrayList<>();
    for (int i = 0; i < locals.size(); i++) {
      Parameter parameter = prototype.parameters().get(i);
      if (parameter.direction() != Direction.OUT) {
        given.add(
            "runtime::argument(" + CppText.string(parameter.name()) + ", " + locals.get(i) + ")");
      }
    }
    body.add(
        CppText.list(
            "const runtime::StubbedCall call(",
            List.of(
                "stubbing_",
                CppText.string(stub.stub().name() + "." + prototype.name()),
                "{" + String.join(", ", given) + "}"),
            ");"));
    for (int i = 0; i < locals.size(); i++) {
      Parameter parameter = prototype.parameters().get(i);
      for (CppPlan.Answers answers : method.answers()) {
        if (parameter.equals(answers.parameter())) {
          body.add(locals.get(i) + " = " + answers.member() + "_.give(call);");
        }
      }
    }
    CppPlan.Answers returned = method.returned();
    if (prototype.returnType().isVoid()) {
      if (returned != null) {
        body.add(returned.member() + "_.give(call);");
      }
    } else {
      body.add(returned == null ? "return {};" : "return " + returned.member() + "_.give(call);");
    }
    return body;
  }
}
