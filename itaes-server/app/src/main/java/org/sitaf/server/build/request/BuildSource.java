package org.sitaf.server.build.request;

import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;

/**
 * Which state of the sources a build tests, as its requester says.
 *
 * @param commit id of a commit, with the suffix {@code -dirty} if the files differ from it; null if
 *     it is not known
 * @param labels values by key
 */
public record BuildSource(@Nullable String commit, Map<String, String> labels) {
  /** Nothing is known. */
  public static final BuildSource UNKNOWN = new BuildSource(null, Map.of());

  private static final int MAX_LABELS = 20;
  private static final int MAX_VALUE = 200;
  private static final Pattern COMMIT = Pattern.compile("[0-9A-Za-z][0-9A-Za-z._/+-]{0,99}");
  private static final Pattern KEY = Pattern.compile("[0-9A-Za-z][0-9A-Za-z._/-]{0,62}");

  public BuildSource {
    if (commit != null && !COMMIT.matcher(commit).matches()) {
      throw RequestException.malformed(
          "commit: must be 1 to 100 letters, digits and the characters . _ / + -.");
    }
    if (labels.size() > MAX_LABELS) {
      throw RequestException.malformed("buildLabels: must be at most " + MAX_LABELS + ".");
    }
    labels.forEach(
        (key, value) -> {
          if (!KEY.matcher(key).matches()) {
            throw RequestException.malformed(
                "buildLabels: a key must be 1 to 63 letters, digits and the characters . _ / -.");
          }
          if (value == null
              || value.length() > MAX_VALUE
              || value.codePoints().anyMatch(Character::isISOControl)) {
            throw RequestException.malformed(
                "buildLabels: the value of "
                    + key
                    + " must be at most "
                    + MAX_VALUE
                    + " printable characters.");
          }
        });
    labels = Map.copyOf(labels);
  }

  /** The labels as text; null if there are none. */
  public @Nullable String labelText() {
    return labels.isEmpty()
        ? null
        : new TreeMap<>(labels)
            .entrySet().stream()
                .map(e -> e.getKey() + "=" + e.getValue())
                .collect(Collectors.joining("\n"));
  }

  /** Reads what {@link #labelText()} wrote. */
  public static BuildSource parse(@Nullable String commit, @Nullable String labelText) {
    Map<String, String> labels = new TreeMap<>();
    if (labelText != null) {
      for (String line : labelText.split("\n", -1)) {
        int end = line.indexOf('=');
        labels.put(line.substring(0, end), line.substring(end + 1));
      }
    }
    return new BuildSource(commit, labels);
  }
}
