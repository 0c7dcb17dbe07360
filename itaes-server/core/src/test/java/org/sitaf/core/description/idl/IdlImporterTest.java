package org.sitaf.core.description.idl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.importer.InterfaceText;
import org.sitaf.core.description.source.ImportResult;

class IdlImporterTest {
  private static ImportResult read(String text) {
    return InterfaceText.read("a.idl", text);
  }

  private static List<String> prototypes(String text) {
    ImportResult result = read(text);
    assertThat(InterfaceText.lines(result)).isEmpty();
    return InterfaceText.prototypes(result.provided().get(result.provided().size() - 1));
  }

  @ParameterizedTest
  @CsvSource({
    "short,int16",
    "long,int32",
    "long long,int64",
    "unsigned short,uint16",
    "unsigned long,uint32",
    "unsigned long long,uint64",
    "octet,uint8",
    "int8,int8",
    "uint64,uint64",
    "float,float",
    "double,double",
    "boolean,boolean",
    "char,char",
    "wchar,char",
    "string,string",
    "wstring,string",
    "string<8>,string<8>",
    "sequence<long>,sequence<int32>"
  })
  void integersHaveTheWidthsOfIdl(String idl, String resolved) {
    assertThat(prototypes("interface A { " + idl + " get(); };"))
        .containsExactly(resolved + " get()");
  }

  @Test
  void findsNamesInTheInnermostAndInheritedScopes() {
    assertThat(
            prototypes(
                """
                struct S { octet outer; };
                module M {
                  struct S { octet inner; };
                  interface Base { struct Own { long a; }; void base(in Own o); };
                  interface A : Base { void f(in S s, in ::S t, in Own o, in M::S u); };
                };
                """))
        .containsExactly(
            "void base(IN M::Base::Own o)",
            "void f(IN M::S s, IN S t, IN M::Base::Own o, IN M::S u)");
  }

  @Test
  void inheritsACommonBaseOnce() {
    assertThat(
            prototypes(
                """
                interface Top { void t(); };
                interface L : Top { void l(); };
                interface R : Top { void r(); };
                interface A : L, R { void a(); };
                """))
        .containsExactly("void t()", "void l()", "void r()", "void a()");
  }

