package org.sitaf.core.description.idl;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.UUID;
import java.util.stream.Collectors;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.importer.InterfaceText;
import org.sitaf.core.description.source.ImportResult;

/** Interfaces that are written as IDL and read again are unchanged. */
class IdlRoundTripTest {
  private static final Map<ScalarType, String> SPELLINGS =
      Map.ofEntries(
          Map.entry(ScalarType.BOOLEAN, "boolean"),
          Map.entry(ScalarType.CHAR, "char"),
          Map.entry(ScalarType.INT8, "int8"),
          Map.entry(ScalarType.UINT8, "octet"),
          Map.entry(ScalarType.INT16, "short"),
          Map.entry(ScalarType.UINT16, "unsigned short"),
          Map.entry(ScalarType.INT32, "long"),
          Map.entry(ScalarType.UINT32, "unsigned long"),
          Map.entry(ScalarType.INT64, "long long"),
          Map.entry(ScalarType.UINT64, "unsigned long long"),
          Map.entry(ScalarType.FLOAT, "float"),
          Map.entry(ScalarType.DOUBLE, "double"),
          Map.entry(ScalarType.STRING, "string"));

  @Property(tries = 300)
  void readsWrittenInterfacesUnchanged(@ForAll("interfaces") List<Method> methods) {
    ImportResult result = InterfaceText.read("a.idl", new Writer().write(methods));
    assertThat(InterfaceText.lines(result)).isEmpty();
    InterfaceDescription read = result.provided().get(result.provided().size() - 1);
    List<Method> withoutLines =
        read.methods().stream()
            .map(
                m ->
                    new Method(
                        m.name(), m.returnType(), m.parameters(), m.callType(), m.raises(), 0))
            .toList();
    assertThat(withoutLines).isEqualTo(methods);
  }

  @Provide
  Arbitrary<List<Method>> interfaces() {
    Arbitrary<DataType> type = type(3);
    Arbitrary<List<Parameter>> parameters =
        Combinators.combine(type, Arbitraries.of(Direction.class))
            .as((t, direction) -> new Parameter("p", t, direction))
            .list()
            .ofMaxSize(4)
            .map(IdlRoundTripTest::numbered);
    Arbitrary<Method> blocking =
        Combinators.combine(
                Arbitraries.oneOf(type, Arbitraries.just(new DataType.Scalar(ScalarType.VOID))),
                parameters,
                Arbitraries.of("M::E1", "M::E2").list().uniqueElements().ofMaxSize(2))
            .as((t, p, e) -> new Method("m", t, p, CallType.BLOCKING, e, 0));
    Arbitrary<Method> nonblocking =
        parameters.map(
            p ->
                new Method(
                    "m",
                    new DataType.Scalar(ScalarType.VOID),
                    p.stream().map(q -> new Parameter(q.name(), q.type(), Direction.IN)).toList(),
                    CallType.NONBLOCKING,
                    0));
    return Arbitraries.oneOf(blocking, nonblocking)
        .list()
        .ofMinSize(1)
        .ofMaxSize(6)
        .map(
            list -> {
              List<Method> named = new ArrayList<>();
              for (Method m : list) {
                named.add(
                    new Method(
                        "m" + named.size(),
                        m.returnType(),
                        m.parameters(),
                        m.callType(),
                        m.raises(),
                        0));
              }
              return named;
            });
  }

  private static List<Parameter> numbered(List<Parameter> parameters) {
    List<Parameter> numbered = new ArrayList<>();
    for (Parameter p : parameters) {
      numbered.add(new Parameter("p" + numbered.size(), p.type(), p.direction()));
    }
    return numbered;
  }

