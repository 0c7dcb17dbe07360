package org.sitaf.server.git.bisection;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;

/** A request to find the first bad commit. */
@Schema(name = "GitBisectionRequest")
record BisectionRequest(
    @Schema(description = "a bad commit of the branch that has results: 40 hexadecimal digits")
        String commit,
    @Schema(description = "default: all models") @Nullable String model,
    @Schema(description = "number of a case of this commit; needs model; default: all cases")
        @Nullable Integer caseNo,
    @Schema(
            description =
                "whether a commit is bad if values differ, even if cases fail newly; default: only"
                    + " if none does")
        @Nullable Boolean values,
    @Schema(
            description =
                "an output, signal or called method whose values differ; default: all; includes"
                    + " values")
        @Nullable String output) {
  private static final Pattern SHA = Pattern.compile("[0-9a-f]{40}");

  String checkedCommit() {
    if (commit == null || !SHA.matcher(commit).matches()) {
      throw RequestException.malformed(
          "commit: must be the id of a commit, 40 lower-case hexadecimal digits.");
    }
    return commit;
  }

  @Nullable Integer checkedCase() {
    if (caseNo != null && caseNo < 1) {
      throw RequestException.malformed("caseNo: must be 1 or more.");
    }
    if (caseNo != null && model == null) {
      throw RequestException.malformed("caseNo: needs model, since each model has its own cases.");
    }
    return caseNo;
  }

  boolean wantsValues() {
    return output != null || Boolean.TRUE.equals(values);
  }

  /** Whether everything counts that came with the bad commit. */
  boolean isWhole() {
    return model == null && caseNo == null && output == null && !wantsValues();
  }
}
