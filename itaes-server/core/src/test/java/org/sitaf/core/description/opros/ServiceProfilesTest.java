package org.sitaf.core.description.opros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;

class ServiceProfilesTest {
  private static ImportResult describe(byte[] document) {
    Map<String, byte[]> files = Map.of("service.xml", document);
    return InterfaceFiles.read(SourceFiles.of("test", files, List.of("service.xml")));
  }

  private static List<InterfaceDescription> read(String document) {
    return describe(document.getBytes(StandardCharsets.UTF_8)).orThrow().provided();
  }

  @Test
  void sortsParametersByIndex() {
    List<InterfaceDescription> interfaces =
        read(
            """
            <service_port_type_profile><service_port_type>
              <type_name>S</type_name>
              <method name="Get" return_type="double">
                <param index="2"><type>int</type><name>b</name></param>
                <param index="1"><name>a</name><type>const std::vector&lt; valarray&lt;double> >&amp;</type></param>
                <param index="3"><name>c</name><type>double&amp;</type></param>
              </method>
            </service_port_type></service_port_type_profile>
            """);
    Method get = interfaces.get(0).methods().get(0);
    assertThat(get.parameters()).extracting(Parameter::name).containsExactly("a", "b", "c");
    assertThat(get.signature()).isEqualTo("sequence<sequence<double>>,int32,double");
    assertThat(get.parameters())
        .extracting(Parameter::direction)
        .containsExactly(Direction.IN, Direction.IN, Direction.INOUT);
  }

  @Test
  void usesTheDeclaredEncoding() {
    byte[] document =
        """
        <?xml version="1.0" encoding="euc-kr"?>
        <!-- 거리 센서 -->
        <service_port_type><type_name>S</type_name><method name="Get" return_type="int"/></service_port_type>
        """
            .stripLeading()
            .getBytes(Charset.forName("euc-kr"));
    assertThat(describe(document).orThrow().provided().get(0).name()).isEqualTo("S");
  }

  @Test
  void keepsTheNameOfAnUnknownTypeAndReportsIt() {
    ImportResult result =
        describe(
            "<service_port_type><type_name>S</type_name>\n<method name='Get' return_type='Pose2D'/></service_port_type>"
                .getBytes(StandardCharsets.UTF_8));
    assertThat(result.provided().get(0).methods().get(0).returnType())
        .isEqualTo(new DataType.Unknown("Pose2D"));
    assertThat(result.diagnostics()).extracting(Diagnostic::line).containsExactly(2);
  }

  @Test
  void rejectsNamesThatAreNotIdentifiers() {
    assertThatThrownBy(
            () ->
                read(
                    "<service_port_type><type_name>S</type_name>\n"
                        + "<method name='Get(); evil' return_type='int'/></service_port_type>"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("service.xml:2: error: method: 'Get(); evil' is not a name");
  }

  @Test
  void importsRealServiceProfiles() throws IOException {
    Path profiles = Path.of("../../../shared/opros-profiles");
    Assumptions.assumeTrue(Files.isDirectory(profiles), "needs ../shared next to the checkout");
    int services = 0;
    try (Stream<Path> files = Files.walk(profiles)) {
      for (Path file : files.filter(f -> f.toString().endsWith(".xml")).toList()) {
        String text = Files.readString(file, StandardCharsets.ISO_8859_1);
        if (text.contains("<service_port_type")) {
          assertThat(describe(Files.readAllBytes(file)).orThrow().provided()).isNotEmpty();
          services++;
        }
      }
    }
    assertThat(services).isGreaterThan(3);
  }
}
