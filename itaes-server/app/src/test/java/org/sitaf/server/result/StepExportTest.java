package org.sitaf.server.result;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.sitaf.core.verdict.TestResult;

class StepExportTest {
  private static final String DOCUMENT =
      """
      <test_result_descriptor><name>LifeCycle</name>
        <provenance suite="" seed="1" harness="" component="" agent="a" bridge="b" started="s" finished="f"/>
        <summary total="2" pass="0" fail="1" error="1" dont="0"/>
        <case_param_info><param name="Distance" type="TDSD" real_type="double"/></case_param_info>
        <test_result_list>
          <test_result no="1" verdict="FAIL"><value>5.0</value>
            <step name="Enable" verdict="PASS" before="on=false" after="on=true" at="0"/>
            <step name="Read" class="forbidden" verdict="FAIL" before="on=true" after="on=true" at="0.1">
              <value name="Index">1</value><expected>0.6</expected><actual>0.5</actual>
              <message>expected &lt;b&gt;0.6, but was 0.5</message></step>
            <step name="Enable" verdict="FAIL" after_failure="true" before="on=true" after="on=true" at="0.2"/>
            <message>step 2 (Read, forbidden): expected 0.6, but was 0.5</message></test_result>
          <test_result no="2" verdict="ERROR"><value>5.0</value>
            <step name="Enable" verdict="DONT"/>
            <message>before the first step: no such port</message></test_result>
        </test_result_list>
      </test_result_descriptor>
      """;

  private static final String CASE = "\"step 2 (Read, forbidden): expected 0.6, but was 0.5\"";

  private final TestResult result = Results.read(DOCUMENT.getBytes(StandardCharsets.UTF_8));

  @Test
  void a_csv_has_a_line_for_each_step() {
    String[] lines = new String(ResultCsv.write(result), StandardCharsets.UTF_8).split("\r\n");
    assertThat(lines)
        .containsExactly(
            "no,case verdict,Distance,step,name,class,Read.Index,expected,actual,verdict,"
                + "after_failure,at_s,time_us,before,after,message,case message",
            "1,FAIL,5.0,1,Enable,valid,,,,PASS,false,0.0,,on=false,on=true,," + CASE,
            "1,FAIL,5.0,2,Read,forbidden,1,0.6,0.5,FAIL,false,0.1,,on=true,on=true,"
                + "\"expected <b>0.6, but was 0.5\","
                + CASE,
            "1,FAIL,5.0,3,Enable,valid,,,,FAIL,true,0.2,,on=true,on=true,," + CASE,
            "2,ERROR,5.0,1,Enable,valid,,,,DONT,false,,,,,,before the first step: no such port");
  }

  @Test
  void a_report_shows_the_steps_and_marks_the_first_failure() {
    String report = new String(ResultReport.write("ir", result), StandardCharsets.UTF_8);
    assertThat(report)
        .contains("<details open><summary>Steps: <bdi>Enable Read Enable</bdi></summary>")
        .contains("<tr class=\"FAIL decides\"><td>2</td>")
        .contains("<bdi>Read(Index&#x3D;1)</bdi></td><td>forbidden</td>")
        .contains("<td>after a failure</td>")
        .contains("expected &lt;b&gt;0.6")
        .doesNotContain("<b>");
    assertThat(report).doesNotContain("DONT decides");
    assertThat(report.split("FAIL decides", -1)).hasSize(2);
  }

  @Test
  void the_rest_interface_names_inputs_and_states() {
    CaseView.StepView step = CaseView.of(result.cases().get(0)).steps().get(1);
    assertThat(step.inputs()).containsEntry("Index", "1");
    assertThat(step.expected()).containsEntry("return", "0.6");
    assertThat(step.before()).isEqualTo("on=true");
    assertThat(step.kind()).hasToString("FORBIDDEN");
  }
}
