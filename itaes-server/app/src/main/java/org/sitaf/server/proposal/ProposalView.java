package org.sitaf.server.proposal;

import io.swagger.v3.oas.annotations.media.Schema;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.function.Predicate;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.beginning.Proposal;

/** A proposed activity. */
@Schema(name = "ActivityProposal")
@SuppressWarnings("ArrayRecordComponent") // Proposals are not compared.
record ProposalView(
    @Schema(description = "what is left out, and what a person has to add") List<String> notes,
    List<FileView> files,
    @Schema(description = "the zip of these files, from which an activity can be created")
        byte[] archive) {

  @Schema(name = "ProposedFile")
  record FileView(
      String path,
      @Schema(description = "in bytes") long size,
      @Schema(description = "whether it is a copy of a given or installed file") boolean given) {}

  static ProposalView of(Proposal proposal, Predicate<String> isGiven) {
    FileTree files = proposal.files();
    ByteArrayOutputStream zip = new ByteArrayOutputStream();
    try {
      ActivityArchive.write(files, zip);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return new ProposalView(
        proposal.notes(),
        files.paths().stream()
            .map(
                path ->
                    new FileView(
                        path, files.content(path).orElseThrow().length, isGiven.test(path)))
            .toList(),
        zip.toByteArray());
  }
}
