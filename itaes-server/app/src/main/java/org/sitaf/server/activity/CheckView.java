package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.web.DiagnosticView;

/** The result of checking an activity. */
@Schema(name = "ActivityCheck")
record CheckView(
    @Schema(description = "errors and warnings") List<DiagnosticView> diagnostics,
    @Schema(description = "absent if there are errors") @Nullable DescriptionView description) {

  static CheckView of(FileTree files, StoredActivities activities) {
    try {
      Activity activity = activities.read(files);
      return new CheckView(
          activity.warnings().stream().map(DiagnosticView::of).toList(),
          DescriptionView.of(activity));
    } catch (InvalidInputException e) {
      return new CheckView(e.diagnostics().stream().map(DiagnosticView::of).toList(), null);
    }
  }
}
