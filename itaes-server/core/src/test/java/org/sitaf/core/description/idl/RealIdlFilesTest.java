package org.sitaf.core.description.idl;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.Severity;

/** Reads the IDL files of Cyclone DDS and Fast-DDS. */
@Tag("slow")
class RealIdlFilesTest {
  private static final Path FILES = Path.of("../../../shared/idl");

  @Test
  void readsFilesOfPublicProjects() throws IOException {
    Assumptions.assumeTrue(Files.isDirectory(FILES), "needs ../shared next to the source tree");
    List<Path> all;
    try (Stream<Path> walked = Files.walk(FILES)) {
      all = walked.filter(path -> path.toString().endsWith(".idl")).sorted().toList();
    }
    List<String> refused = new ArrayList<>();
    for (Path path : all) {
      Map<String, byte[]> files = new HashMap<>();
      try (Stream<Path> siblings = Files.list(path.getParent())) {
        for (Path sibling : (Iterable<Path>) siblings::iterator) {
          if (sibling.toString().endsWith(".idl")) {
            files.put(FILES.relativize(sibling).toString(), Files.readAllBytes(sibling));
          }
        }
      }
      String name = FILES.relativize(path).toString();
      ImportResult result = InterfaceFiles.read(SourceFiles.of("real", files, List.of(name)));
      result.diagnostics().stream()
          .filter(d -> d.severity() == Severity.ERROR)
          .findFirst()
          .ifPresent(d -> refused.add(name + " " + d));
    }
    assertThat(refused).isEmpty();
  }
}
