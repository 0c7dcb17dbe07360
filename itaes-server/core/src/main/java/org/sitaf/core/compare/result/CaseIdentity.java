package org.sitaf.core.compare.result;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.TestResult;

/**
 * What makes cases of two results the same case: their values, and their steps with theirs. Their
 * numbers do not count, since a change of the model numbers the cases differently.
 */
public record CaseIdentity(List<List<String>> parts) {
  private static final int FINGERPRINT_BYTES = 16;

  public CaseIdentity {
    parts = parts.stream().map(List::copyOf).toList();
  }

  /** The identity of a case, among results with the same parameters. */
  static CaseIdentity of(CaseResult result) {
    if (result.steps().isEmpty()) {
      return new CaseIdentity(List.of(result.values()));
    }
    List<List<String>> parts = new ArrayList<>();
    parts.add(result.values());
    for (StepResult step : result.steps()) {
      parts.add(List.of(step.name()));
      parts.add(step.values());
    }
    return new CaseIdentity(parts);
  }

  /**
   * The fingerprints of the cases of a result, in their order. Cases of two results have the same
   * fingerprint if the names of the parameters are the same, the cases are the same, and as many of
   * the same cases precede them. So a fingerprint is unique within a result.
   *
   * @return 32 hexadecimal digits each
   */
  public static List<String> fingerprints(TestResult result) {
    List<String> names = result.parameters().stream().map(CaseParameter::name).toList();
    MessageDigest sha256 = sha256();
    Map<CaseIdentity, Integer> known = new HashMap<>();
    List<String> fingerprints = new ArrayList<>(result.cases().size());
    for (CaseResult each : result.cases()) {
      CaseIdentity identity = of(each);
      int precedingEqual = known.merge(identity, 1, Integer::sum) - 1;
      add(sha256, names);
      identity.parts.forEach(part -> add(sha256, part));
      add(sha256, precedingEqual);
      fingerprints.add(HexFormat.of().formatHex(sha256.digest(), 0, FINGERPRINT_BYTES));
    }
    return fingerprints;
  }

  /** Lengths precede texts, so that other texts never give the same bytes. */
  private static void add(MessageDigest digest, List<String> texts) {
    add(digest, texts.size());
    for (String text : texts) {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      add(digest, bytes.length);
      digest.update(bytes);
    }
  }

  private static void add(MessageDigest digest, int number) {
    digest.update(ByteBuffer.allocate(Integer.BYTES).putInt(number).array());
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java runtime has SHA-256", e);
    }
  }
}
