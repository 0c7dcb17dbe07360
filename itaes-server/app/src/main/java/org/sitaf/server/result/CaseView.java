package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Verdict;

/** A case of a result in the REST interface. */
@Schema(name = "ResultCase")
public record CaseView(
    @Schema(description = "from 1") int no,
    @Schema(description = "in the order of the result's parameters") List<String> values,
    @Schema(description = "by name of the output") Map<String, String> expected,
    @Schema(description = "by name of the output") Map<String, String> actual,
    Verdict verdict,
    @Schema(description = "time of the component, in microseconds")
        @Nullable Double processingTimeUs,
    @Schema(description = "time spent in virtual hardware, in microseconds")
        @Nullable Double hardwareUs,
    @Schema(description = "time spent in stubs, in microseconds") @Nullable Double stubUs,
    @Schema(description = "why the verdict is not PASS") @Nullable String message) {
  public static CaseView of(CaseResult result) {
    CaseResult.ProcessingTime time = result.time();
    return new CaseView(
        result.no(),
        result.values(),
        byOutput(result.expected()),
        byOutput(result.actual()),
        result.verdict(),
        time == null ? null : time.total(),
        time == null ? null : time.hardware(),
        time == null ? null : time.stub(),
        result.message().isEmpty() ? null : result.message());
  }

  private static Map<String, String> byOutput(List<NamedValue> values) {
    Map<String, String> byName = new LinkedHashMap<>();
    values.forEach(
        v ->
            byName.put(v.output().isEmpty() ? OutputElement.RETURN_NAME : v.output(), v.literal()));
    return byName;
  }
}
