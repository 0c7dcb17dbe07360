package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.harness.python.PythonPlan.Answer;
import org.sitaf.core.harness.python.PythonPlan.Stub;
import org.sitaf.core.harness.python.PythonPlan.StubMethod;

/** The view of the test stub. */
record TestStubView(
    String imports,
    boolean hasStubs,
    boolean hasErrors,
    String errors,
    List<Interface> interfaces,
    String prepareDeclaration,
    List<String> settings,
    List<StepAnswers> steps) {

  /** The method that sets the answers of a step. */
  record StepAnswers(String step, String declaration, List<String> settings) {}

  /** A stubbed interface. */
  record Interface(
      String name, String field, String described, List<String> fields, List<Answering> methods) {}

  /** A stubbed method, and its name in the interface if Python needs another one. */
  record Answering(String declaration, String call, String name, @Nullable String alias) {}

  static TestStubView of(PythonPlan plan) {
    List<String> settings = new ArrayList<>();
    for (Stub stub : plan.stubs()) {
      for (StubMethod method : stub.methods()) {
        settings.add("self." + stub.field() + "." + method.field() + ".reset()");
        method.answers().forEach(a -> settings.add(setting(stub, method, a)));
      }
    }
    return new TestStubView(
        imports(plan),
        !plan.stubs().isEmpty(),
        hasErrors(plan),
        PythonText.list(
            "ERRORS: dict[str, type[Exception]] = {",
            plan.neutral().errors().stream().map(e -> PythonText.string(e) + ": " + e).toList(),
            "}"),
        plan.stubs().stream().map(TestStubView::answering).toList(),
        prepare("prepare", plan),
        settings,
        steps(plan));
  }

  private static String prepare(String name, PythonPlan plan) {
    return PythonText.list(
        "def " + name + "(",
        Stream.concat(
                Stream.of("self"), plan.answers().stream().map(a -> a.local() + ": " + hint(a)))
            .toList(),
        ") -> None:");
  }

  private static List<StepAnswers> steps(PythonPlan plan) {
    List<StepAnswers> steps = new ArrayList<>();
    for (PythonPlan.Step step : plan.steps()) {
      PythonPlan call = step.call();
      if (call != null && !call.answers().isEmpty()) {
        List<String> settings = new ArrayList<>();
        for (Stub stub : call.stubs()) {
          String field =
              plan.stubs().stream()
                  .filter(s -> s.name().equals(stub.name()))
                  .map(Stub::field)
                  .findFirst()
                  .orElse(stub.field());
          stub.methods().forEach(m -> settings.addAll(replacing(field, m)));
        }
        steps.add(
            new StepAnswers(
                PythonText.plain(step.name()), prepare(step.prepare(), call), settings));
      }
    }
    return steps;
  }

  /** Replaces the answers for the return value and for each out-parameter that has one. */
  private static List<String> replacing(String field, StubMethod method) {
    Map<String, List<String>> byPart = new LinkedHashMap<>();
    for (Answer answer : method.answers()) {
      Parameter parameter = answer.neutral().parameter();
      byPart
          .computeIfAbsent(parameter == null ? "" : parameter.name(), part -> new ArrayList<>())
          .add(answer.neutral().fromCall() + ": " + answer.local());
    }
    List<String> statements = new ArrayList<>();
    byPart.forEach(
        (part, answers) -> {
          List<String> arguments = new ArrayList<>();
          arguments.add("{" + String.join(", ", answers) + "}");
          if (!part.isEmpty()) {
            arguments.add("out=" + PythonText.string(part));
          }
          statements.add(
              PythonText.list(
                  "self." + field + "." + method.field() + ".replace(", arguments, ")"));
        });
    return statements;
  }

  private static boolean hasErrors(PythonPlan plan) {
    return Stream.concat(Stream.of(plan), plan.calls().stream())
        .flatMap(p -> p.answers().stream())
        .anyMatch(a -> !a.neutral().plain());
  }

  private static String hint(Answer answer) {
    String hint = PythonType.hint(answer.neutral().type());
    return answer.neutral().plain() ? hint : "Answer[" + hint + "]";
  }

  private static String setting(Stub stub, StubMethod method, Answer answer) {
    List<String> arguments = new ArrayList<>();
    arguments.add(answer.local());
    if (answer.neutral().fromCall() > 1) {
      arguments.add("from_call=" + answer.neutral().fromCall());
    }
    if (answer.neutral().parameter() != null) {
      arguments.add("out=" + PythonText.string(answer.neutral().parameter().name()));
    }
    return PythonText.list(
        "self." + stub.field() + "." + method.field() + ".answer(", arguments, ")");
  }

  private static Interface answering(Stub stub) {
    return new Interface(
        stub.name(),
        stub.field(),
        PythonText.plain(stub.name()),
        stub.methods().stream().map(m -> field(stub, m)).toList(),
        stub.methods().stream().map(TestStubView::method).toList());
  }

  private static String field(Stub stub, StubMethod method) {
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "run.stubbing",
                PythonText.string(stub.name() + "." + method.name()),
                PythonType.kind(method.neutral().method().returnType())));
    if (!method.parameters(false).isEmpty()) {
      arguments.add("inputs=" + kinds(method.parameters(false)));
    }
    if (!method.parameters(true).isEmpty()) {
      arguments.add("outs=" + kinds(method.parameters(true)));
    }
    return PythonText.list("self." + method.field() + " = StubbedMethod(", arguments, ")");
  }

  private static String kinds(List<Parameter> parameters) {
    return parameters.stream()
        .map(p -> PythonText.string(p.name()) + ": " + PythonType.kind(p.type()))
        .collect(Collectors.joining(", ", "{", "}"));
  }

  private static Answering method(StubMethod method) {
    return new Answering(
        declaration(method),
        PythonText.list("self." + method.field() + ".call(", method.inputs(), ")"),
        method.name(),
        method.alias());
  }

  /** The declaration of a method. Out-parameters are returned. */
  static String declaration(StubMethod method) {
    List<Parameter> inputs = method.parameters(false);
    List<String> parameters = new ArrayList<>(List.of("self"));
    IntStream.range(0, inputs.size())
        .forEach(
            i ->
                parameters.add(
                    method.inputs().get(i) + ": " + PythonType.hint(inputs.get(i).type())));
    return PythonText.list(
        "def " + method.name() + "(", parameters, ") -> " + returned(method) + ":");
  }

  private static String returned(StubMethod method) {
    List<String> parts = new ArrayList<>();
    if (!method.neutral().method().returnType().isVoid()) {
      parts.add(PythonType.hint(method.neutral().method().returnType()));
    }
    method.parameters(true).forEach(p -> parts.add(PythonType.hint(p.type())));
    return switch (parts.size()) {
      case 0 -> "None";
      case 1 -> parts.get(0);
      default -> "tuple[" + String.join(", ", parts) + "]";
    };
  }

  private static String imports(PythonPlan plan) {
    Imports imports = new Imports().add("sitaf_runtime.run", "TestRun");
    if (!plan.stubs().isEmpty()) {
      imports.add("sitaf_runtime.stub", "StubbedMethod");
    }
    for (Stub stub : plan.stubs()) {
      imports.add("sitaf_interfaces", stub.name());
      for (StubMethod method : stub.methods()) {
        if (!method.neutral().method().returnType().isVoid()) {
          PythonType.importKind(method.neutral().method().returnType(), imports);
        }
        method
            .neutral()
            .method()
            .parameters()
            .forEach(p -> PythonType.importKind(p.type(), imports));
      }
    }
    if (hasErrors(plan)) {
      imports.add("sitaf_runtime.stub", "Answer");
      plan.neutral().errors().forEach(e -> imports.add("sitaf_interfaces", e));
    }
    return imports.text();
  }
}
