package org.sitaf.core.compare;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sitaf.core.compare.OutputComparison.Closeness;
import org.sitaf.core.compare.OutputComparison.Outcome;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.StubCalls.Call;

/** Compares the calls of required interfaces, which have an order. */
record CallComparison(List<InterfaceDescription> required, int ulp) {
  /**
   * The first call that differs.
   *
   * @param method {@code Interface.Method}
   */
  record Found(Outcome outcome, String method, String base, String now) {}

  /** The first call that differs; in its last bits only if none differs more. */
  Optional<Found> compare(StubCalls base, StubCalls now) {
    if (base.equals(now)) {
      return Optional.empty();
    }
    Map<String, Double> magnitudes = magnitudes(base, now);
    List<Call> left = base.recorded();
    List<Call> right = now.recorded();
    Found lastBits = null;
    for (int i = 0; i < Math.max(left.size(), right.size()); i++) {
      if (i >= left.size() || i >= right.size()) {
        boolean inBase = i < left.size();
        String method = (inBase ? left : right).get(i).method();
        return Optional.of(
            new Found(
                Outcome.OTHER,
                method,
                inBase ? text(i, left.get(i)) : "no call " + (i + 1),
                inBase ? "no call " + (i + 1) : text(i, right.get(i))));
      }
      Outcome outcome = compare(left.get(i), right.get(i), magnitudes);
      Found found =
          new Found(outcome, right.get(i).method(), text(i, left.get(i)), text(i, right.get(i)));
      if (outcome.closeness() == Closeness.DIFFERENT) {
        return Optional.of(found);
      }
      if (outcome.closeness() == Closeness.LAST_BITS && lastBits == null) {
        lastBits = found;
      }
    }
    if (base.leftOut() != now.leftOut()) {
      return Optional.of(
          new Found(Outcome.OTHER, "", total(base) + " calls", total(now) + " calls"));
    }
    return Optional.ofNullable(lastBits);
  }

  private static long total(StubCalls calls) {
    return calls.recorded().size() + calls.leftOut();
  }

  private Outcome compare(Call base, Call now, Map<String, Double> magnitudes) {
    if (!base.method().equals(now.method()) || base.arguments().size() != now.arguments().size()) {
      return Outcome.OTHER;
    }
    Outcome all = Outcome.SAME;
    for (int i = 0; i < base.arguments().size(); i++) {
      NamedValue left = base.arguments().get(i);
      NamedValue right = now.arguments().get(i);
      if (!left.output().equals(right.output())) {
        return Outcome.OTHER;
      }
      all =
          all.and(
              comparison(base, left)
                  .compare(
                      left.literal(),
                      right.literal(),
                      magnitudes.getOrDefault(key(base, left), 0.0)));
    }
    return all;
  }

  private Map<String, Double> magnitudes(StubCalls base, StubCalls now) {
    Map<String, Double> magnitudes = new HashMap<>();
    Stream.concat(base.recorded().stream(), now.recorded().stream())
        .forEach(
            call ->
                call.arguments()
                    .forEach(
                        argument ->
                            magnitudes.merge(
                                key(call, argument),
                                comparison(call, argument).magnitude(argument.literal()),
                                Math::max)));
    return magnitudes;
  }

  private static String key(Call call, NamedValue argument) {
    return call.method() + "." + argument.output();
  }

  private OutputComparison comparison(Call call, NamedValue argument) {
    List<DataType> types =
        required.stream()
            .flatMap(i -> i.methods().stream().filter(m -> isMethod(call, i, m.name())))
            .flatMap(m -> m.parameters().stream())
            .filter(p -> p.name().equals(argument.output()))
            .map(p -> p.type())
            .distinct()
            .toList();
    return new OutputComparison(types.size() == 1 ? types.get(0) : new DataType.Unknown(""), ulp);
  }

  private static boolean isMethod(Call call, InterfaceDescription declaring, String name) {
    return call.method().equals(declaring.name() + "." + name);
  }

  private static String text(int index, Call call) {
    return "call %d: %s(%s)"
        .formatted(
            index + 1,
            call.method(),
            call.arguments().stream()
                .map(a -> a.output() + "=" + a.literal())
                .collect(Collectors.joining(", ")));
  }
}