  private static Arbitrary<DataType> type(int depth) {
    Arbitrary<DataType> scalar =
        Arbitraries.of(SPELLINGS.keySet().stream().sorted().toList()).map(DataType.Scalar::new);
    Arbitrary<DataType> bounded =
        Arbitraries.integers().between(1, 99).map(b -> new DataType.Scalar(ScalarType.STRING, b));
    if (depth == 0) {
      return Arbitraries.oneOf(scalar, bounded);
    }
    Arbitrary<DataType> inner = type(depth - 1);
    Arbitrary<Integer> number = Arbitraries.integers().between(0, 9);
    Arbitrary<DataType> sequence =
        Combinators.combine(inner, number).as((e, b) -> new DataType.Sequence(e, b));
    Arbitrary<DataType> array =
        Combinators.combine(inner, number).as((e, n) -> new DataType.FixedArray(e, n + 1));
    // The name is derived from the content, so equal names mean equal types.
    Arbitrary<DataType> struct =
        inner
            .list()
            .ofMinSize(1)
            .ofMaxSize(3)
            .map(
                types -> {
                  List<DataType.Member> members = new ArrayList<>();
                  types.forEach(t -> members.add(new DataType.Member("f" + members.size(), t)));
                  // Equal hash codes of different types would give two structs one name.
                  UUID digest =
                      UUID.nameUUIDFromBytes(types.toString().getBytes(StandardCharsets.UTF_8));
                  String name = "S" + digest.toString().replace('-', '_');
                  return new DataType.Struct("M::" + name, members);
                });
    Arbitrary<DataType> enumeration =
        number.map(n -> new DataType.Enumeration("M::N" + n, List.of("A" + n, "B" + n)));
    return Arbitraries.oneOf(scalar, bounded, sequence, array, struct, enumeration);
  }

  /** Writes interfaces as IDL: types first, then the methods that use them. */
  private static final class Writer {
    private final Map<String, String> declarations = new LinkedHashMap<>();
    private int aliases;

    String write(List<Method> methods) {
      String body = methods.stream().map(this::write).collect(Collectors.joining("\n  "));
      return "module M {\n exception E1 { long x; };\n exception E2 {};\n "
          + String.join("\n ", declarations.values())
          + "\n};\ninterface I {\n  "
          + body
          + "\n};\n";
    }

    private String write(Method method) {
      return (method.callType() == CallType.NONBLOCKING ? "oneway " : "")
          + spelling(method.returnType())
          + " "
          + method.name()
          + method.parameters().stream()
              .map(
                  p ->
                      p.direction().name().toLowerCase(Locale.ROOT)
                          + " "
                          + spelling(p.type())
                          + " "
                          + p.name())
              .collect(Collectors.joining(", ", "(", ")"))
          + (method.raises().isEmpty()
              ? ""
              : " raises (" + String.join(", ", method.raises()) + ")")
          + ";";
    }

    private String spelling(DataType type) {
      if (type instanceof DataType.Scalar scalar) {
        return scalar.type() == ScalarType.VOID
            ? "void"
            : SPELLINGS.get(scalar.type())
                + (scalar.bound() == 0 ? "" : "<" + scalar.bound() + ">");
      }
      if (type instanceof DataType.Sequence sequence) {
        String element = spelling(sequence.element());
        return "sequence<"
            + element
            + (sequence.bound() == 0 ? ">" : ", " + sequence.bound() + ">");
      }
      if (type instanceof DataType.FixedArray array) {
        String alias = "T" + aliases++;
        String element = spelling(array.element());
        declarations.put(alias, "typedef " + element + " " + alias + "[" + array.length() + "];");
        return "M::" + alias;
      }
      if (type instanceof DataType.Struct struct) {
        String members =
            struct.members().stream()
                .map(m -> spelling(m.type()) + " " + m.name() + ";")
                .collect(Collectors.joining(" "));
        declarations.putIfAbsent(
            struct.name(), "struct " + simple(struct.name()) + " { " + members + " };");
        return struct.name();
      }
      DataType.Enumeration enumeration = (DataType.Enumeration) type;
      declarations.putIfAbsent(
          enumeration.name(),
          "enum "
              + simple(enumeration.name())
              + " { "
              + String.join(", ", enumeration.literals())
              + " };");
      return enumeration.name();
    }

    private static String simple(String qualified) {
      return qualified.substring(qualified.lastIndexOf(':') + 1);
    }
  }
}
