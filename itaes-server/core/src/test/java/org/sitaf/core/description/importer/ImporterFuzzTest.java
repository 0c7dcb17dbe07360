package org.sitaf.core.description.importer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;

/** Importers handle any input in limited time: they report diagnostics and do not fail. */
@Tag("slow")
class ImporterFuzzTest {
  /** Limit for a million characters on a busy machine; most inputs take a fraction of a second. */
  private static final Duration SOON = Duration.ofSeconds(20);

  private static final List<String> VALID =
      List.of(
          "component.xml",
          "service.xml",
          "types.xml",
          "sensor.idl",
          "limits.msg",
          "get.srv",
          "move.action",
          "planner.proto");

  private static byte[] valid(String name) {
    try (InputStream in = ImporterFuzzTest.class.getResourceAsStream("fuzz/" + name)) {
      return java.util.Objects.requireNonNull(in, name).readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static ImportResult read(String path, byte[] content) {
    return assertTimeoutPreemptively(
        SOON,
        () -> InterfaceFiles.read(SourceFiles.of("fuzz", Map.of(path, content), List.of(path))));
  }

  private static void assertHandled(String path, byte[] content) {
    ImportResult result = read(path, content);
    result.diagnostics().forEach(d -> assertThat(d.file()).isNotNull());
    // The result can be printed and is finite.
    result.provided().forEach(i -> assertThat(InterfaceText.prototypes(i)).isNotNull());
    assertThat(result.hashCode()).isEqualTo(result.hashCode());
  }

  @Example
  void undamagedFilesAreValid() {
    for (String name : VALID) {
      assertThat(read(name, valid(name)).diagnostics())
          .as(name)
          .noneMatch(
              d -> d.toString().contains(": error: ") && !d.message().startsWith("references"));
    }
  }

  @Property(tries = 1500)
  void handlesDamagedFiles(@ForAll("damaged") Input input) {
    assertHandled(input.path(), input.content());
  }

  @Property(tries = 300)
  void handlesArbitraryBytes(@ForAll("names") String name, @ForAll byte[] content) {
    assertHandled(name, content);
  }

  record Input(String path, byte[] content) {
    @Override
    public String toString() {
      return path + ":\n" + new String(content, StandardCharsets.UTF_8);
    }
  }

  @Provide
  Arbitrary<String> names() {
    return Arbitraries.of(VALID);
  }

  @Provide
  Arbitrary<Input> damaged() {
    return Combinators.combine(
            names(),
            Arbitraries.integers().between(0, 5),
            Arbitraries.integers().between(1, 6),
            Arbitraries.longs())
        .as(
            (name, kind, times, seed) -> {
              byte[] content = valid(name);
              Random random = new Random(seed);
              for (int i = 0; i < times && content.length > 0; i++) {
                content = damage(content, kind, random);
              }
              return new Input(name, content);
            });
  }

  private static byte[] damage(byte[] content, int kind, Random random) {
    return switch (kind) {
      case 0 -> Arrays.copyOf(content, random.nextInt(content.length));
      case 1 -> flipped(content, random);
      case 2 -> shuffled(content, random, true);
      case 3 -> shuffled(content, random, false);
      case 4 -> spliced(content, random);
      default -> joined(content, valid(VALID.get(random.nextInt(VALID.size()))), random);
    };
  }

  private static byte[] flipped(byte[] content, Random random) {
    byte[] flipped = content.clone();
    flipped[random.nextInt(flipped.length)] ^= (byte) (1 << random.nextInt(8));
    return flipped;
  }

  /** Swaps two tokens, or shuffles the tokens of a range. */
  private static byte[] shuffled(byte[] content, Random random, boolean two) {
    List<String> tokens =
        new ArrayList<>(
            List.of(new String(content, StandardCharsets.UTF_8).split("(?<=\\W)|(?=\\W)")));
    if (two) {
      Collections.swap(tokens, random.nextInt(tokens.size()), random.nextInt(tokens.size()));
    } else {
      int from = random.nextInt(tokens.size());
      int to = Math.min(tokens.size(), from + 2 + random.nextInt(20));
      Collections.shuffle(tokens.subList(from, to), random);
    }
    return String.join("", tokens).getBytes(StandardCharsets.UTF_8);
  }

  /** Deletes, duplicates or replaces a range by text with a special meaning in some format. */
  private static byte[] spliced(byte[] content, Random random) {
    String text = new String(content, StandardCharsets.ISO_8859_1);
    int from = random.nextInt(text.length());
    int to = Math.min(text.length(), from + random.nextInt(30));
    String[] special = {
      "",
      "{",
      "}}}",
      "\"",
      "'",
      "/*",
      "//",
      "#",
      "\\",
      "<",
      ">>",
      "99999999999999999999",
      "-1",
      "\0",
      "&amp;",
      "<!DOCTYPE a>",
      "]]>",
      "::",
      "---",
      "[<=]",
      "option",
      "max",
      text.substring(from, to).repeat(3)
    };
    String splice = special[random.nextInt(special.length)];
    return (text.substring(0, from) + splice + text.substring(to))
        .getBytes(StandardCharsets.ISO_8859_1);
  }

  private static byte[] joined(byte[] content, byte[] other, Random random) {
    byte[] joined = Arrays.copyOf(content, content.length + other.length);
    int at = random.nextInt(content.length);
    System.arraycopy(other, 0, joined, at, other.length);
    return joined;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{",
        "(",
        "[",
        "<",
        "<a>",
        "module m {",
        "struct s {",
        "interface i {",
        "sequence<",
        "typedef sequence<",
        "message m {",
        "enum e {",
        "option (a) = {",
        "const long x = (",
        "const long x = -",
        "[[",
        "list<",
        "}",
        ">",
        "/*",
        "//",
        "\"",
        "'",
        "#",
        "\\",
        "@a(",
        "annotation ",
        "union u switch (",
        "a",
        "1",
        "9.",
        "::a",
        " ",
        "\t",
        "-",
        "1+",
        "1<<",
        "a.",
        "a,",
        "int32 a\n",
        "---\n",
        "[]",
        "int32[]",
        "<component_profile>",
        "&",
        "\u0000"
      })
  void handlesLongRepetitions(String thing) {
    byte[] content = thing.repeat((1 << 18) / thing.length()).getBytes(StandardCharsets.UTF_8);
    for (String name : List.of("a.xml", "a.idl", "a.msg", "a.srv", "a.proto")) {
      assertHandled(name, content);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "const long x = %s1;|-",
        "const long x = %s1;|1+",
        "const long x = 1%s;|<<1",
        "typedef long x%s;|[2]",
        "interface a { void f(%sin long z); };|in long b,",
        "interface a { %s };|void f();",
        "%s|interface a {};",
        "%s|typedef long a;",
        "struct s { %s };|long a;",
        "enum e { %sb };|a,",
        "typedef %slong a;|x::",
        "struct s { long %sb; };|a,",
        "%sinterface a {};|@a ",
        "interface a { void f(%sin long b); };|@a(b=c) "
      })
  void handlesLongListsInIdl(String pattern) {
    String[] parts = pattern.split("\\|");
    String text = parts[0].formatted(parts[1].repeat((1 << 18) / parts[1].length()));
    assertHandled("a.idl", text.getBytes(StandardCharsets.UTF_8));
  }

  @Example
  void handlesALineOfAMillionCharactersInEveryFormat() {
    for (String name : VALID) {
      String line = new String(valid(name), StandardCharsets.UTF_8).replace('\n', ' ');
      assertHandled(name, line.repeat((1 << 20) / line.length()).getBytes(StandardCharsets.UTF_8));
    }
  }

  @Example
  void rejectsTypesThatGrowExponentially() {
    StringBuilder idl = new StringBuilder("struct S0 { long a; };");
    StringBuilder proto = new StringBuilder("syntax = \"proto3\"; message S0 { int32 a = 1; }");
    StringBuilder xml =
        new StringBuilder("<data_type><struct name='S0'><item type='int'>a</item></struct>");
    for (int i = 1; i <= 60; i++) {
      int j = i - 1;
      idl.append("struct S%d { S%d a, b; };".formatted(i, j));
      proto.append("message S%d { S%d a = 1; S%d b = 2; }".formatted(i, j, j));
      xml.append(
          "<struct name='S%d'><item type='S%d'>a</item><item type='S%d'>b</item></struct>"
              .formatted(i, j, j));
    }
    xml.append("</data_type>");
    for (ImportResult result :
        List.of(
            InterfaceText.read("a.idl", idl.toString()),
            InterfaceText.read("a.proto", proto.toString()),
            InterfaceText.read("a.xml", xml.toString()))) {
      assertThat(InterfaceText.lines(result)).anyMatch(l -> l.contains("more than 100000 parts"));
    }
  }

  @Example
  void rejectsLongChainsOfTypes() {
    StringBuilder upwards = new StringBuilder("typedef sequence<long> T0;");
    StringBuilder downwards = new StringBuilder();
    for (int i = 1; i <= 5000; i++) {
      upwards.append("typedef sequence<T%d> T%d;".formatted(i - 1, i));
      downwards.append("struct S%d { S%d a; };".formatted(i, i + 1));
    }
    for (StringBuilder chain : List.of(upwards, downwards)) {
      chain.append(
          "interface A { void f(in %s p); };".formatted(chain == upwards ? "T5000" : "S1"));
      assertThat(InterfaceText.lines(InterfaceText.read("a.idl", chain.toString())))
          .anyMatch(l -> l.contains("nests deeper than 64 levels"));
    }
  }

  @Example
  void handlesLongChainsOfConstantsAndInheritance() {
    StringBuilder squares = new StringBuilder("const long C0 = 7;");
    StringBuilder backwards = new StringBuilder();
    StringBuilder inheritance = new StringBuilder("interface I0 { void f0(); };");
    for (int i = 1; i <= 3000; i++) {
      squares.append("const long C%d = C%d * C%d;".formatted(i, i - 1, i - 1));
      backwards.append("const long C%d = C%d;".formatted(i, i + 1));
      inheritance.append("interface I%d : I%d { void f%d(); };".formatted(i, i - 1, i));
    }
    String use = "typedef long T[C3000]; typedef long U[C1]; interface A { T t(); U u(); };";
    assertHandled("a.idl", (squares + use).getBytes(StandardCharsets.UTF_8));
    assertHandled("a.idl", (backwards + use).getBytes(StandardCharsets.UTF_8));
    assertHandled("a.idl", inheritance.toString().getBytes(StandardCharsets.UTF_8));
  }
}
