package org.sitaf.cli.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

class SuiteCacheTest {
  @TempDir private Path folder;

  private static TestModel model(String max) {
    String xml =
        """
        <test_model><name>M</name><input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="uint8"><name>X</name><type>TDI</type>
            <test_spec type="BVA" offset="1"><equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="0" max="%s"/></test_spec>
          </test_element></input_spec_list>
          <order_of_combinations>1</order_of_combinations></test_model>
        """
            .formatted(max);
    return TestModelXml.read(
        new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "m.xml");
  }

  private List<Path> files() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.sorted().toList();
    }
  }

  @Test
  void aSuiteIsFoundWithItsNotes() throws IOException {
    SuiteCache cache = new SuiteCache(folder);
    GeneratedSuite first = cache.generate(model("9"), GenerationOptions.DEFAULT);
    assertThat(first.notes()).isNotEmpty();
    assertThat(files()).hasSize(1);
    assertThat(cache.generate(model("9"), GenerationOptions.DEFAULT)).isEqualTo(first);
    assertThat(files()).hasSize(1);

    Path nine = files().get(0);
    GeneratedSuite other = cache.generate(model("8"), GenerationOptions.DEFAULT.withSeed(2));
    assertThat(files()).hasSize(2);
    Path eight = files().stream().filter(f -> !f.equals(nine)).findFirst().orElseThrow();
    Files.copy(eight, nine, StandardCopyOption.REPLACE_EXISTING);
    assertThat(cache.generate(model("9"), GenerationOptions.DEFAULT))
        .as("the stored suite, not a new one")
        .isEqualTo(other);
  }

  @Test
  void aDamagedFileIsNoError() throws IOException {
    SuiteCache cache = new SuiteCache(folder);
    var unused = cache.generate(model("9"), GenerationOptions.DEFAULT);
    Files.writeString(files().get(0), "damaged");
    assertThat(cache.generate(model("9"), GenerationOptions.DEFAULT))
        .isEqualTo(TestCaseGenerator.generate(model("9"), GenerationOptions.DEFAULT));
  }
}
