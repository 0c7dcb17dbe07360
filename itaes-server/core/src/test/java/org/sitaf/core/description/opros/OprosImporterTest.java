package org.sitaf.core.description.opros;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.Charset;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.importer.InterfaceText;
import org.sitaf.core.description.source.ComponentDescription;
import org.sitaf.core.description.source.ComponentDescription.Execution;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;

class OprosImporterTest {
  private static final String SERVICE =
      """
      <service_port_type>
        <type_name>Drive</type_name>
        <method name="Go" return_type="bool">
          <param index="1"><name>to</name>
            <type>Pose</type></param>
        </method>
      </service_port_type>
      """;

  private static final String TYPES =
      """
      <data_type><struct name="Pose">
        <item type="double">x</item>
        <item type="vector&lt;Point&gt;">path</item>
      </struct></data_type>
      """;

  private static String component(String ports) {
    return """
    <component_profile>
    <name>Mover</name>
    <execution_semantics><type>periodic</type><period>50</period></execution_semantics>
    <ports>
    %s
    </ports>
    </component_profile>
    """
        .formatted(ports);
  }

  private static String service(String usage, String reference) {
    return "<service_port><name>drive</name><type>Drive</type>\n<usage>"
        + usage
        + "</usage>\n<reference>"
        + reference
        + "</reference></service_port>";
  }

  @Test
  void followsReferencesOfAProfileToInterfaceAndTypes() {
    ImportResult result =
        InterfaceText.read(
            Map.of(
                "c/Mover.xml", component(service("provided", "Drive.xml")),
                "c/Drive.xml", SERVICE,
                "types/Pose.xml", TYPES),
            "c/Mover.xml");
    ComponentDescription component = result.components().get(0);
    assertThat(component.execution()).isEqualTo(new Execution.Periodic(50));
    assertThat(component.ports())
        .containsExactly(new Port.Service("drive", "Drive", true, "c/Drive.xml"));
    assertThat(result.provided()).extracting(InterfaceDescription::name).containsExactly("Drive");
    assertThat(InterfaceText.prototypes(result.provided().get(0)))
        .containsExactly("boolean Go(IN Pose to)");
    assertThat(InterfaceText.lines(result))
        .containsExactly("types/Pose.xml:3: warning: struct Pose/item path: unknown type 'Point'");
  }

  @Test
  void aRequiredInterfaceIsNotProvided() {
    ImportResult result =
        InterfaceText.readAll(
            Map.of("Mover.xml", component(service("required", "Drive.xml")), "Drive.xml", SERVICE));
    assertThat(result.provided()).isEmpty();
    assertThat(result.required()).extracting(InterfaceDescription::name).containsExactly("Drive");
  }

  @Test
  void reportsADanglingReferenceWithItsLine() {
    ImportResult result =
        InterfaceText.read("Mover.xml", component(service("provided", "Drive.xml")));
    assertThat(InterfaceText.lines(result))
        .containsExactly(
            "Mover.xml:7: error: service_port drive: references 'Drive.xml', which is not among the"
                + " given files; add it or correct the reference");
    assertThat(result.components()).hasSize(1);
  }

  @Test
  void reportsTheInterfaceThatAReferencedFileContainsInstead() {
    ImportResult result =
        InterfaceText.read(
            Map.of(
                "Mover.xml", component(service("provided", "Drive.xml")),
                "Drive.xml", SERVICE.replace(">Drive<", ">Steer<")),
            "Mover.xml");
    assertThat(InterfaceText.lines(result))
        .anyMatch(
            l ->
                l.contains(
                    "'Drive.xml' does not define service_port_type Drive; it defines [Steer]"));
  }

  @Test
  void reportsAllProblemsOfAProfileWithTheirLines() {
    ImportResult result =
        InterfaceText.read(
            "Mover.xml",
            """
            <component_profile>
            <name>Mover</name>
            <execution_semantics><type>periodic</type>
              <period>often</period></execution_semantics>
            <ports>
              <data_port><name>out</name>
                <data_type>vector&lt;int</data_type>
                <usage>sideways</usage></data_port>
              <service_port><name>drive</name><usage>provided</usage></service_port>
            </ports>
            </component_profile>
            """);
    assertThat(InterfaceText.lines(result))
        .containsExactly(
            "Mover.xml:4: error: execution_semantics/period: must be a whole number of milliseconds"
                + " greater than 0, not 'often'",
            "Mover.xml:8: error: data_port out: usage must be output or input, not 'sideways'",
            "Mover.xml:7: warning: data_port out: unknown type 'vector<int'",
            "Mover.xml:9: error: service_port drive: has no <type>; write the type_name of its"
                + " interface");
  }

  @Test
  void anAsteriskBeforeANameBelongsToTheType() {
    ImportResult result =
        InterfaceText.read(
            "Drive.xml", SERVICE.replace("<name>to", "<name>*to").replace("Pose", "double"));
    assertThat(InterfaceText.prototypes(result.provided().get(0)))
        .containsExactly("boolean Go(INOUT double to)");
    assertThat(InterfaceText.lines(result))
        .containsExactly(
            "Drive.xml:4: warning: method Go/param to: '*' belongs to the type and is read as part"
                + " of it");
  }

  @Test
  void keepsTheNameOfAStructInsideItself() {
    ImportResult result =
        InterfaceText.readAll(
            Map.of("Types.xml", TYPES.replace("Point", "Pose"), "Drive.xml", SERVICE));
    assertThat(InterfaceText.lines(result))
        .containsExactly(
            "Types.xml:3: warning: struct Pose/item path: type 'Pose' is not supported: part of"
                + " itself");
    assertThat(result.types()).hasSize(1);
  }

  @Test
  void usesTheDeclaredEncoding() {
    byte[] profile =
        ("<?xml version=\"1.0\" encoding=\"euc-kr\"?>"
                + component("")
                    .replace("<name>Mover", "<description>이동 로봇</description><name>Mover"))
            .getBytes(Charset.forName("euc-kr"));
    ImportResult result =
        InterfaceFiles.read(
            SourceFiles.of("test", Map.of("Mover.xml", profile), List.of("Mover.xml")));
    assertThat(result.components().get(0).description()).isEqualTo("이동 로봇");
  }
}
