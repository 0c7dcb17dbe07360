package org.sitaf.core.explain.report;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import org.sitaf.core.digest.Sha256;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;

/**
 * What an execution of a single case gave, and what may change it: the component, the simulator,
 * the machine.
 *
 * @param entries by name, in a fixed order
 */
public record RunRecord(Map<String, String> entries) {
  public RunRecord {
    entries = Collections.unmodifiableMap(new LinkedHashMap<>(entries));
  }

  public static final String VERDICT = "verdict";
  public static final String DIGEST = "digest";
  public static final String MESSAGE = "message";

  /** The record of a result with one case. */
  public static RunRecord of(TestResult result) {
    CaseResult only = result.cases().get(0);
    Map<String, String> entries = new LinkedHashMap<>();
    entries.put(VERDICT, only.verdict().name());
    entries.put(MESSAGE, only.message());
    entries.put(DIGEST, digest(only));
    entries.put("component", result.provenance().component());
    entries.put("harness", result.provenance().harness());
    entries.put("simulator", result.provenance().bridge());
    entries.put("compiler", result.provenance().compiler());
    entries.put(
        "packages",
        result.provenance().packages().stream()
            .map(each -> each.name() + " " + each.version())
            .collect(Collectors.joining(", ")));
    entries.put(
        "machine",
        System.getProperty("os.name")
            + ", "
            + System.getProperty("os.arch")
            + ", Java "
            + System.getProperty("java.version"));
    return new RunRecord(entries);
  }

  /** Covers the verdict, the outputs and the calls, not the times. */
  private static String digest(CaseResult result) {
    String text =
        result.verdict()
            + "\n"
            + result.values()
            + "\n"
            + result.actual()
            + "\n"
            + result.calls()
            + "\n"
            + result.trajectories();
    return Sha256.hex(text.getBytes(UTF_8));
  }
}
