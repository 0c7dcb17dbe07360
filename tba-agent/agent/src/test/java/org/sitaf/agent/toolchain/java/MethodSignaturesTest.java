package org.sitaf.agent.toolchain.java;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.toolchain.debug.DebugOrder;

class MethodSignaturesTest {
  /** A component whose method under test is overloaded and partly inherited. */
  @SuppressWarnings("unused")
  abstract static class Base<T> {
    abstract double measure(T unit);

    String[][] measure(int[] indices, List<String> names, byte kind) {
      return new String[0][0];
    }
  }

  static final class Sensor extends Base<String> {
    @Override
    double measure(String unit) {
      return 0;
    }
  }

  private static List<String> signatures(String className, String... methods) throws Exception {
    Path classes =
        Path.of(
            MethodSignaturesTest.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    DebugOrder order =
        new DebugOrder(Path.of("."), className, List.of(methods), true, debuggee -> {});
    return MethodSignatures.of(order, List.of(classes));
  }

  @Test
  void overloadedAndInheritedMethodsAreFoundInTheClassThatDeclaresThem() throws Exception {
    String outer = MethodSignaturesTest.class.getName();
    assertThat(signatures(outer + "$Sensor", "measure"))
        .contains(
            outer + "$Sensor.measure(java.lang.String)",
            outer + "$Base.measure(int[],java.util.List,byte)")
        .noneMatch(signature -> signature.equals(outer + "$Base.measure(java.lang.Object)"));
  }

  @Test
  void aClassThatCannotBeReadGivesThePlainName() throws Exception {
    assertThat(signatures("missing.Sensor", "measure")).containsExactly("missing.Sensor.measure");
  }
}
