package org.sitaf.core.score.fault;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.StubCalls.Call;

/** The faults of calls to required interfaces: left out, repeated, reordered, wrong arguments. */
public final class CallFaults {
  private final Map<String, Map<String, DataType>> types = new LinkedHashMap<>();
  private final List<Fault> faults = new ArrayList<>();

  private CallFaults(List<InterfaceDescription> required) {
    for (InterfaceDescription description : required) {
      for (Method method : description.methods()) {
        Map<String, DataType> parameters =
            types.computeIfAbsent(
                description.name() + "." + method.name(), name -> new LinkedHashMap<>());
        for (Parameter parameter : method.parameters()) {
          parameters.put(parameter.name(), parameter.type());
        }
      }
    }
  }

  /** All faults of the calls to the given interfaces. */
  public static List<Fault> of(List<InterfaceDescription> required) {
    CallFaults all = new CallFaults(required);
    all.types.forEach(all::ofMethod);
    if (all.types.size() > 1) {
      all.add("calls", "calls in reverse order", CallFaults::reversed);
    }
    return all.faults;
  }

  private void ofMethod(String method, Map<String, DataType> parameters) {
    add(method, "calls left out", calls -> without(calls, method, 0, Integer.MAX_VALUE));
    add(method, "first call left out", calls -> without(calls, method, 0, 0));
    add(
        method,
        "last call left out",
        calls -> without(calls, method, count(calls, method) - 1, count(calls, method) - 1));
    add(method, "each call made twice", calls -> twice(calls, method));
    List<String> names = new ArrayList<>(parameters.keySet());
    for (int i = 0; i < names.size(); i++) {
      String name = names.get(i);
      DataType type = parameters.get(name);
      if (type == null) {
        continue;
      }
      for (ValueChange change : ValueChanges.of(type)) {
        add(
            method + "." + name,
            change.text(),
            calls -> changed(calls, method, arguments -> argument(arguments, name, change::apply)));
      }
      if (i > 0 && type.equals(parameters.get(names.get(i - 1)))) {
        String other = names.get(i - 1);
        add(
            method + "." + name,
            "swapped with " + other,
            calls -> changed(calls, method, arguments -> swapped(arguments, other, name)));
      }
    }
  }

  private void add(String where, String text, UnaryOperator<List<Call>> change) {
    faults.add(
        new Fault.OfRecord(
            where,
            where + ": " + text,
            (row, record, before) -> {
              List<Call> calls = record.calls().recorded();
              List<Call> changed = change.apply(calls);
              return changed.equals(calls) ? record : with(record, changed);
            }));
  }

  private static CaseRecord with(CaseRecord record, List<Call> calls) {
    return new CaseRecord(
        record.no(),
        record.outcome(),
        record.thrown(),
        record.actual(),
        new StubCalls(calls, record.calls().leftOut()),
        record.time(),
        record.message());
  }

  private static int count(List<Call> calls, String method) {
    return (int) calls.stream().filter(c -> c.method().equals(method)).count();
  }

  /** Without the calls of a method from the first to the last index, both inclusive. */
  private static List<Call> without(List<Call> calls, String method, int first, int last) {
    List<Call> kept = new ArrayList<>();
    int index = 0;
    for (Call call : calls) {
      boolean removed = call.method().equals(method) && index >= first && index <= last;
      index += call.method().equals(method) ? 1 : 0;
      if (!removed) {
        kept.add(call);
      }
    }
    return kept;
  }

  private static List<Call> twice(List<Call> calls, String method) {
    List<Call> all = new ArrayList<>();
    for (Call call : calls) {
      all.add(call);
      if (call.method().equals(method)) {
        all.add(call);
      }
    }
    return all;
  }

  private static List<Call> reversed(List<Call> calls) {
    List<Call> all = new ArrayList<>(calls);
    Collections.reverse(all);
    return all;
  }

  private static List<Call> changed(
      List<Call> calls, String method, UnaryOperator<List<NamedValue>> change) {
    return calls.stream()
        .map(
            call ->
                call.method().equals(method)
                    ? new Call(method, change.apply(call.arguments()))
                    : call)
        .toList();
  }

  private static List<NamedValue> argument(
      List<NamedValue> arguments, String name, Function<String, String> change) {
    return arguments.stream()
        .map(a -> a.output().equals(name) ? new NamedValue(name, change.apply(a.literal())) : a)
        .toList();
  }

  private static List<NamedValue> swapped(List<NamedValue> arguments, String one, String other) {
    Map<String, String> values = new LinkedHashMap<>();
    arguments.forEach(a -> values.put(a.output(), a.literal()));
    if (!values.containsKey(one) || !values.containsKey(other)) {
      return arguments;
    }
    values.put(one, values.put(other, values.get(one)));
    return values.entrySet().stream().map(e -> new NamedValue(e.getKey(), e.getValue())).toList();
  }
}
