package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.web.DiagnosticView;

/** Whether files would make an activity. */
@Schema(name = "ActivityCheck")
record CheckView(
    @Schema(description = "everything that is wrong, and warnings")
        List<DiagnosticView> diagnostics,
    @Schema(description = "absent where an error was found")
        @Nullable DescriptionView description) {

  static CheckView of(FileTree files) {
    try {
      Activity activity = Activity.read(files);
      return new CheckView(
          activity.warnings().stream().map(DiagnosticView::of).toList(),
          DescriptionView.of(activity));
    } catch (InvalidInputException e) {
      return new CheckView(e.diagnostics().stream().map(DiagnosticView::of).toList(), null);
    }
  }
}
