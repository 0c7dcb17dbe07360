package org.sitaf.core.verdict.document;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.schemas.CoverageListType;
import org.sitaf.schemas.CoveredFileType;
import org.sitaf.schemas.CoveredLineType;
import org.sitaf.schemas.SummaryType;

/** The coverage in the document of a result. */
final class CoverageXml {
  private CoverageXml() {}

  static @Nullable Coverage read(@Nullable CoverageListType given) {
    if (given == null) {
      return null;
    }
    return new Coverage(
        given.getFiles().stream()
            .map(file -> new Coverage.File(String.valueOf(file.getPath()), lines(file)))
            .toList());
  }

  private static List<Coverage.Line> lines(CoveredFileType file) {
    return file.getLines().stream()
        .map(
            line ->
                new Coverage.Line(
                    line.getNo(),
                    line.isReached(),
                    orZero(line.getBranches()),
                    orZero(line.getBranchesTaken())))
        .toList();
  }

  static @Nullable CoverageListType write(@Nullable Coverage coverage) {
    if (coverage == null) {
      return null;
    }
    CoverageListType written = new CoverageListType();
    for (Coverage.File file : coverage.files()) {
      CoveredFileType element = new CoveredFileType();
      element.setPath(file.path());
      file.lines().forEach(line -> element.getLines().add(write(line)));
      written.getFiles().add(element);
    }
    return written;
  }

  private static CoveredLineType write(Coverage.Line line) {
    CoveredLineType written = new CoveredLineType();
    written.setNo(line.number());
    written.setReached(line.reached());
    if (line.branches() > 0) {
      written.setBranches(line.branches());
      written.setBranchesTaken(line.taken());
    }
    return written;
  }

  /** The two fields of Fig. 17, in per cent; empty where it was not measured. */
  static SummaryType.Coverage summary(@Nullable Coverage coverage) {
    SummaryType.Coverage written = new SummaryType.Coverage();
    written.setStatement(coverage == null ? "" : percent(coverage.statement()));
    written.setBranch(coverage == null ? "" : percent(coverage.branch()));
    return written;
  }

  private static String percent(OptionalDouble percent) {
    return percent.isPresent() ? String.format(Locale.ROOT, "%.1f", percent.getAsDouble()) : "";
  }

  private static int orZero(@Nullable Integer number) {
    return number == null ? 0 : number;
  }
}
