package org.sitaf.cli.bisect;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.bisect.Criterion.Decision;
import org.sitaf.cli.git.FolderHistory.Commit;
import tools.jackson.databind.json.JsonMapper;

/** Writes the result of a search as JSON (docs/compare.md). */
final class BisectionJson {
  private BisectionJson() {}

  /** The test of a commit. */
  record TestedCommit(String commit, Decision decision) {}

  static String write(List<Commit> candidates, List<TestedCommit> tested, int builds) {
    Map<String, @Nullable Object> root = new LinkedHashMap<>();
    root.put("first_bad", candidates.size() == 1 ? candidates.get(0).id() : null);
    root.put("candidates", candidates.stream().map(Commit::id).toList());
    root.put("tested", tested.stream().map(BisectionJson::entry).toList());
    root.put("builds", builds);
    return new JsonMapper().writerWithDefaultPrettyPrinter().writeValueAsString(root) + "\n";
  }

  private static Map<String, Object> entry(TestedCommit test) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("commit", test.commit());
    entry.put("outcome", test.decision().outcome().name().toLowerCase(Locale.ROOT));
    entry.put("reason", test.decision().reason());
    return entry;
  }
}
