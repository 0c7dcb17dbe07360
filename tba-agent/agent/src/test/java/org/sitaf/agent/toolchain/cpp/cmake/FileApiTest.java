package org.sitaf.agent.toolchain.cpp.cmake;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.agent.toolchain.CompilationException;

/** A project can replace each reply of CMake, since its own commands run in the same folder. */
class FileApiTest {
  private static final String INPUTS = "{\"inputs\": [{\"path\": \"/usr/include/stdio.h\"}]}";

  @TempDir private Path folder;
  private Path replies;

  @BeforeEach
  void createReplies() throws IOException {
    replies = Files.createDirectories(folder.resolve(".cmake/api/v1/reply"));
    write("cmakeFiles-v1-1.json", INPUTS);
  }

  private void write(String name, String content) throws IOException {
    Files.writeString(replies.resolve(name), content);
  }

  private LinkedTarget target() throws CompilationException {
    return new FileApi(folder, folder.resolve("sources"), folder.resolve("tools")).target(0, "");
  }

  private void assertRefused(String reason) {
    assertThatThrownBy(this::target)
        .isInstanceOf(CompilationException.class)
        .hasMessageStartingWith("cmake's reply about the project cannot be read: ")
        .hasMessageContaining(reason);
  }

  @Test
  void readsTheFlagsOfATarget() throws Exception {
    write(
        "target-sitaf_probe-1.json",
        """
        {"compileGroups": [{"includes": [{"path": "/p/include"}], "defines": [{"define": "A=1"}],
           "compileCommandFragments": [{"fragment": "-O1 -mavx"}],
           "languageStandard": {"standard": "20"}}],
         "link": {"commandFragments": [{"role": "libraries", "fragment": "libarm.a -lm"},
           {"role": "flags", "fragment": "-s"}]}}
        """);
    Files.writeString(folder.resolve("a.o.d"), "a.o: /usr/include/math.h \\\n  sources/own.h\n");
    LinkedTarget target = target();
    assertThat(target.compileFlags()).containsExactly("-I", "/p/include", "-DA=1", "-mavx");
    assertThat(target.linkFlags()).containsExactly(folder.resolve("libarm.a").toString(), "-lm");
    assertThat(target.standard()).isEqualTo(20);
    assertThat(target.opened()).containsExactly("/usr/include/math.h", "/usr/include/stdio.h");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "[]",
        "null",
        "{\"compileGroups\": 1}",
        "{\"compileGroups\": [[]]}",
        "{\"compileGroups\": [{\"includes\": [{}]}]}",
        "{\"compileGroups\": [{\"includes\": [{\"path\": {}, \"isSystem\": [1, 2]}]}]}",
        "{\"compileGroups\": [{\"compileCommandFragments\": [{}]}]}",
        "{\"compileGroups\": [{\"languageStandard\": {}}]}",
        "{\"link\": {\"commandFragments\": [{\"fragment\": \"a\"}]}}",
        "{\"link\": {\"commandFragments\": [{\"role\": \"libraries\", \"fragment\": \"a\\u0000b\"}]}}"
      })
  void refusesOtherReplies(String reply) throws Exception {
    write("target-sitaf_probe-1.json", reply);
    assertRefused("");
  }

  @Test
  void refusesNestedReplies() throws Exception {
    write("target-sitaf_probe-1.json", "[".repeat(1_000_000));
    assertRefused("");
  }

  @Test
  void refusesLongReplies() throws Exception {
    write("target-sitaf_probe-1.json", "[" + "[],".repeat(1_000_000) + "[]]");
    assertRefused("more than 2097152 bytes");
  }

  @Test
  void refusesLongDependencies() throws Exception {
    write("target-sitaf_probe-1.json", "{}");
    Files.writeString(folder.resolve("a.o.d"), "a.o:" + " /a".repeat(400_000));
    assertRefused("a.o.d has more than 1048576 bytes");
  }

  @Test
  void refusesManySharedLibraries() throws Exception {
    write("target-sitaf_probe-1.json", "{}");
    for (int i = 0; i < 300; i++) {
      Files.createFile(folder.resolve("lib" + i + ".so"));
    }
    assertRefused("more than 200 files");
  }

  @Test
  void readsNoLinks() throws Exception {
    Path secret = Files.writeString(folder.resolve("secret"), "{}");
    Files.createSymbolicLink(replies.resolve("target-sitaf_probe-1.json"), secret);
    assertRefused("there are 0 files target-sitaf_probe-*.json");
  }
}