  @Test
  void inheritsFromATypedefOfAnInterface() {
    ImportResult result =
        read(
            """
            module SDOPackage { interface SDO { void s(); }; };
            module RTC {
              typedef SDOPackage::SDO DistributedObject;
              typedef DistributedObject Base;
              interface A : Base { void a(); };
            };
            """);

    assertThat(InterfaceText.lines(result)).noneMatch(line -> line.contains("error"));
    assertThat(InterfaceText.prototypes(result.provided().get(1)))
        .containsExactly("void s()", "void a()");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "typedef Y X; typedef X Y; interface A : X { void a(); };",
        "interface A : A::X { typedef A::X X; void a(); };",
        "typedef sequence<long> X; interface A : X { void a(); };",
      })
  void refusesATypedefThatIsNoInterface(String idl) {
    assertThat(InterfaceText.lines(read(idl))).anyMatch(line -> line.contains("inherits from"));
  }

  @ParameterizedTest
  @CsvSource({
    "any,a value of any type",
    "Object,a reference to an object",
    "ValueBase,a value type",
    "long double,wider than 64 bits",
  })
  void saysWhyATypeIsNotSupported(String type, String reason) {
    assertThat(InterfaceText.lines(read("interface A { void f(in " + type + " x); };")))
        .anyMatch(line -> line.endsWith("type '" + type + "' is not supported: " + reason));
  }

  @ParameterizedTest
  @CsvSource({
    "4,4",
    "0x10,16",
    "010,8",
    "(1 + 2) * 3 - 10 / 3,6",
    "1 << 4 | 1,17",
    "~0 & 7,7",
    "-(-5),5",
    "N % 4,3",
    "M::K,12",
    "0xF ^ 0x3,12",
    "255 >> 4,15"
  })
  void evaluatesLengths(String expression, int length) {
    String text =
        "const long N = 7; module M { const long K = N + 5; };"
            + "typedef octet T["
            + expression
            + "]; interface A { T get(); };";
    assertThat(prototypes(text)).containsExactly("uint8[" + length + "] get()");
  }

  @ParameterizedTest
  @CsvSource({
    "0,'a length or bound must be at least 1, not 0'",
    "NONE,unknown constant 'NONE'",
    "1 / 0,division by zero",
    "1 << 99,a shift must be by 0 to 63 bits",
    "LOOP,the constant 'LOOP' is defined in terms of itself",
    "TEXT,'\"four\" is not a whole number'"
  })
  void reportsAnInvalidLengthWithItsLine(String expression, String problem) {
    ImportResult result =
        read(
            "const long LOOP = LOOP + 1;\nconst string TEXT = \"four\";\ntypedef long T["
                + expression
                + "];\ninterface A { T get(); };");
    assertThat(InterfaceText.lines(result))
        .hasSize(1)
        .allMatch(l -> l.startsWith("a.idl:3: error: typedef T: "))
        .allMatch(l -> l.replace("'", "").contains(problem.replace("'", "")));
  }

  @Test
  void keepsLargeBounds() {
    assertThat(
            prototypes(
                """
                typedef string<1600000000> Text;
                typedef octet Image[1000000000];
                @default("none") typedef sequence<Image, 99999999999> Images;
                interface A { Images get(in Text t); };
                """))
        .containsExactly("sequence<uint8[1000000000]> get(IN string<1600000000> t)");
  }

  @Test
  void aOnewayMethodIsNonblockingAndReturnsNothing() {
    Method method =
        read("interface A { oneway void go(in long x); };").provided().get(0).methods().get(0);
    assertThat(method.callType()).isEqualTo(CallType.NONBLOCKING);
    assertThat(InterfaceText.lines(read("interface A {\noneway long go(); };")))
        .containsExactly("a.idl:2: error: method go: is oneway and must not return anything");
  }

  @Test
  void removesDirectivesAndComments() {
    assertThat(
            prototypes(
                """
                #pragma prefix "org.sitaf"
                #define LONG \\
                   continued { ( [
                // { not a block
                /* nor { this
                */
                interface A { void f(); };
                """))
        .containsExactly("void f()");
  }

  @Test
  void findsTypesInOtherFiles() {
    ImportResult result =
        InterfaceText.read(
            Map.of(
                "a.idl",
                "#include \"t.idl\"\ninterface A { M::P get(); };",
                "t.idl",
                "module M { struct P { double x; }; };"),
            "a.idl");
    assertThat(InterfaceText.lines(result)).isEmpty();
    assertThat(result.provided().get(0).methods().get(0).returnType())
        .isInstanceOf(DataType.Struct.class);
    assertThat(result.types()).isEmpty();
  }

  @Test
  void distinguishesInterfacesOfTheSameNameInTwoModules() {
    assertThat(
            read("module M { interface A { void f(); }; }; module N { interface A { void f(); };"
                    + " };")
                .provided())
        .extracting(InterfaceDescription::name)
        .containsExactly("M_A", "N_A");
  }

  @Test
  void reportsAllSyntaxErrorsWithLineAndColumn() {
    assertThat(InterfaceText.lines(read("interface A {\n  void f(in long);\n  long g(;\n};")))
        .hasSize(2)
        .satisfies(l -> assertThat(l.get(0)).startsWith("a.idl:2: error: column 17: "))
        .satisfies(l -> assertThat(l.get(1)).startsWith("a.idl:3: error: column 10: "));
  }

  @Test
  void reportsContradictionsWithTheirLines() {
    assertThat(
            InterfaceText.lines(
                read(
                    """
                    struct S { long a; long a; };
                    struct S { long b; };
                    interface A : Missing, S { void f(in S s, in S s); };
                    interface B : C { };
                    interface C : B { void g(in B b); };
                    valuetype V { public long x; };
                    """)))
        .containsExactlyInAnyOrder(
            "a.idl:2: error: struct S: is already declared in a.idl, line 1",
            "a.idl:6: warning: valuetype: is not part of an interface, ignored",
            "a.idl:3: error: interface A: inherits from 'Missing', which is not declared in any"
                + " file; add the file that declares it",
            "a.idl:3: error: interface A: inherits from 'S', which is no interface",
            "a.idl:1: error: struct S/a: two members have this name",
            "a.idl:3: error: method f/param s: two parameters have this name",
            "a.idl:4: error: interface B: inherits from itself",
            "a.idl:5: error: interface C: inherits from itself",
            "a.idl:5: warning: method g/param b: type 'B' is not supported: an interface",
            "a.idl:5: warning: method g/param b: type 'B' is not supported: an interface");
  }
}
