package org.sitaf.server.web;

import io.swagger.v3.oas.annotations.media.Schema;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Severity;

/** A problem of an input. */
@Schema(name = "Diagnostic")
public record DiagnosticView(
    Severity severity,
    @Schema(description = "name of the document") String file,
    @Schema(description = "from 1; 0 if unknown") int line,
    @Schema(description = "element or entry; empty for the whole document") String element,
    @Schema(description = "what is wrong, what was expected, and what to do") String message) {
  public static DiagnosticView of(Diagnostic diagnostic) {
    return new DiagnosticView(
        diagnostic.severity(),
        diagnostic.file(),
        diagnostic.line(),
        diagnostic.element(),
        diagnostic.message());
  }
}
