package org.sitaf.core.harness.java;

import java.util.List;
import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.sitaf.core.harness.java.plan.JavaPlan;
import org.sitaf.core.harness.java.plan.JavaPlan.Stub;
import org.sitaf.core.harness.java.plan.JavaPlan.StubMethod;
import org.sitaf.core.harness.java.plan.JavaText;
import org.sitaf.core.harness.java.plan.JavaType;

/** What the template of the test stub prints. */
record TestStubView(
    String packageName,
    boolean hasStubs,
    SortedSet<String> imports,
    List<String> fields,
    List<String> initialisations,
    List<Interface> interfaces,
    String prepareDeclaration,
    boolean hasSettings,
    List<String> settings) {

  /** An interface that the stub answers for. */
  record Interface(String name, String field, List<Answer> methods) {}

  /**
   * A method of it.
   *
   * @param body the statement inside, where the method returns something
   * @param last whether no method follows
   */
  record Answer(String declaration, boolean hasBody, String body, boolean last) {}

  static TestStubView of(JavaPlan plan) {
    List<StubMethod> returning =
        plan.stubs().stream()
            .flatMap(s -> s.methods().stream())
            .filter(m -> m.returns() != null)
            .toList();
    List<StubMethod> answers = plan.answers();
    return new TestStubView(
        plan.packageName(),
        !plan.stubs().isEmpty(),
        imports(plan, returning),
        returning.stream()
            .map(m -> "  private final StubbedMethod<" + type(m).boxed() + "> " + m.field() + ";")
            .toList(),
        returning.stream()
            .map(
                m ->
                    JavaText.call(
                        4,
                        m.field() + " =",
                        "new StubbedMethod<>",
                        List.of("stopwatch", type(m).zero())))
            .toList(),
        plan.stubs().stream().map(TestStubView::answering).toList(),
        JavaText.declaration(
            2,
            "void prepare",
            answers.stream().map(m -> type(m).name() + " " + m.field()).toList(),
            false,
            answers.isEmpty() ? " {}" : " {"),
        !answers.isEmpty(),
        answers.stream()
            .map(m -> JavaText.call(4, "", "this." + m.field() + ".answerWith", List.of(m.field())))
            .toList());
  }

  private static SortedSet<String> imports(JavaPlan plan, List<StubMethod> returning) {
    SortedSet<String> imports = new TreeSet<>();
    imports.add("org.sitaf.runtime.Stopwatch");
    if (!returning.isEmpty()) {
      imports.add("org.sitaf.runtime.StubbedMethod");
    }
    plan.stubs().forEach(s -> imports.add("sitaf.interfaces." + s.name()));
    plan.stubs().forEach(s -> RequiredInterfaceView.addTypes(s, imports));
    return imports;
  }

  private static Interface answering(Stub stub) {
    int count = stub.methods().size();
    return new Interface(
        stub.name(),
        stub.field(),
        Stream.iterate(0, i -> i < count, i -> i + 1)
            .map(i -> answer(stub.methods().get(i), i == count - 1))
            .toList());
  }

  private static Answer answer(StubMethod method, boolean last) {
    boolean returns = method.returns() != null;
    return new Answer(
        JavaText.declaration(
            8,
            "public " + method.returnName() + " " + method.name(),
            method.parameters(),
            false,
            returns ? " {" : " {}"),
        returns,
        returns ? "          return TestStub.this." + method.field() + ".call();" : "",
        last);
  }

  private static JavaType type(StubMethod method) {
    return Objects.requireNonNull(method.returns());
  }
}
