package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath.Step;
import org.sitaf.core.harness.cpp.syntax.CppNames;
import org.sitaf.core.harness.cpp.syntax.CppText;
import org.sitaf.core.harness.cpp.syntax.CppType;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlan.Output;
import org.sitaf.core.harness.plan.HarnessPlan.Source;
import org.sitaf.core.harness.plan.Hooks;
import org.sitaf.core.harness.plan.Words;

/** The view of the test driver: the five steps of Fig. 10. */
record TestDriverView(
    String namespace,
    List<String> includes,
    String called,
    String model,
    String description,
    String component,
    String constructor,
    String callHead,
    String newComponent,
    List<String> reads,
    String prepareWorld,
    String prepareStub,
    List<String> watches,
    boolean settles,
    boolean blocking,
    String call,
    String collect,
    boolean runOn,
    List<String> outputs) {

  static TestDriverView of(CppPlan plan) {
    boolean blocking = plan.plan().method().callType() != CallType.NONBLOCKING;
    return new TestDriverView(
        plan.namespace(),
        includes(plan),
        plan.called(),
        CppText.comment(plan.plan().modelName()),
        CppText.comment(plan.plan().description()),
        plan.component(),
        constructor(plan),
        plan.callHead(),
        CppText.list("return runtime::createComponent<Component>(", offered(plan), ");"),
        reads(plan),
        CppText.list(
            "simulationControl_.prepare(",
            plan.settings().stream().map(CppPlan.Setting::local).toList(),
            ");"),
        CppText.list(
            "testStub_.prepare(",
            plan.answers().stream().map(CppPlan.Answer::local).toList(),
            ");"),
        watches(plan),
        plan.isPeriodic() && plan.hasWorld(),
        blocking,
        call(plan),
        collect(plan),
        plan.runsOn(),
        plan.plan().outputs().stream().map(o -> output(plan, o)).toList());
  }

  private static String returned(CppPlan plan) {
    return plan.plan().returnsNothing() ? "" : "const " + plan.returnType() + " returned = ";
  }

  static String call(CppPlan plan) {
    List<String> arguments =
        Stream.concat(
                Stream.of("component"), plan.arguments().stream().map(CppPlan.Argument::local))
            .toList();
    return plan.plan().method().callType() != CallType.NONBLOCKING
        ? CppText.list(returned(plan) + plan.callName() + "(", arguments, ");")
        : CppText.list(
            "auto pending = callNonblocking(",
            List.of(
                "[&] { return " + plan.callName() + "(" + String.join(", ", arguments) + "); }"),
            ");");
  }

  static String collect(CppPlan plan) {
    return returned(plan) + "pending.outcome();";
  }

  static String constructor(CppPlan plan) {
    boolean suite = plan.plan().component().lifeCycle() == LifeCycle.SUITE;
    List<String> notHooks =
        Hooks.among(plan.plan().provided(), UnaryOperator.identity()).stream()
            .map(CppText::string)
            .toList();
    return CppText.constructor(
        "TestDriver::TestDriver(runtime::TestRun& run)",
        List.of(
            (plan.isSequence() ? "SequenceDriver" : "SuiteDriver")
                + "(run, runtime::LifeCycle::"
                + (suite ? "suite" : "perCase")
                + (notHooks.isEmpty() ? ")" : ", {" + String.join(", ", notHooks) + "})"),
            "simulationControl_(run)",
            "testStub_(run)"));
  }

  static List<String> includes(CppPlan plan) {
    List<DataType> types = new ArrayList<>();
    for (CppPlan call : plan.calls()) {
      types.add(call.plan().method().returnType());
      call.arguments().forEach(a -> types.add(a.parameter().type()));
      call.plan().outputs().stream()
          .filter(o -> o.source() instanceof Source.DataPort)
          .forEach(o -> types.add(o.type()));
    }
    plan.plan().watched().forEach(o -> types.add(o.type()));
    return new Includes()
        .standard("memory")
        .own(
            plan.header(),
            "SimulationControl.hpp",
            "TestStub.hpp",
            plan.isSequence()
                ? "sitaf/runtime/sequence_driver.hpp"
                : "sitaf/runtime/suite_driver.hpp")
        .types(types)
        .lines();
  }

  /** The objects that are passed to the component's constructor. */
  static List<String> offered(CppPlan plan) {
    List<String> offered = new ArrayList<>();
    if (plan.hasWorld()) {
      offered.add("*run().hardware()");
    }
    plan.stubs().forEach(s -> offered.add("testStub_." + s.name() + "()"));
    return offered;
  }

  static List<String> reads(CppPlan plan) {
    List<String> reads = new ArrayList<>();
    for (CppPlan.Argument argument : plan.arguments()) {
      String type = CppType.of(argument.parameter().type());
      if (argument.isConstant()) {
        reads.add(read("const auto " + argument.local(), type, argument.argument().name()));
      } else {
        reads.add(type + " " + argument.local() + "{};");
        sizes(argument).forEach((path, size) -> reads.add(path + ".resize(" + size + ");"));
        for (HarnessPlan.Given given : argument.argument().given()) {
          reads.add(
              read(
                  path(argument.local(), given.path(), false),
                  CppType.of(given.type()),
                  given.column()));
        }
      }
    }
    plan.settings()
        .forEach(s -> reads.add(read("const auto " + s.local(), "double", s.setting().name())));
    for (CppPlan.Answer answer : plan.answers()) {
      reads.add(
          CppText.assignment(
              "const auto " + answer.local(),
              "runtime::answer<"
                  + plan.typeOf(answer)
                  + ">(testCase, "
                  + CppText.string(answer.answer().column())
                  + ")"));
    }
    return reads;
  }

  private static String read(String left, String type, String column) {
    return CppText.assignment(left, "testCase.value<" + type + ">(" + CppText.string(column) + ")");
  }

  /** The required length of each sequence whose elements are set individually, outer ones first. */
  private static Map<String, Integer> sizes(CppPlan.Argument argument) {
    Map<String, Integer> sizes = new LinkedHashMap<>();
    for (HarnessPlan.Given given : argument.argument().given()) {
      DataType type = argument.parameter().type();
      String path = argument.local();
      for (Step step : given.path()) {
        if (step instanceof Step.Element element) {
          if (type instanceof DataType.Sequence sequence) {
            sizes.merge(path, element.index() + 1, Math::max);
            type = sequence.element();
          } else if (type instanceof DataType.FixedArray array) {
            type = array.element();
          }
          path += "[" + element.index() + "]";
        } else if (step instanceof Step.Member member && type instanceof DataType.Struct struct) {
          type =
              struct.members().stream()
                  .filter(m -> m.name().equals(member.name()))
                  .findFirst()
                  .orElseThrow()
                  .type();
          path += "." + CppNames.DECLARED.member(member.name());
        }
      }
    }
    return sizes;
  }

  /** The expression of a part of a value, optionally with bounds checks. */
  private static String path(String root, List<Step> steps, boolean checked) {
    StringBuilder path = new StringBuilder(root);
    for (Step step : steps) {
      if (step instanceof Step.Member member) {
        path.append('.').append(CppNames.DECLARED.member(member.name()));
      } else if (step instanceof Step.Element element) {
        path.append(checked ? ".at(" : "[").append(element.index()).append(checked ? ")" : "]");
      }
    }
    return path.toString();
  }

  /** Records the output data ports that trajectory conditions use. */
  static List<String> watches(CppPlan plan) {
    return plan.plan().watched().stream()
        .map(
            port ->
                CppText.list(
                    "watch(",
                    List.of(
                        CppText.string(port.name()),
                        "[&component] { return "
                            + path(expression(plan, port.source()), port.source().path(), true)
                            + "; }"),
                    ");"))
        .toList();
  }

  static String output(CppPlan plan, Output output) {
    String name = CppText.string(output.name());
    if (output.type().isVoid()) {
      return CppText.list("result.recordReturn(", List.of(name), ");");
    }
    List<Step> path = output.source().path();
    String value = path(expression(plan, output.source()), path, true);
    return path.stream().anyMatch(Step.Element.class::isInstance)
        ? CppText.list("result.recordPart(", List.of(name, "[&] { return " + value + "; }"), ");")
        : CppText.list("result.record(", List.of(name, value), ");");
  }

  private static String expression(CppPlan plan, Source source) {
    if (source instanceof Source.OutParameter out) {
      return plan.arguments().stream()
          .filter(a -> a.argument().name().equals(out.parameter()))
          .findFirst()
          .orElseThrow()
          .local();
    }
    if (source instanceof Source.Observation observation) {
      return "simulationControl_.observe(" + CppText.string(observation.name()) + ")";
    }
    if (source instanceof Source.DataPort port) {
      return "runtime::dataPort(component, SITAF_METHOD("
          + port.port()
          + "), SITAF_METHOD(get"
          + Words.raised(port.port())
          + "), SITAF_MEMBER("
          + port.port()
          + "))";
    }
    return "returned";
  }
}
