package org.sitaf.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.ServerTest;

/** The clients that the server offers; {@code tests/e2e} uses the one in Python. */
@Tag("slow")
class ClientsTest extends ServerTest {
  private static final String USE =
      """
      import org.sitaf.client.ApiClient;
      import org.sitaf.client.ApiException;
      import org.sitaf.client.api.ActivitiesApi;
      import org.sitaf.client.api.SuitesApi;

      public class Use {
        public static String use(int port, String token, String activity, String model) throws Exception {
          ApiClient client = new ApiClient();
          client.updateBaseUri("http://localhost:" + port);
          client.setRequestInterceptor(request -> request.header("Authorization", "Bearer " + token));
          String name = new ActivitiesApi(client).getActivity(activity).getName();
          int cases = new SuitesApi(client).generateSuite(activity, model, null).getTotal();
          try {
            new ActivitiesApi(client).getActivity("none");
          } catch (ApiException e) {
            return name + " " + cases + " " + e.getCode();
          }
          return "no error";
        }
      }
      """;

  @TempDir private Path folder;

  @Test
  void theClientInJavaIsCompiledAndUsed() throws Exception {
    unpack(api.get("/api/v1/clients/java").expect(200).bytes());
    Path use = Files.writeString(folder.resolve("Use.java"), USE);
    Path classes = Files.createDirectory(folder.resolve("classes"));
    compile(
        Stream.concat(
                Stream.of(use), sources(folder.resolve("sitaf-client-java/src/main/java")).stream())
            .toList(),
        classes);
    String activity = api.upload(Activities.zip());
    try (URLClassLoader loader = new URLClassLoader(new URL[] {classes.toUri().toURL()})) {
      assertThat(
              loader
                  .loadClass("Use")
                  .getMethod("use", int.class, String.class, String.class, String.class)
                  .invoke(null, httpPort(), TOKEN, activity, Activities.MODEL))
          .isEqualTo("ir-sensor 55 404");
    }
  }

  @Test
  void theClientInPythonIsAPackage() throws Exception {
    unpack(api.get("/api/v1/clients/python").expect(200).bytes());
    Path client = folder.resolve("sitaf-client-python");
    assertThat(client.resolve("pyproject.toml")).isRegularFile();
    assertThat(client.resolve("sitaf_client/api/builds_api.py"))
        .content()
        .contains("def get_build");
    api.get("/api/v1/clients/cobol").expect(404);
  }

  private void unpack(byte[] archive) throws IOException {
    try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(archive))) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        Path file = folder.resolve(entry.getName());
        Files.createDirectories(file.getParent());
        Files.copy(zip, file);
      }
    }
  }

  private static List<Path> sources(Path root) throws IOException {
    try (Stream<Path> files = Files.walk(root)) {
      return files.filter(file -> file.toString().endsWith(".java")).toList();
    }
  }

  private static void compile(List<Path> sources, Path classes) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
      List<String> options =
          List.of(
              "-proc:none",
              "-nowarn",
              "-cp",
              System.getProperty("java.class.path"),
              "-d",
              classes.toString());
      assertThat(
              compiler
                  .getTask(
                      null, files, null, options, null, files.getJavaFileObjectsFromPaths(sources))
                  .call())
          .isTrue();
    }
  }
}
