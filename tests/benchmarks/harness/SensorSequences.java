import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** The infrared example with sequences of calls instead of single ones. */
final class SensorSequences {
  private static final String MODEL =
      """
      <test_model>
        <name>Steps</name>
        <target interface="InfraredSensorService"/>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="double">
            <name>Distance</name>
            <type>TDSD</type>
            <user_value_list><value>5.0</value></user_value_list>
          </test_element>
        </input_spec_list>
        <sequence_spec length="10" order="3">
          <state name="enabled" type="boolean" initial="false"/>
          <call name="Enable"><update state="enabled">true</update></call>
          <call name="Disable"><update state="enabled">false</update></call>
          <call name="Read" method="GetInfraredData">
            <guard>enabled</guard>
            <forbidden>-1.0</forbidden>
            <input_spec_list>
              <test_element abstract_type="NUMERIC" real_type="int">
                <name>IndexOfSensor</name>
                <type>TDI</type>
                <user_value_list><value>1</value></user_value_list>
              </test_element>
              <test_element abstract_type="NUMERIC" real_type="int">
                <name>NumOfSensor</name>
                <type>TDI</type>
                <user_value_list><value>1</value><value>7</value></user_value_list>
              </test_element>
            </input_spec_list>
            <output_spec_list>
              <test_element abstract_type="NUMERIC" real_type="double">
                <name>return</name>
                <type>RETURN</type>
                <expected>5.0</expected>
                <tolerance absolute="1e-9"/>
              </test_element>
            </output_spec_list>
          </call>
        </sequence_spec>
        <order_of_combinations>2</order_of_combinations>
      </test_model>
      """;

  private SensorSequences() {}

  /** Writes the activity with the component of an example; returns its folder. */
  static Path write(Path example, Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(example)) {
      for (Path file : files.toList()) {
        Path copy = folder.resolve(example.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(copy);
        } else {
          Files.copy(file, copy);
        }
      }
    }
    Files.writeString(folder.resolve("Steps.xml"), MODEL);
    Path profile = folder.resolve("activity.yaml");
    Files.writeString(
        profile,
        Files.readString(profile)
            .replaceFirst("(?m)^models: .*$", "models: [Steps.xml]")
            .replaceFirst("(?m)^ *before: .*\\R", ""));
    return folder;
  }
}
