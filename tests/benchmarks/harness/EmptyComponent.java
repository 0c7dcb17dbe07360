import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.sitaf.core.activity.ActivityProfile.Language;

/** An activity whose component does nothing, to measure the overhead of the measurement. */
final class EmptyComponent {
  private static final String INTERFACE =
      """
      <service_port_type>
        <type_name>EchoService</type_name>
        <method name="echo" return_type="int" call_type="blocking">
          <param index="1"><type>int</type><name>Value</name></param>
        </method>
      </service_port_type>
      """;

  private static final String MODEL =
      """
      <test_model>
        <name>Echo</name>
        <target interface="EchoService" method="echo"/>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="int">
            <name>Value</name>
            <type>TDI</type>
            <user_value_list><value>1</value><value>2</value></user_value_list>
          </test_element>
        </input_spec_list>
        <output_spec_list>
          <test_element abstract_type="NUMERIC" real_type="int">
            <name>return</name>
            <type>RETURN</type>
            <expected>Value</expected>
          </test_element>
        </output_spec_list>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;

  private EmptyComponent() {}

  /** Writes the activity; returns its folder. */
  static Path write(Language language, Path folder) throws IOException {
    Path component = Files.createDirectories(folder.resolve("component"));
    Files.writeString(folder.resolve("EchoService.xml"), INTERFACE);
    Files.writeString(folder.resolve("Echo.xml"), MODEL);
    String className =
        switch (language) {
          case JAVA -> {
            Files.writeString(
                component.resolve("Echo.java"),
                "package empty;\npublic class Echo { public int echo(int value) { return value; } }\n");
            yield "empty.Echo";
          }
          case CPP -> {
            Files.writeString(
                component.resolve("echo.hpp"),
                """
                #pragma once
                #include <cstdint>
                namespace empty {
                class Echo {
                 public:
                  std::int32_t echo(std::int32_t value) { return value; }
                };
                }  // namespace empty
                """);
            yield "empty::Echo";
          }
          case PYTHON -> {
            Files.writeString(
                component.resolve("empty.py"),
                "class Echo:\n    def echo(self, value: int) -> int:\n        return value\n");
            yield "empty.Echo";
          }
        };
    Files.writeString(
        folder.resolve("activity.yaml"),
        """
        name: empty
        component:
          language: %s
          sources: component/
          class: %s
        provided: [EchoService.xml]
        models: [Echo.xml]
        """
            .formatted(language.id(), className));
    return folder;
  }
}
