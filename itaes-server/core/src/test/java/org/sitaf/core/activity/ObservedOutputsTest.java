package org.sitaf.core.activity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;

/** Data ports as outputs, and outputs of methods without a return value. */
class ObservedOutputsTest {
  private final Map<String, String> files =
      new HashMap<>(
          Map.of(
              "activity.yaml",
              """
              name: arm
              component:
                language: java
                sources: component/
                class: robot.Arm
                profile: arm.xml
              provided: [service.xml]
              models: [Limit.xml]
              """,
              "service.xml",
              """
              <service_port_type>
                <type_name>ArmService</type_name>
                <method name="Limit" return_type="void">
                  <param index="1"><name>most</name><type>double</type></param>
                </method>
              </service_port_type>
              """,
              "arm.xml",
              """
              <component_profile>
                <name>Arm</name>
                <ports>
                  <data_port><name>state</name><data_type>ArmState</data_type><usage>output</usage>
                    <reference>state.xml</reference></data_port>
                  <data_port><name>command</name><data_type>double</data_type><usage>input</usage></data_port>
                </ports>
              </component_profile>
              """,
              "state.xml",
              """
              <data_type>
                <struct name="ArmState"><item type="double">angle</item><item type="int">swings</item></struct>
              </data_type>
              """,
              "Limit.xml",
              """
              <test_model><name>Limit</name>
                <input_spec_list>
                  <test_element abstract_type="NUMERIC" real_type="double"><name>most</name><type>TDI</type>
                    <user_value_list><value>4</value><value>9</value></user_value_list></test_element>
                </input_spec_list>
                <output_spec_list>
                  <test_element abstract_type="VOID" real_type="void"><name>return</name><type>RETURN</type>
                    <expected>most &gt; 8 ? "!error:TooStrong" : null</expected></test_element>
                  <test_element abstract_type="NUMERIC" real_type="int"><name>state.swings</name>
                    <type>OBSERVED</type><expected>0</expected></test_element>
                </output_spec_list>
                <order_of_combinations>1</order_of_combinations>
              </test_model>
              """,
              "component/robot/Arm.java",
              "package robot; public class Arm {}"));

  private Activity read() {
    Map<String, byte[]> bytes = new HashMap<>();
    files.forEach((path, text) -> bytes.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return Activity.read(FileTree.of(bytes));
  }

  private List<String> problems() {
    return catchThrowableOfType(InvalidInputException.class, this::read).diagnostics().stream()
        .map(Diagnostic::toString)
        .toList();
  }

  private void replace(String path, String from, String to) {
    assertThat(files.get(path)).contains(from);
    files.put(path, files.get(path).replace(from, to));
  }

  private static List<String> expected(TestSuite suite, String output) {
    return suite.cases().stream()
        .flatMap(c -> c.expected().stream())
        .filter(e -> e.output().equals(output))
        .map(ExpectedValue::literal)
        .toList();
  }

  @Test
  void aVoidMethodIsExpectedToReturnOrToThrow() {
    TestSuite suite =
        TestCaseGenerator.generate(read().models().get(0), GenerationOptions.DEFAULT).suite();
    assertThat(expected(suite, "return")).containsExactly("null", "!error:TooStrong");
    assertThat(expected(suite, "state.swings")).containsExactly("0", "0");
  }

  @Test
  void onlyAnErrorCanBeExpectedOfAVoidMethod() {
    replace("Limit.xml", ": null", ": 3");
    assertThat(problems())
        .singleElement()
        .asString()
        .contains("the method returns nothing; expect null, or an error");
  }

  @Test
  void aVoidMethodHasNoOtherReturnType() {
    replace(
        "Limit.xml",
        "abstract_type=\"VOID\" real_type=\"void\"",
        "abstract_type=\"NUMERIC\" real_type=\"int\"");
    assertThat(problems())
        .singleElement()
        .asString()
        .contains("Limit returns nothing; use an element named return with abstract_type VOID");
  }

  @Test
  void anOtherMethodDoesNotReturnVoid() {
    replace("service.xml", "return_type=\"void\"", "return_type=\"double\"");
    assertThat(problems()).singleElement().asString().contains("does not match the interface");
  }

  @Test
  void observesOutputDataPortsOnly() {
    replace("Limit.xml", "<name>state.swings</name>", "<name>command</name>");
    assertThat(problems())
        .singleElement()
        .asString()
        .contains("nor one of the output data ports [state]");
    replace("Limit.xml", "<name>command</name>", "<name>state.speed</name>");
    assertThat(problems())
        .singleElement()
        .asString()
        .contains("ArmState has no member 'speed'; it has ");
  }

  @Test
  void warnsOfAnUnreadableProfile() {
    replace("arm.xml", "<usage>input</usage>", "<usage>sideways</usage>");
    assertThat(read().warnings()).anyMatch(w -> w.toString().contains("sideways"));
  }
}
