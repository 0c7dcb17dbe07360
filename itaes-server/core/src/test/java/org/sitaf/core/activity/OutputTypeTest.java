package org.sitaf.core.activity;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;

/** Types by which the outputs of a model are compared. */
class OutputTypeTest {
  private final Activity activity = activity();

  private DataType type(String output) {
    return activity.outputType(activity.models().get(0), output);
  }

  @Test
  void aWholeSequenceHasTheTypeOfTheInterfaceEvenIfTheModelNamesItsElements() {
    assertThat(type("return")).isInstanceOf(DataType.Sequence.class);
  }

  @Test
  void anElementHasTheTypeOfTheElements() {
    assertThat(type("return[0]")).isEqualTo(new DataType.Scalar(ScalarType.DOUBLE));
  }

  @Test
  void anOutputThatNobodyDeclaresHasNoType() {
    assertThat(type("nothing")).isInstanceOf(DataType.Unknown.class);
  }

  private static Activity activity() {
    Map<String, String> files =
        Map.of(
            "activity.yaml",
            """
            name: arm
            component: {language: java, sources: component/, class: robot.Arm}
            provided: [arm.idl]
            models: [model.xml]
            """,
            "arm.idl",
            "interface Arm { sequence<double> Reach(in double speed); };",
            "model.xml",
            """
            <test_model><name>Reach</name>
              <input_spec_list>
                <test_element abstract_type="NUMERIC" real_type="double"><name>speed</name><type>TDI</type>
                  <user_value_list><value>1</value></user_value_list></test_element>
              </input_spec_list>
              <output_spec_list>
                <test_element abstract_type="SEQUENCE" real_type="double"><name>return</name><type>RETURN</type></test_element>
              </output_spec_list>
              <order_of_combinations>1</order_of_combinations>
            </test_model>
            """);
    return Activity.readWithoutComponent(
        FileTree.of(
            files.entrySet().stream()
                .collect(
                    Collectors.toMap(
                        Map.Entry::getKey, e -> e.getValue().getBytes(StandardCharsets.UTF_8)))));
  }
}
