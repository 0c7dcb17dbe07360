package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlan.Answer;
import org.sitaf.core.harness.plan.HarnessPlan.Stub;
import org.sitaf.core.harness.plan.HarnessPlan.StubMethod;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/** Plans the stubs of the required interfaces. */
final class StubPlanner {
  /**
   * {@code Interface.Method} or {@code Interface.Method.param}, each optionally followed by {@code
   * #2}.
   */
  private static final Pattern NAME =
      Pattern.compile("([^.#]+)\\.([^.#]+)(?:\\.([^.#]+))?(?:#([1-9][0-9]{0,3}))?");

  private final List<InterfaceDescription> required;
  private final TestModel model;
  private final TestSuite suite;
  private final Diagnostics diagnostics;

  private final Set<String> errors = new TreeSet<>();

  /** The suite's parameters that belong to a stubbed method. */
  private final Set<String> usedColumns = new HashSet<>();

  StubPlanner(
      List<InterfaceDescription> required,
      TestModel model,
      TestSuite suite,
      Diagnostics diagnostics) {
    this.required = required;
    this.model = model;
    this.suite = suite;
    this.diagnostics = diagnostics;
  }

  List<Stub> plan() {
    List<Stub> stubs = new ArrayList<>();
    for (InterfaceDescription description : required) {
      if (!Words.isWord(description.name())) {
        diagnostics.error(
            description.source(),
            0,
            "type_name " + description.name(),
            "is not a valid interface name");
        continue;
      }
      stubs.add(
          new Stub(
              description.name(),
              description.source(),
              description.methods().stream()
                  .filter(m -> checkNames(description, m, diagnostics))
                  .map(m -> new StubMethod(m, answers(description, m)))
                  .toList()));
    }
    for (String column : columns()) {
      if (!usedColumns.contains(column)) {
        problem(
            column,
            "is neither a method of a required interface nor an out-parameter; use"
                + " Interface.Method or Interface.Method.param, followed by #2 for answers from the"
                + " second call on");
      }
    }
    return stubs;
  }

  /** The names of errors in answers. */
  Set<String> errors() {
    return errors;
  }

  private List<String> columns() {
    return suite.parameters().stream()
        .filter(p -> p.kind() == InputKind.TDTS)
        .map(p -> p.name())
        .toList();
  }

  /** Checks that all names of a method are identifiers. Other names are reported. */
  static boolean checkNames(
      InterfaceDescription description, Method method, Diagnostics diagnostics) {
    List<String> problems = new ArrayList<>();
    if (!Words.isWord(method.name())) {
      problems.add("is not a valid method name");
    }
    for (Parameter parameter : method.parameters()) {
      if (!Words.isWord(parameter.name())) {
        problems.add("parameter '" + parameter.name() + "' is not an identifier");
      }
    }
    for (String error : method.raises()) {
      if (!Words.isWord(error)) {
        problems.add("raises '" + error + "', which is not an identifier");
      }
    }
    problems.forEach(
        p -> diagnostics.error(description.source(), method.line(), "method " + method.name(), p));
    return problems.isEmpty();
  }

  private List<Answer> answers(InterfaceDescription description, Method method) {
    List<Answer> answers = new ArrayList<>();
    for (String column : columns()) {
      Matcher name = NAME.matcher(column);
      if (!name.matches()
          || !name.group(1).equals(description.name())
          || !name.group(2).equals(method.name())) {
        continue;
      }
      boolean twice = !usedColumns.add(column);
      if (twice || description.methodsNamed(method.name()).size() > 1) {
        if (!twice) {
          problem(column, "is overloaded; answers of overloaded methods are not supported");
        }
        continue;
      }
      answer(method, column, name).ifPresent(answers::add);
    }
    answers.sort(
        Comparator.comparing((Answer a) -> place(method, a.parameter()))
            .thenComparing(Answer::fromCall));
    for (int i = 1; i < answers.size(); i++) {
      Answer one = answers.get(i - 1);
      Answer other = answers.get(i);
      if (one.fromCall() == other.fromCall()
          && place(method, one.parameter()) == place(method, other.parameter())) {
        problem(other.column(), "answers the same call as " + one.column());
      }
    }
    return answers;
  }

  private static int place(Method method, @Nullable Parameter parameter) {
    return parameter == null ? -1 : method.parameters().indexOf(parameter);
  }

  private Optional<Answer> answer(Method method, String column, Matcher name) {
    int fromCall = name.group(4) == null ? 1 : Integer.parseInt(name.group(4));
    if (name.group(3) == null) {
      boolean plain = isPlain(column);
      if (plain && method.returnType().isVoid()) {
        problem(
            column,
            method.name()
                + " returns nothing; its answers can only be !error:NAME and !delay:SECONDS");
        return Optional.empty();
      }
      return Optional.of(new Answer(column, null, fromCall, method.returnType(), plain));
    }
    Optional<Parameter> parameter =
        method.parameters().stream().filter(p -> p.name().equals(name.group(3))).findFirst();
    if (parameter.isEmpty() || parameter.get().direction() == Direction.IN) {
      problem(column, method.name() + " has no out-parameter " + name.group(3));
      return Optional.empty();
    }
    if (!isPlain(column)) {
      problem(
          column,
          "errors and delays are answers of a whole call; name the element "
              + name.group(1)
              + "."
              + name.group(2));
      return Optional.empty();
    }
    DataType type = parameter.get().type();
    return Optional.of(new Answer(column, parameter.get(), fromCall, type, true));
  }

  /**
   * Parses all answers of a column. Returns whether all of them are only values. Invalid answers
   * are reported.
   */
  private boolean isPlain(String column) {
    int index = suite.parameters().stream().map(p -> p.name()).toList().indexOf(column);
    boolean plain = true;
    for (TestCase testCase : suite.cases()) {
      String value = testCase.values().get(index);
      try {
        StubAnswer answer = StubAnswer.parse(value);
        plain &= answer.isPlain();
        if (answer.error() != null) {
          errors.add(answer.error());
        }
      } catch (IllegalArgumentException e) {
        problem(column, String.valueOf(e.getMessage()));
        return false;
      }
    }
    return plain;
  }

  private void problem(String column, String problem) {
    diagnostics.error(model.source(), 0, "test_element " + column, problem);
  }
}
