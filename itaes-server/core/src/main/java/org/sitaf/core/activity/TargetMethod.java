package org.sitaf.core.activity;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.model.Target;
import org.sitaf.core.model.TestModel;

/** The method under test and its interface. */
public record TargetMethod(InterfaceDescription declaring, Method method) {
  /** A comma between types, but not within {@code sequence<double,8>}. */
  private static final String OUTSIDE_BRACKETS = ",(?![^<]*>)";

  public TargetMethod {
    Objects.requireNonNull(declaring);
    Objects.requireNonNull(method);
  }

  /**
   * Finds the target of a model.
   *
   * @throws IllegalArgumentException if no method or more than one matches; lists the methods
   */
  public static TargetMethod find(TestModel model, List<InterfaceDescription> provided) {
    Target target = model.target();
    List<InterfaceDescription> interfaces =
        provided.stream()
            .filter(i -> target.interfaceName() == null || i.name().equals(target.interfaceName()))
            .toList();
    if (interfaces.isEmpty()) {
      throw new IllegalArgumentException(
          "no provided interface is named "
              + target.interfaceName()
              + "; provided interfaces: "
              + provided.stream().map(InterfaceDescription::name).toList());
    }
    List<TargetMethod> found = new ArrayList<>();
    for (InterfaceDescription description : interfaces) {
      description.methodsNamed(target.method()).stream()
          .filter(m -> target.signature() == null || fits(m, target.signature()))
          .forEach(m -> found.add(new TargetMethod(description, m)));
    }
    if (found.isEmpty()) {
      throw new IllegalArgumentException(
          "no method "
              + target.method()
              + (target.signature() == null ? "" : "(" + target.signature() + ")")
              + "; known methods: "
              + interfaces.stream()
                  .flatMap(i -> i.methods().stream().map(m -> i.name() + "." + m.name()))
                  .collect(Collectors.joining(", ")));
    }
    if (found.size() > 1) {
      throw new IllegalArgumentException(
          "several methods match; select one by interface and signature: "
              + found.stream()
                  .map(
                      f ->
                          f.declaring.name()
                              + "."
                              + f.method.name()
                              + "("
                              + f.method.signature()
                              + ")")
                  .collect(Collectors.joining(", ")));
    }
    return found.get(0);
  }

  private static boolean fits(Method method, String signature) {
    String wanted =
        signature.isBlank()
            ? ""
            : Arrays.stream(signature.split(OUTSIDE_BRACKETS))
                .map(t -> TypeGrammar.parse(t).type().typeName())
                .collect(Collectors.joining(","));
    return method.signature().equals(wanted);
  }
}
