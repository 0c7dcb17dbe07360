package org.sitaf.core.description.idl;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.importer.InterfaceText;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;

class IdlPreprocessorTest {
  private static List<String> prototypes(String text) {
    ImportResult result = InterfaceText.read("a.idl", text);
    assertThat(InterfaceText.lines(result)).isEmpty();
    return InterfaceText.prototypes(result.provided().get(0));
  }

  private static List<String> problems(String text) {
    return InterfaceText.lines(InterfaceText.read("a.idl", text));
  }

  @Test
  void leavesOutFalseSections() {
    assertThat(
            prototypes(
                """
                #if defined(__IDL__) && !defined(C_CODE)
                interface A {
                  void shown();
                #ifdef C_CODE
                  int main(void) { don't(); return 1; }
                #elif 2 * (3 + 1) == 8 && (1 << 4) > 15
                  void second();
                #else
                  void third();
                #endif
                };
                #else
                static class B { virtual void hidden() = 0; };
                #endif
                """))
        .containsExactly("void shown()", "void second()");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "1 ? 0 : 1 | no",
        "defined UNKNOWN | no",
        "defined(N) && N == 0x10 | yes",
        "-1 < 0 && !0 && ~0 == -1 | yes",
        "0 && 1 / 0 | no",
        "`1 || 1 % 0` | yes",
        "'a' == 97 | yes",
        "TWICE(N) == 32L | yes",
        "UNKNOWN | no"
      })
  void evaluatesConditions(String condition, String holds) {
    assertThat(
            prototypes(
                "#define N 0x10\n#define TWICE(x) ((x) * 2)\ninterface A {\n#if "
                    + condition
                    + "\nvoid yes();\n#else\nvoid no();\n#endif\n};"))
        .containsExactly("void " + holds + "()");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "#define T long@T | int32",
        "#define T(x) sequence<x>@T(T(octet)) | sequence<sequence<uint8>>",
        "#define JOIN(a, b) a ## b@JOIN(dou, ble) | double",
        "#define EMPTY@EMPTY float EMPTY | float",
        "#define PAIR(a, ...) a<__VA_ARGS__>@PAIR(sequence, octet, 7) | sequence<uint8,7>",
        "#define long short@#undef long@long | int32",
        "#define T U@#define U T@#define V long@V | int32",
        "#define CALL(f, x) f(x)@#define S(x) string<x>@CALL(S, 8) | string<8>",
        "#define S(x) string<x>@S(@ 8@ ) | string<8>"
      })
  void replacesMacros(String lines, String type) {
    List<String> all = List.of(lines.split("@"));
    int first = all.stream().filter(line -> line.startsWith("#")).toList().size();
    String definitions = String.join("\n", all.subList(0, first));
    String use = String.join("\n", all.subList(first, all.size()));
    assertThat(prototypes(definitions + "\ninterface A {\n" + use + " get();\n};"))
        .containsExactly(type + " get()");
  }

  private static ImportResult read(Map<String, String> texts, List<String> folders) {
    Map<String, byte[]> files = new HashMap<>();
    texts.forEach((path, text) -> files.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return InterfaceFiles.read(
        SourceFiles.of("test", files, List.of("src/a.idl")).including(folders));
  }

  @Test
  void includesFilesWithTheirMacrosOnce() {
    ImportResult result =
        read(
            Map.of(
                "src/a.idl",
                "#include \"../include/types.idl\"\n"
                    + "#include <types.idl>\n"
                    + "interface A { M::T get(in M::N n); };",
                "include/types.idl",
                "#ifndef T_IDL\n"
                    + "#define T_IDL\n"
                    + "#define NUMBER long\n"
                    + "module M {\n"
                    + "#include \"n.idl\"\n"
                    + "typedef NUMBER T; };\n"
                    + "#endif",
                "include/n.idl",
                "struct N { double x; };",
                "other/types.idl",
                "interface Hidden {};"),
            List.of("include"));
    assertThat(InterfaceText.lines(result)).isEmpty();
    assertThat(InterfaceText.prototypes(result.provided().get(0)))
        .containsExactly("int32 get(IN M::N n)");
  }

  @Test
  void aFileWithoutGuardThatIsIncludedTwiceIsDeclaredOnce() {
    ImportResult result =
        read(
            Map.of(
                "src/a.idl",
                "#include \"b.idl\"\n#include \"b.idl\"\ninterface A { S get(); };",
                "src/b.idl",
                "struct S { long x; };"),
            List.of());
    assertThat(InterfaceText.lines(result)).isEmpty();
  }

  @Test
  void errorsNameTheFileAndLineTheyComeFrom() {
    ImportResult result =
        read(
            Map.of(
                "src/a.idl",
                "#include \"b.idl\"\ninterface A { S get(); };",
                "src/b.idl",
                "// first\n/* second\n third */ struct S {\n  long\n};"),
            List.of());
    assertThat(InterfaceText.lines(result))
        .contains("src/b.idl:5: error: column 1: in the struct S: '}' does not belong here");
  }

  @Test
  void aMissingIncludeIsAWarning() {
    assertThat(problems("#include <orb.idl>\ninterface A { void f(); };"))
        .containsExactly(
            "a.idl:1: warning: the included file 'orb.idl' was not found; add its folder with -I,"
                + " or with idl_includes in activity.yaml");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "#if 1 | this section has no #endif; add it",
        "#endif | #endif has no #if before it",
        "#if (1@#endif | ')' is missing",
        "#if@#endif | the expression is missing",
        "#if 1 / 0@#endif | division by zero",
        "#define | #define needs a name, and a list of parameters that is closed",
        "#define F(a, | #define needs a name, and a list of parameters that is closed",
        "#error no C here | #error no C here",
        "#includ <x> | #includ is not a directive of the preprocessor",
        "#define F(a) a@F(1, 2) | the macro F takes 1 arguments, but is called with 2",
        "#include | #include needs a file: #include \"NAME.idl\""
      })
  void reportsInvalidDirectives(String lines, String problem) {
    assertThat(problems(lines.replace("@", "\n") + "\n"))
        .anyMatch(line -> line.contains(": error: " + problem));
  }

  @Tag("slow")
  @Test
  void growthIsBounded() {
    StringBuilder text = new StringBuilder("#define M0 long x; long x;\n");
    for (int i = 1; i < 64; i++) {
      text.append("#define M%d M%d M%d M%d M%d\n".formatted(i, i - 1, i - 1, i - 1, i - 1));
    }
    text.append("interface A { M63 };");
    assertThat(problems(text.toString()))
        .containsExactly(
            "a.idl:65: error: the macros of this file expand to too much text; write the"
                + " declarations out");
    assertThat(problems("#include \"a.idl\"\n#include \"a.idl\"\ninterface A {};"))
        .anyMatch(line -> line.contains("included deeper than 200 levels"));
    StringBuilder calls = new StringBuilder("#define F(x) x\nconst long N = ");
    calls.append("F(".repeat(5_000)).append('1').append(")".repeat(5_000)).append(';');
    assertThat(problems(calls.toString())).anyMatch(line -> line.contains("nest deeper than 100"));
  }
}
