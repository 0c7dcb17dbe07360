package org.sitaf.server.result.coverage;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.Coverage;

/** The coverage of a component by file, without lines. */
@Schema(name = "Coverage")
record CoverageView(
    @Schema(description = "whether coverage was measured; if not, there are no files")
        boolean measured,
    @Schema(description = "percentage of covered lines; absent if there are no lines")
        @Nullable Double statement,
    @Schema(description = "percentage of taken branches; absent if there are no branches")
        @Nullable Double branch,
    @Schema(description = "sorted by path") List<FileView> files) {
  static final CoverageView NOT_MEASURED = new CoverageView(false, null, null, List.of());

  @Schema(name = "CoverageFile")
  record FileView(
      @Schema(description = "in the activity") String path,
      @Schema(description = "number of lines with statements") int lines,
      @Schema(description = "number of covered lines") int reached,
      @Schema(description = "number of branches") int branches,
      @Schema(description = "number of taken branches") int taken) {
    static FileView of(Coverage.File file) {
      return new FileView(
          file.path(),
          file.lines().size(),
          (int) file.lines().stream().filter(Coverage.Line::reached).count(),
          file.lines().stream().mapToInt(Coverage.Line::branches).sum(),
          file.lines().stream().mapToInt(Coverage.Line::taken).sum());
    }
  }

  @Schema(name = "CoverageSource")
  record SourceView(
      String path,
      @Schema(description = "text of the file as it was built; absent if it is not stored")
          @Nullable String source,
      @Schema(description = "lines with statements, in ascending order") List<LineView> lines) {
    static SourceView of(Coverage.File file, @Nullable String source) {
      return new SourceView(file.path(), source, file.lines().stream().map(LineView::of).toList());
    }
  }

  @Schema(name = "CoverageLine")
  record LineView(
      @Schema(description = "from 1") int number,
      boolean reached,
      @Schema(description = "number of branches; 0 if the line has none") int branches,
      @Schema(description = "number of taken branches") int taken) {
    static LineView of(Coverage.Line line) {
      return new LineView(line.number(), line.reached(), line.branches(), line.taken());
    }
  }

  static CoverageView of(Coverage coverage) {
    return new CoverageView(
        true,
        orNull(coverage.statement()),
        orNull(coverage.branch()),
        coverage.files().stream().map(FileView::of).toList());
  }

  private static @Nullable Double orNull(OptionalDouble value) {
    return value.isPresent() ? value.getAsDouble() : null;
  }
}
