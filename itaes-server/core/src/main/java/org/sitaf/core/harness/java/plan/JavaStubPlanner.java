package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sitaf.core.description.Direction;
import org.sitaf.core.harness.java.plan.JavaPlan.Interface;
import org.sitaf.core.harness.java.plan.JavaPlan.JavaParameter;
import org.sitaf.core.harness.java.plan.JavaPlan.Signature;
import org.sitaf.core.harness.java.plan.JavaPlan.Stub;
import org.sitaf.core.harness.java.plan.JavaPlan.StubMethod;
import org.sitaf.core.harness.java.plan.JavaPlan.StubOut;
import org.sitaf.core.harness.plan.HarnessPlan;

/** Plans the test stub: a field for each method and each out-parameter. */
final class JavaStubPlanner {
  private final List<HarnessPlan.Stub> stubs;
  private final JavaNames names;

  JavaStubPlanner(List<HarnessPlan.Stub> stubs, JavaNames names) {
    this.stubs = stubs;
    this.names = names;
  }

  List<Stub> plan(List<Interface> interfaces) {
    List<Stub> planned = new ArrayList<>();
    for (HarnessPlan.Stub stub : stubs) {
      Optional<Interface> signatures =
          interfaces.stream().filter(i -> i.name().equals(stub.name())).findFirst();
      if (signatures.isPresent() && signatures.get().methods().size() == stub.methods().size()) {
        String field = names.local(stub.name());
        List<StubMethod> methods = new ArrayList<>();
        for (int i = 0; i < stub.methods().size(); i++) {
          methods.add(method(stub, stub.methods().get(i), signatures.get().methods().get(i)));
        }
        planned.add(new Stub(stub.name(), field, methods));
      }
    }
    return planned;
  }

  private StubMethod method(
      HarnessPlan.Stub stub, HarnessPlan.StubMethod method, Signature signature) {
    String fullName = stub.name() + "." + method.method().name();
    List<StubOut> outs = new ArrayList<>();
    for (JavaParameter parameter : signature.parameters()) {
      if (parameter.direction() != Direction.IN) {
        String outName = fullName + "." + parameter.name();
        boolean answered =
            method.answers().stream()
                .anyMatch(
                    a -> a.parameter() != null && a.parameter().name().equals(parameter.name()));
        outs.add(new StubOut(parameter, names.local(outName), outName, answered));
      }
    }
    return new StubMethod(
        signature,
        names.local(fullName),
        fullName,
        method.answers().stream().anyMatch(a -> a.parameter() == null),
        outs);
  }
}
