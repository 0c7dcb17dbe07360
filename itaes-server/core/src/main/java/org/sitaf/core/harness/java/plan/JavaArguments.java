package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath.Step;
import org.sitaf.core.harness.java.plan.JavaPlan.Argument;
import org.sitaf.core.harness.java.plan.JavaPlan.Read;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlan.Given;

/** Creates the expression of an argument whose parts are set by the cases. */
final class JavaArguments {
  private final JavaNames names;
  private final List<Read> reads = new ArrayList<>();
  private final Map<Given, String> locals = new LinkedHashMap<>();

  private JavaArguments(JavaNames names) {
    this.names = names;
  }

  /** Plans an argument: its variable and its value. */
  static Argument of(HarnessPlan.Argument argument, JavaType type, JavaNames names) {
    String local = names.local(argument.name());
    JavaArguments parts = new JavaArguments(names);
    String value = argument.given().isEmpty() ? null : parts.value(type, argument.given());
    return new Argument(
        argument.name(), local, type, argument.parameter().direction(), parts.reads, value);
  }

  private String value(JavaType type, List<Given> given) {
    if (given.size() == 1 && given.get(0).path().isEmpty()) {
      return "testCase."
          + type.accessor()
          + "("
          + String.join(", ", type.reading(given.get(0).column()))
          + ")";
    }
    for (Given part : given) {
      String local = names.local(part.column());
      locals.put(part, local);
      reads.add(new Read(local, JavaType.of(part.type()).orElseThrow(), part.column()));
    }
    return made(type.type(), given, 0);
  }

  /** An expression of a type with the given parts; all other parts are zero. */
  private String made(DataType type, List<Given> given, int depth) {
    if (given.isEmpty()) {
      return JavaType.of(type).orElseThrow().zero();
    }
    if (given.size() == 1 && given.get(0).path().size() == depth) {
      return locals.get(given.get(0));
    }
    if (type instanceof DataType.Struct struct) {
      return struct.members().stream()
          .map(m -> made(m.type(), at(given, depth, new Step.Member(m.name())), depth + 1))
          .collect(Collectors.joining(", ", "new " + JavaNames.DECLARED.type(struct) + "(", ")"));
    }
    DataType element = type.parts().get(0);
    int length =
        type instanceof DataType.FixedArray fixed
            ? fixed.length()
            : given.stream()
                    .mapToInt(g -> ((Step.Element) g.path().get(depth)).index())
                    .max()
                    .orElseThrow()
                + 1;
    return IntStream.range(0, length)
        .mapToObj(i -> made(element, at(given, depth, new Step.Element(i)), depth + 1))
        .collect(
            Collectors.joining(
                ", ", "new " + JavaType.of(element).orElseThrow().name() + "[] {", "}"));
  }

  private static List<Given> at(List<Given> given, int depth, Step step) {
    return given.stream().filter(g -> g.path().get(depth).equals(step)).toList();
  }
}
