package org.sitaf.server.proposal;

import java.util.Arrays;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.server.error.RequestException;

/**
 * The wishes for a new activity.
 *
 * @param name of the activity
 * @param language of the component; null for Python, or for that of the package
 * @param className class of the component or node; null for a default
 * @param interfacePath path of a given or installed interface file; null for the only one
 * @param node folder of a ROS 2 package; null for a new component
 */
record ProposalRequest(
    String name,
    @Nullable Language language,
    @Nullable String className,
    @Nullable String interfacePath,
    @Nullable String node) {

  ProposalRequest {
    if (node != null && interfacePath != null) {
      throw RequestException.malformed("Give either interface or node, not both.");
    }
    if (node != null && language == Language.JAVA) {
      throw RequestException.malformed(
          "language: a ROS 2 node is written in python or cpp, not in java.");
    }
  }

  static @Nullable Language language(@Nullable String id) {
    if (id == null) {
      return null;
    }
    return Arrays.stream(Language.values())
        .filter(language -> language.id().equals(id))
        .findFirst()
        .orElseThrow(
            () ->
                RequestException.malformed(
                    Arrays.stream(Language.values())
                        .map(Language::id)
                        .collect(Collectors.joining(", ", "language must be one of ", "."))));
  }
}
