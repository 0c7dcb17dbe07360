package org.sitaf.runtime.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SuiteReaderTest {
  private static final String HEAD =
      """
      <test_suite_data><name>s</name><case_param_info>
        <param name="Index" type="TDI" real_type="int"/><param name="Distance" type="TDSD" real_type="double"/>
      </case_param_info>\
      """;

  @TempDir Path folder;

  private List<TestCase> read(String document) throws IOException {
    Path file = Files.write(folder.resolve("suite.xml"), document.getBytes(StandardCharsets.UTF_8));
    List<TestCase> cases = new ArrayList<>();
    try (SuiteReader reader = SuiteReader.open(file)) {
      Optional<TestCase> next = reader.next();
      while (next.isPresent()) {
        cases.add(next.get());
        next = reader.next();
      }
    }
    return cases;
  }

  @Test
  void readsTheStepsOfASequence() throws IOException {
    List<TestCase> cases =
        read(
            """
            <test_suite_data><name>s</name><case_param_info><param name="Distance"/></case_param_info>
              <step_param_info><step name="Read"><param name="Index"/></step><step name="Nears"/></step_param_info>
              <case_list><case no="4"><value>5.0</value>
                <step name="Read" class="invalid"><value>-1</value><expected>0</expected></step><step name="Nears"/>
              </case></case_list></test_suite_data>\
            """);
    assertThat(cases).hasSize(1);
    assertThat(cases.get(0).doubleValue("Distance")).isEqualTo(5.0);
    List<TestStep> steps = cases.get(0).steps();
    assertThat(steps.stream().map(TestStep::name)).containsExactly("Read", "Nears");
    assertThat(steps.stream().map(TestStep::number)).containsExactly(1, 2);
    assertThat(steps.get(0).no()).isEqualTo(4);
    assertThat(steps.get(0).valid()).isFalse();
    assertThat(steps.get(0).intValue("Index")).isEqualTo(-1);
    assertThat(steps.get(1).valid()).isTrue();
  }

  @Test
  void rejectsAStepWithoutAllOfItsValues() {
    assertThatThrownBy(
            () ->
                read(
                    """
                    <test_suite_data><step_param_info><step name="Read"><param name="Index"/></step></step_param_info>
                    <case_list><case no="4"><step name="Read"/></case></case_list></test_suite_data>\
                    """))
        .isInstanceOf(CaseDataException.class)
        .hasMessageContaining("step 1 (Read) of case 4 has 0 values for 1 parameters");
  }

  @Test
  void readsValuesByParameterName() throws IOException {
    List<TestCase> cases =
        read(
            HEAD
                + """
                <case_list>
                  <case no="3" class="valid"><value>7</value><value>9.5</value><expected>-1.0</expected></case>
                  <case no="9" class="invalid"><value>-8</value><value>NaN</value></case>
                </case_list></test_suite_data>\
                """);
    assertThat(cases).hasSize(2);
    assertThat(cases.get(0).no()).isEqualTo(3);
    assertThat(cases.get(0).valid()).isTrue();
    assertThat(cases.get(0).intValue("Index")).isEqualTo(7);
    assertThat(cases.get(0).doubleValue("Distance")).isEqualTo(9.5);
    assertThat(cases.get(1).no()).isEqualTo(9);
    assertThat(cases.get(1).valid()).isFalse();
    assertThat(cases.get(1).doubleValue("Distance")).isNaN();
  }

  @Test
  void reportsAValueThatTheTypeCannotHold() throws IOException {
    TestCase testCase =
        read(HEAD
                + "<case_list><case no='1'><value>300</value><value>five</value></case></case_list>"
                + "</test_suite_data>")
            .get(0);
    assertThatThrownBy(() -> testCase.byteValue("Index"))
        .isInstanceOf(CaseDataException.class)
        .hasMessage("Index: 300 is outside of -128 to 127");
    assertThatThrownBy(() -> testCase.doubleValue("Distance"))
        .hasMessage("Distance: 'five' is not a number");
    assertThatThrownBy(() -> testCase.intValue("Speed"))
        .hasMessageContaining("no parameter 'Speed'; it has [Index, Distance]");
  }

  @Test
  void rejectsADocumentTypeDeclaration() {
    String secret = "<!DOCTYPE t [<!ENTITY e SYSTEM 'file:///etc/hostname'>]>";
    assertThatThrownBy(
            () ->
                read(
                    secret
                        + HEAD
                        + "<case_list><case"
                        + " no='1'><value>&e;</value><value>1</value></case></case_list>"
                        + "</test_suite_data>"))
        .isInstanceOf(CaseDataException.class)
        .hasMessageContaining("a DTD or an entity is not allowed here");
  }

  @Test
  void rejectsMalformedDocumentsWithTheLine() {
    assertThatThrownBy(() -> read("<x/>")).hasMessageContaining("the root is <x>");
    assertThatThrownBy(() -> read(HEAD + "</test_suite_data>"))
        .hasMessageContaining("there is no <case_list>");
    assertThatThrownBy(
            () -> read(HEAD + "\n<case_list><case no='1'><value>1</value></case></case_list>"))
        .hasMessage("suite.xml:4: case 1 has 1 values for 2 parameters");
    assertThatThrownBy(() -> read(HEAD + "<case_list><case")).isInstanceOf(CaseDataException.class);
  }

  @Test
  void readsAheadWithoutSkippingCasesOrReportingErrorsEarly() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("suite.xml"),
            HEAD
                + "\n<case_list><case no='4'><value>1</value><value>2</value></case>"
                + "<case no='5'><value>1</value><value>2</value></case>"
                + "<case no='6'><value>1</value></case></case_list></test_suite_data>");
    try (SuiteReader reader = SuiteReader.open(file)) {
      assertThat(reader.upcoming(1)).extracting(TestCase::no).containsExactly(4);
      assertThat(reader.upcoming(10)).extracting(TestCase::no).containsExactly(4, 5);
      assertThat(reader.next()).map(TestCase::no).contains(4);
      assertThat(reader.upcoming(10)).extracting(TestCase::no).containsExactly(5);
      assertThat(reader.next()).map(TestCase::no).contains(5);
      assertThat(reader.upcoming(10)).isEmpty();
      assertThatThrownBy(reader::next).hasMessageContaining("case 6 has 1 values");
    }
  }

  @Test
  void readsTheElementsOfSequences() throws IOException {
    TestCase testCase =
        read(HEAD
                + "<case_list><case no='1'><value>[1, 2,"
                + " 3]</value><value>[]</value></case></case_list></test_suite_data>")
            .get(0);
    assertThat(testCase.intArray("Index")).containsExactly(1, 2, 3);
    assertThat(testCase.floatArray("Index")).containsExactly(1f, 2f, 3f);
    assertThat(testCase.doubleArray("Distance")).isEmpty();
  }
}
