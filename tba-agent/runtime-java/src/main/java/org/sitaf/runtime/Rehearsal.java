package org.sitaf.runtime;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Goes through all that a test application does before its first case, up to a simulator that is
 * not there: what is loaded meanwhile goes into an archive of classes, from which test applications
 * start in half the time. An installation runs it once.
 */
final class Rehearsal {
  private static final String SUITE =
      """
      <test_suite_data>
        <name>rehearsal</name>
        <test_model_name>rehearsal</test_model_name>
        <case_param_info><param name="x" type="TDI" real_type="int"/></case_param_info>
        <case_list><case no="1" class="valid"><value>1</value></case></case_list>
      </test_suite_data>
      """;

  private Rehearsal() {}

  /** Needs no arguments; ends with 0 whatever it comes to. */
  public static void main(String[] arguments) throws IOException {
    Path folder = Files.createTempDirectory("sitaf-rehearsal");
    Path suite = Files.writeString(folder.resolve("suite.xml"), SUITE);
    Path world = Files.writeString(folder.resolve("none.world.yaml"), "mjcf: none.xml\n");
    Path results = Files.createFile(folder.resolve("results"));
    TestRun.execute(
        new String[] {
          "--suite", suite.toString(),
          "--results", results.toString(),
          "--bridge", "unix:" + folder.resolve("bridge"),
          "--world", world.toString()
        },
        run -> {
          throw new CannotRunException("this is a rehearsal");
        });
    for (Path file : List.of(suite, world, results, folder)) {
      Files.delete(file);
    }
  }
}
