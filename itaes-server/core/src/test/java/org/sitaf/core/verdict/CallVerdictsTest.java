package org.sitaf.core.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.document.TestModelXml;

class CallVerdictsTest {
  @Test
  void theVariablesOfACaseAreComputedOnceForAllPostConditions() {
    String model =
        """
        <test_model><name>M</name><input_spec_list/><output_spec_list/>
        <post_condition_spec_list>
          <post_condition>actual &gt; 0</post_condition><post_condition>actual &gt; 1</post_condition>
          <post_condition>actual &gt; 2</post_condition>
        </post_condition_spec_list><order_of_combinations>1</order_of_combinations></test_model>
        """;
    CallVerdicts verdicts =
        new CallVerdicts(
            TestModelXml.read(
                new ByteArrayInputStream(model.getBytes(StandardCharsets.UTF_8)), "M.xml"),
            new CallRecord(List.of()),
            1);
    AtomicInteger computed = new AtomicInteger();
    CaseResult judged =
        verdicts.withPostConditions(
            new CaseResult(
                1, Verdict.PASS, List.of(), List.of(), List.of(), StubCalls.NONE, null, ""),
            () -> {
              computed.incrementAndGet();
              return Map.of("actual", 2L);
            });
    assertThat(judged.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(judged.message()).isEqualTo("post-condition violated: actual > 2: 2 > 2");
    assertThat(computed).hasValue(1);
  }
}
