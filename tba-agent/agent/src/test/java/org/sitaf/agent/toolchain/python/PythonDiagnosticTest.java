package org.sitaf.agent.toolchain.python;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.toolchain.SourceDiagnostic;

/** Lines in which builds of nodes and of Python report errors. */
class PythonDiagnosticTest {
  private static SourceDiagnostic read(String line) {
    return PythonToolchain.diagnostic(
        line, Path.of("/build/output"), Map.of("src/follower/", "sources"));
  }

  @Test
  void aPlaceInACopyIsThatOfTheActivity() {
    assertThat(read("/build/output/sources/a.py\t3\t7\tinvalid syntax"))
        .isEqualTo(
            new SourceDiagnostic("activity/src/follower/a.py", 3, 7, "invalid syntax", false));
  }

  @Test
  void anErrorOfNoFileIsReportedAsItIs() {
    assertThat(read("\t0\t0\tthe node cannot be linked: undefined: limit()"))
        .isEqualTo(
            new SourceDiagnostic("", 0, 0, "the node cannot be linked: undefined: limit()", false));
  }

  @Test
  void anErrorInAHeaderOfTheSystemKeepsItsPath() {
    assertThat(read("/usr/include/c++/12/bits/x.h\t3\t7\tno matching function"))
        .isEqualTo(
            new SourceDiagnostic(
                "/usr/include/c++/12/bits/x.h", 3, 7, "no matching function", false));
  }
}
