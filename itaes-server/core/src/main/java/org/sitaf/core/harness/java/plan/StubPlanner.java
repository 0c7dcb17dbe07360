package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.java.plan.HarnessPlan.Stub;
import org.sitaf.core.harness.java.plan.HarnessPlan.StubMethod;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/**
 * Plans the test stub: one Java interface for each required interface, one answer a case for each
 * of its methods.
 */
final class StubPlanner {
  private static final DataType VOID = new DataType.Scalar(ScalarType.VOID);

  private final List<InterfaceDescription> required;
  private final TestModel model;
  private final TestSuite suite;
  private final JavaNames names;
  private final Diagnostics diagnostics;

  /** Names of answers by {@code Interface.Method}; overloads share one. */
  private final Map<String, StubMethod> byName = new HashMap<>();

  private final Set<String> answered = new HashSet<>();

  StubPlanner(
      List<InterfaceDescription> required,
      TestModel model,
      TestSuite suite,
      JavaNames names,
      Diagnostics diagnostics) {
    this.required = required;
    this.model = model;
    this.suite = suite;
    this.names = names;
    this.diagnostics = diagnostics;
  }

  List<Stub> plan() {
    for (int i = 0; i < suite.parameters().size(); i++) {
      if (suite.parameters().get(i).kind() == InputKind.TDTS) {
        answered.add(suite.parameters().get(i).name());
        plainAnswers(suite.parameters().get(i), i);
      }
    }
    List<Stub> stubs = new ArrayList<>();
    for (InterfaceDescription description : required) {
      if (!JavaNames.isTypeName(description.name()) || JavaNames.isUsedType(description.name())) {
        diagnostics.error(
            description.source(),
            0,
            "type_name " + description.name(),
            JavaNames.isUsedType(description.name())
                ? "is a name that test applications use themselves; rename the interface"
                : "is not a name that a Java interface can have");
        continue;
      }
      stubs.add(stub(description));
    }
    for (String name : answered) {
      if (!byName.containsKey(name)) {
        diagnostics.error(
            model.source(),
            0,
            "test_element " + name,
            "is not a method of a required interface that returns a value"
                + " (out-parameters and answers of later calls are not supported in Java tests yet)");
      }
    }
    return stubs;
  }

  /**
   * Errors and delays as answers have no meaning in Java tests yet; passing them on as text would
   * give a wrong verdict.
   */
  private void plainAnswers(CaseParameter parameter, int column) {
    for (TestCase testCase : suite.cases()) {
      String value = testCase.values().get(column);
      if (value.startsWith("!")) {
        diagnostics.error(
            model.source(),
            0,
            "test_element " + parameter.name(),
            "case "
                + testCase.no()
                + " answers with "
                + value
                + ": errors and delays are not supported in Java tests yet");
        return;
      }
    }
  }

  private Stub stub(InterfaceDescription description) {
    List<StubMethod> methods = new ArrayList<>();
    Set<String> signatures = new HashSet<>();
    for (Method method : description.methods()) {
      String where = "method " + method.name();
      if (!JavaNames.isName(method.name()) || JavaNames.isObjectMethod(method.name())) {
        diagnostics.error(
            description.source(),
            method.line(),
            where,
            "is not a name that a method of a Java interface can have");
        continue;
      }
      List<String> parameters = parameters(description, method);
      boolean isVoid = method.returnType().equals(VOID);
      Optional<JavaType> returns = JavaType.of(method.returnType());
      if (!isVoid && returns.isEmpty()) {
        unknown(description, method, "its return type", method.returnType());
        continue;
      }
      if (!signatures.add(method.name() + typesOf(parameters))) {
        diagnostics.error(
            description.source(),
            method.line(),
            where,
            "has the same parameters in Java as another overload");
        continue;
      }
      methods.add(planned(description, method, returns.orElse(null), parameters));
    }
    return new Stub(
        description.name(), description.source(), names.local(description.name()), methods);
  }

  private StubMethod planned(
      InterfaceDescription description,
      Method method,
      @Nullable JavaType returns,
      List<String> parameters) {
    String name = description.name() + "." + method.name();
    if (returns == null) {
      return new StubMethod(method.name(), null, parameters, "", null);
    }
    boolean first = !byName.containsKey(name);
    StubMethod planned =
        new StubMethod(
            method.name(),
            returns,
            parameters,
            names.local(name),
            first && answered.contains(name) ? name : null);
    if (first) {
      byName.put(name, planned);
    } else if (answered.contains(name)) {
      diagnostics.error(
          model.source(),
          0,
          "test_element " + name,
          "is overloaded: which of the methods answers is open");
    }
    return planned;
  }

  private List<String> parameters(InterfaceDescription description, Method method) {
    JavaNames scope = new JavaNames();
    List<String> parameters = new ArrayList<>();
    for (Parameter parameter : method.parameters()) {
      Optional<JavaType> type = JavaType.of(parameter.type());
      if (!JavaNames.isWord(parameter.name())) {
        diagnostics.error(
            description.source(),
            method.line(),
            "method " + method.name(),
            "parameter '" + parameter.name() + "' is not an identifier");
      } else if (type.isEmpty()) {
        unknown(description, method, "parameter " + parameter.name(), parameter.type());
      } else {
        String spelled =
            parameter.direction() == Direction.IN
                ? type.get().name()
                : "Out<" + type.get().boxed() + ">";
        parameters.add(spelled + " " + scope.local(parameter.name()));
      }
    }
    return parameters;
  }

  private static List<String> typesOf(List<String> parameters) {
    // Java tells overloads apart by erased types: what Out holds does not count.
    return parameters.stream().map(p -> p.split("[ <]", 2)[0]).toList();
  }

  private void unknown(
      InterfaceDescription description, Method method, String what, DataType type) {
    diagnostics.error(
        description.source(),
        method.line(),
        "method " + method.name(),
        what + " is " + type.spelling() + "; " + JavaType.SUPPORTED);
  }
}
