package org.sitaf.server.result.coverage;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.Coverage;

/** What was reached of the component, without its lines. */
@Schema(name = "Coverage")
record CoverageView(
    @Schema(description = "whether it was measured; where not, there are no files")
        boolean measured,
    @Schema(description = "per cent of the lines with statements; absent where there are none")
        @Nullable Double statement,
    @Schema(description = "per cent of the branches; absent where there are none")
        @Nullable Double branch,
    @Schema(description = "in the order of their paths") List<FileView> files) {
  static final CoverageView NOT_MEASURED = new CoverageView(false, null, null, List.of());

  @Schema(name = "CoverageFile")
  record FileView(
      @Schema(description = "within the activity") String path,
      @Schema(description = "lines that hold statements") int lines,
      @Schema(description = "of them, those that were reached") int reached,
      @Schema(description = "ways on from lines with more than one") int branches,
      @Schema(description = "of them, those that were gone") int taken) {
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
      @Schema(description = "text of the file as it was built; absent where it is not kept")
          @Nullable String source,
      @Schema(description = "those that hold statements, ascending") List<LineView> lines) {
    static SourceView of(Coverage.File file, @Nullable String source) {
      return new SourceView(file.path(), source, file.lines().stream().map(LineView::of).toList());
    }
  }

  @Schema(name = "CoverageLine")
  record LineView(
      @Schema(description = "from 1") int number,
      boolean reached,
      @Schema(description = "ways on from it; 0 where there is only one") int branches,
      @Schema(description = "of them, those that were gone") int taken) {
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
