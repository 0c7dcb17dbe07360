package org.sitaf.server.result;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.springframework.web.util.HtmlUtils;

/** Writes a result as a single HTML page without scripts or external resources. */
final class ResultReport {
  /** Maximum number of rows, because browsers are slow with more; failed cases come first. */
  private static final int MAX_CASES = 5000;

  private static final String STYLE =
      """
      body{font:15px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:90rem;padding:0 1rem;color:#1c2024;background:#fff}
      h1{font-size:1.5rem;margin:0}p{margin:.3rem 0}.dim{color:#5c636a}
      dl{display:flex;flex-wrap:wrap;gap:.5rem 2rem}dt{color:#5c636a;font-size:.85rem}dd{margin:0;font-weight:600}
      .bar{display:flex;height:.8rem;border-radius:.4rem;overflow:hidden;margin:1rem 0}
      .cases{overflow-x:auto}table{border-collapse:collapse;min-width:100%;font-variant-numeric:tabular-nums}
      th,td{padding:.3rem .6rem;border-bottom:1px solid #dde1e5;text-align:left;vertical-align:top}
      bdi{display:inline-block;max-width:60ch;overflow-wrap:break-word}
      .PASS{color:#1b6e36}.FAIL,.ERROR{color:#a32018}.DONT{color:#704b00}tr.FAIL,tr.ERROR{background:#fdf0ee}
      .b-PASS{background:#2f9e55}.b-FAIL{background:#d64539}.b-ERROR{background:#8e1f18}.b-DONT{background:#c08a1e}
      @media (prefers-color-scheme:dark){body{background:#16191c;color:#e6e9ec}.dim,dt{color:#a3a9b0}th,td{border-color:#343a40}
      .PASS{color:#6fd08c}.FAIL,.ERROR{color:#ff9a91}.DONT{color:#f0bf5c}tr.FAIL,tr.ERROR{background:#3a2422}}
      """;

  private final StringBuilder html = new StringBuilder();

  private ResultReport() {}

  static byte[] write(String activity, TestResult result) {
    return new ResultReport().page(activity, result).getBytes(StandardCharsets.UTF_8);
  }

  private String page(String activity, TestResult result) {
    String title = activity + " / " + result.name();
    html.append("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">")
        .append("<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">")
        .append("<title>")
        .append(HtmlUtils.htmlEscape(title, "UTF-8"))
        .append("</title><style>")
        .append(STYLE)
        .append("</style></head><body><h1>")
        .append(text(title))
        .append("</h1>");
    provenance(result.provenance());
    suspicions(result);
    summary(result.summary());
    cases(result);
    return html.append("</body></html>\n").toString();
  }

  private void provenance(Provenance provenance) {
    html.append("<p class=\"dim\">")
        .append(text(provenance.started() + " to " + provenance.finished()))
        .append(", agent ")
        .append(text(provenance.agent()))
        .append(", ")
        .append(text(provenance.bridge()))
        .append("</p><p class=\"dim\">Suite ")
        .append(text(provenance.suite()))
        .append(", seed ")
        .append(provenance.seed())
        .append(", component ")
        .append(text(provenance.component()))
        .append("</p>");
  }

  private void suspicions(TestResult result) {
    if (result.isSuspect()) {
      html.append("<p class=\"ERROR\"><strong>Suspect: the verdicts cannot be trusted.</strong> ")
          .append(text(String.join("; ", result.suspicions())))
          .append("</p>");
    }
  }

  private void summary(Summary summary) {
    html.append("<div class=\"bar\" role=\"img\" aria-label=\"Verdicts\">");
    share("PASS", summary.pass());
    share("FAIL", summary.fail());
    share("ERROR", summary.error());
    share("DONT", summary.dont());
    html.append("</div><dl>");
    fact("Total", Integer.toString(summary.total()));
    fact("Pass", Integer.toString(summary.pass()));
    fact("Fail", Integer.toString(summary.fail()));
    fact("Error", Integer.toString(summary.error()));
    fact("Not executed", Integer.toString(summary.dont()));
    Summary.Times times = summary.times();
    if (times != null) {
      fact("Min (µs)", number(times.min()));
      fact("Max (µs)", number(times.max()));
      fact("Average (µs)", number(times.average()));
      fact("Std deviation (µs)", number(times.standardDeviation()));
    }
    html.append("</dl>");
  }

  private void share(String verdict, int count) {
    html.append("<span class=\"b-")
        .append(verdict)
        .append("\" style=\"flex:")
        .append(count)
        .append("\"></span>");
  }

  private void fact(String name, String value) {
    html.append("<div><dt>").append(name).append("</dt><dd>").append(value).append("</dd></div>");
  }

  private void cases(TestResult result) {
    List<CaseResult> shown = result.cases();
    if (shown.size() > MAX_CASES) {
      shown =
          result.cases().stream()
              .sorted(java.util.Comparator.comparing(c -> c.verdict() == Verdict.PASS))
              .limit(MAX_CASES)
              .toList();
      html.append("<p>")
          .append(MAX_CASES)
          .append(" of ")
          .append(result.cases().size())
          .append(" cases, failed cases first; the CSV export contains all cases.</p>");
    }
    html.append("<div class=\"cases\"><table><thead><tr><th>No</th>");
    for (CaseParameter parameter : result.parameters()) {
      html.append("<th>").append(text(parameter.name())).append("</th>");
    }
    html.append("<th>Expected</th><th>Actual</th><th>Verdict</th><th>Time (µs)</th>")
        .append("<th>Message</th></tr></thead><tbody>");
    for (CaseResult testCase : shown) {
      html.append("<tr class=\"")
          .append(testCase.verdict())
          .append("\"><td>")
          .append(testCase.no());
      testCase.values().forEach(v -> html.append("</td><td>").append(text(v)));
      html.append("</td><td>")
          .append(text(ResultCsv.values(testCase.expected())))
          .append("</td><td>")
          .append(text(ResultCsv.values(testCase.actual())))
          .append("</td><td class=\"")
          .append(testCase.verdict())
          .append("\">")
          .append(testCase.verdict())
          .append("</td><td>")
          .append(testCase.time() == null ? "" : number(testCase.time().total()))
          .append("</td><td>")
          .append(text(testCase.message()))
          .append("</td></tr>");
    }
    html.append("</tbody></table></div>");
  }

  private static String number(double number) {
    return String.format(Locale.ROOT, "%.3f", number);
  }

  /** Escapes untrusted text and isolates its writing direction. */
  private static String text(String text) {
    return "<bdi>" + HtmlUtils.htmlEscape(text, "UTF-8") + "</bdi>";
  }
}
