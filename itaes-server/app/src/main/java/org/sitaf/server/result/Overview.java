package org.sitaf.server.result;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.RelationCount;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;

/**
 * A result without its cases, as stored in the database.
 *
 * @param suspicions null in results of earlier releases
 * @param relations null in results of earlier releases
 */
record Overview(
    String name,
    Provenance provenance,
    Summary summary,
    List<CaseParameter> parameters,
    @Nullable List<String> suspicions,
    @Nullable List<RelationCount> relations) {
  static Overview of(TestResult result) {
    return new Overview(
        result.name(),
        result.provenance(),
        result.summary(),
        result.parameters(),
        result.suspicions(),
        RelationCount.of(result.cases()));
  }
}
