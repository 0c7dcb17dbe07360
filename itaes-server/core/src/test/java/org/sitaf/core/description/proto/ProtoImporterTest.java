package org.sitaf.core.description.proto;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.importer.InterfaceText;
import org.sitaf.core.description.source.ImportResult;

class ProtoImporterTest {
  private static final String HEAD = "syntax = \"proto3\";\npackage p;\n";

  private static ImportResult read(String text) {
    return InterfaceText.read("a.proto", HEAD + text);
  }

  @ParameterizedTest
  @CsvSource({
    "bool,boolean",
    "double,double",
    "float,float",
    "sint32,int32",
    "fixed32,uint32",
    "sfixed64,int64",
    "uint64,uint64",
    "string,string",
    "bytes,sequence<uint8>",
    "repeated int32,sequence<int32>",
    "Inner,p.M.Inner",
    "p.M.Inner,p.M.Inner",
    ".p.M.Inner,p.M.Inner",
    "E,p.E",
    "google.protobuf.Duration,google.protobuf.Duration",
    "'map<string, Inner>',sequence<p.M.FEntry>",
    "optional E,p.E"
  })
  void resolvesTypesFromTheInnermostScopeOutwards(String proto, String resolved) {
    ImportResult result =
        read(
            "enum E { ZERO = 0; }\nmessage M { message Inner { int32 a = 1; }\n "
                + proto
                + " f = 1; }");
    assertThat(InterfaceText.lines(result)).isEmpty();
    assertThat(result.types())
        .filteredOn(t -> t.typeName().equals("p.M"))
        .extracting(t -> ((DataType.Struct) t).members().get(0).type().typeName())
        .containsExactly(resolved);
  }

  @Test
  void readsEdition2023() {
    ImportResult result =
        InterfaceText.read(
            "a.proto",
            """
            edition = "2023"; // like 'syntax'
            package p;
            option features.field_presence = IMPLICIT;
            message Request {
              int32 a = 1 [features.field_presence = EXPLICIT, default = 3];
              repeated int32 xs = 2 [features.repeated_field_encoding = EXPANDED];
              Mode mode = 3;
              reserved foo, bar;
              reserved 10 to 20, 100 to max;
            }
            enum Mode { option features.enum_type = CLOSED; A = 1; B = 2; reserved C; }
            service S { rpc Do(Request) returns (Request); }
            """);
    assertThat(InterfaceText.lines(result)).isEmpty();
    assertThat(InterfaceText.prototypes(result.provided().get(0)))
        .containsExactly("p.Request Do(IN p.Request request)");
    assertThat(result.types())
        .filteredOn(t -> t.typeName().equals("p.Request"))
        .flatExtracting(t -> ((DataType.Struct) t).members())
        .extracting(m -> m.type().typeName())
        .containsExactly("int32", "sequence<int32>", "p.Mode");
  }

  @Test
  void readsEdition2024() {
    ImportResult result =
        InterfaceText.read(
            "a.proto",
            """
            edition = "2024";
            package p;
            import option "google/protobuf/descriptor.proto";
            option features.default_symbol_visibility = EXPORT_TOP_LEVEL;
            local message Inner { int32 export = 1; }
            export message Request { Inner inner = 1; export enum Local { ZERO = 0; } Local local = 2; }
            service S { rpc Do(Request) returns (Request); }
            """);
    assertThat(InterfaceText.lines(result)).isEmpty();
    assertThat(result.types())
        .extracting(DataType::typeName)
        .containsExactlyInAnyOrder("p.Inner", "p.Request", "p.Request.Local");
  }

  @Test
  void namesTheEditionsThatItReads() {
    ImportResult result = InterfaceText.read("a.proto", "edition = \"2030\";\nmessage M {}\n");
    assertThat(InterfaceText.lines(result))
        .anyMatch(line -> line.contains("the edition 2030 is not supported; 2023 and 2024 are"));
  }

  @Test
  void streamsAreSequencesOfNonblockingMethods() {
    ImportResult result =
        read(
            """
            message M {}
            service S {
              rpc Unary(M) returns (M);
              rpc Up(stream M) returns (M);
              rpc Down(M) returns (stream M);
              rpc Nothing(google.protobuf.Empty) returns (google.protobuf.Empty);
            }
            """);
    assertThat(InterfaceText.prototypes(result.provided().get(0)))
        .containsExactly(
            "p.M Unary(IN p.M request)",
            "p.M Up(IN sequence<p.M> requests)",
            "sequence<p.M> Down(IN p.M request)",
            "void Nothing()");
    assertThat(result.provided().get(0).methods())
        .extracting(Method::callType)
        .containsExactly(
            CallType.BLOCKING, CallType.NONBLOCKING, CallType.NONBLOCKING, CallType.BLOCKING);
    assertThat(result.provided().get(0).methods()).extracting(Method::line).contains(5, 8);
  }

  @Test
  void reportsProblemsWithTheirLines() {
    assertThat(
            InterfaceText.lines(
                read(
                    """
                    message M {
                      Missing m = 1;
                      M self = 2;
                    }
                    """)))
        .containsExactly(
            "a.proto:4: warning: message p.M/m: unknown type 'Missing'",
            "a.proto:5: warning: message p.M/self: type 'p.M' is not supported: part of itself");
    assertThat(InterfaceText.lines(read("message M {}\nmessage M {}")))
        .hasSize(1)
        .allMatch(l -> l.startsWith("a.proto:4: error: ") && l.contains("is already defined"));
    assertThat(
            InterfaceText.lines(
                InterfaceText.readAll(
                    Map.of("a.proto", HEAD + "message M {}", "b.proto", HEAD + "message M {}"))))
        .containsExactly("b.proto:3: error: message M: is already declared in a.proto, line 3");
    assertThat(InterfaceText.lines(read("message M {\n  int32 = 3;\n}")))
        .hasSize(1)
        .allMatch(l -> l.startsWith("a.proto:4: error: "));
  }

  @Test
  void findsImportedTypesInTheGivenFiles() {
    ImportResult result =
        InterfaceText.read(
            Map.of(
                "api/a.proto",
                HEAD + "import \"q/b.proto\";\nservice S { rpc F(q.B) returns (q.B); }",
                "q/b.proto",
                "syntax = \"proto3\"; package q; message B { double x = 1; }"),
            "api/a.proto");
    assertThat(InterfaceText.lines(result)).isEmpty();
    assertThat(result.provided().get(0).methods().get(0).returnType())
        .isInstanceOf(DataType.Struct.class);
  }
}
