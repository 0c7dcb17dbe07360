package org.sitaf.core.activity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;

class TargetMethodTest {
  private static Method method(String name, String... types) {
    List<Parameter> parameters =
        Arrays.stream(types)
            .map(t -> new Parameter("p", TypeGrammar.parse(t).type(), Direction.IN))
            .toList();
    return new Method(
        name, TypeGrammar.parse("void").type(), parameters, CallType.BLOCKING, List.of(), 0);
  }

  private final List<InterfaceDescription> provided =
      List.of(
          new InterfaceDescription(
              "Drive",
              List.of(
                  method("Move", "int", "int"),
                  method("Move", "double"),
                  method("Move", "sequence<double,8>", "int"),
                  method("Stop")),
              "drive.xml"),
          new InterfaceDescription("Arm", List.of(method("Stop")), "arm.xml"));

  private TargetMethod find(String target) {
    String xml =
        "<test_model><name>Stop</name>%s<input_spec_list/><order_of_combinations>1</order_of_combinations></test_model>"
            .formatted(target);
    TestModel model =
        TestModelXml.read(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "m.xml");
    return TargetMethod.find(model, provided);
  }

  @Test
  void findsAnOverloadByItsSignature() {
    assertThat(find("<target method='Move' signature='int,int'/>").method().parameters())
        .hasSize(2);
    assertThat(find("<target method='Move' signature='double'/>").method().parameters()).hasSize(1);
    assertThat(
            find("<target method='Move' signature='sequence&lt;double,8>, int'/>")
                .method()
                .signature())
        .startsWith("sequence<double,8>");
  }

  @Test
  void reportsSeveralMatchingMethods() {
    assertThatThrownBy(() -> find("<target method='Move'/>"))
        .hasMessageContaining("Drive.Move(int32,int32), Drive.Move(double)");
    assertThatThrownBy(() -> find(""))
        .hasMessageContaining("several methods match")
        .hasMessageContaining("Drive.Stop(), Arm.Stop()");
  }

  @Test
  void theInterfaceDistinguishesEqualMethods() {
    assertThat(find("<target interface='Arm' method='Stop'/>").declaring().name()).isEqualTo("Arm");
    assertThatThrownBy(() -> find("<target interface='Leg' method='Stop'/>"))
        .hasMessageContaining("no provided interface is named Leg");
  }
}
