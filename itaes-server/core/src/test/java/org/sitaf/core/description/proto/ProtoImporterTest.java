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
