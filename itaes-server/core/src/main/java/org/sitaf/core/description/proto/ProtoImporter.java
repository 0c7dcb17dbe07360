package org.sitaf.core.description.proto;

import com.squareup.wire.schema.internal.parser.ProtoFileElement;
import com.squareup.wire.schema.internal.parser.RpcElement;
import com.squareup.wire.schema.internal.parser.ServiceElement;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Importer;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.Diagnostics;

/**
 * Reads protobuf services. An rpc becomes a method with a struct parameter {@code request} that
 * returns a struct. A stream becomes a sequence, and a streaming rpc becomes a non-blocking method.
 */
public final class ProtoImporter implements Importer {
  private static final String EMPTY = "google.protobuf.Empty";

  /** The well-known types of protobuf, which are not part of a user's files. */
  private static final String WELL_KNOWN =
      """
      syntax = "proto3";
      package google.protobuf;
      message Any { string type_url = 1; bytes value = 2; }
      message Duration { int64 seconds = 1; int32 nanos = 2; }
      message Empty {}
      message FieldMask { repeated string paths = 1; }
      message Timestamp { int64 seconds = 1; int32 nanos = 2; }
      message DoubleValue { double value = 1; }
      message FloatValue { float value = 1; }
      message Int64Value { int64 value = 1; }
      message UInt64Value { uint64 value = 1; }
      message Int32Value { int32 value = 1; }
      message UInt32Value { uint32 value = 1; }
      message BoolValue { bool value = 1; }
      message StringValue { string value = 1; }
      message BytesValue { bytes value = 1; }
      """;

  @Override
  public boolean supports(String path) {
    return path.endsWith(".proto");
  }

  @Override
  public void read(SourceFiles files, Findings findings) {
    new Reading(files, findings).read();
  }

  private static final class Reading {
    private final SourceFiles files;
    private final Findings findings;
    private final ProtoTypes types;
    private final Map<String, ProtoFileElement> parsed = new LinkedHashMap<>();

    Reading(SourceFiles files, Findings findings) {
      this.files = files;
      this.findings = findings;
      this.types = new ProtoTypes(findings);
    }

    void read() {
      // Requested files first: their messages take precedence over duplicates.
      files.requested().forEach(this::declare);
      files.files().keySet().stream()
          .filter(path -> path.endsWith(".proto") && !files.isRequested(path))
          .forEach(this::declare);
      ProtoSyntax.parse(WELL_KNOWN, "google/protobuf", new Diagnostics())
          .ifPresent(file -> declareTypes(file, "google/protobuf", false));
      Map<String, Integer> names = new HashMap<>();
      requested()
          .forEach(f -> f.getServices().forEach(s -> names.merge(s.getName(), 1, Integer::sum)));
      for (String path : files.requested()) {
        ProtoFileElement file = parsed.get(path);
        if (file != null) {
          file.getServices()
              .forEach(s -> describe(s, file, path, names.getOrDefault(s.getName(), 1)));
        }
      }
      types.declaredIn(files::isRequested).forEach(findings::type);
    }

    private List<ProtoFileElement> requested() {
      return files.requested().stream()
          .flatMap(path -> Optional.ofNullable(parsed.get(path)).stream())
          .toList();
    }

    private void declare(String path) {
      Diagnostics problems = new Diagnostics();
      Optional<ProtoFileElement> file = ProtoSyntax.parse(files.text(path), path, problems);
      if (files.isRequested(path)) {
        findings.addAll(problems.all());
      } else {
        findings.warnUnreadable(problems.all());
      }
      if (file.isPresent()) {
        parsed.put(path, file.get());
        declareTypes(file.get(), path, files.isRequested(path));
      }
    }

    private void declareTypes(ProtoFileElement file, String path, boolean requested) {
      file.getTypes().forEach(type -> types.declare(type, packageName(file), path, requested));
    }

    private void describe(
        ServiceElement service, ProtoFileElement file, String path, int sameName) {
      Place place = ProtoTypes.place(path, service.getLocation(), "service " + service.getName());
      String simple = findings.identifier(service.getName(), place);
      String name =
          sameName == 1 ? simple : ProtoTypes.inside(packageName(file), simple).replace('.', '_');
      List<Method> methods =
          service.getRpcs().stream().map(rpc -> method(rpc, packageName(file), path)).toList();
      InterfaceDescription description =
          new InterfaceDescription(findings.identifier(name, place), methods, path);
      findings.checkDistinct(description);
      findings.provides(description);
    }

    private Method method(RpcElement rpc, String scope, String path) {
      Place place = ProtoTypes.place(path, rpc.getLocation(), "rpc " + rpc.getName());
      String name = findings.identifier(rpc.getName(), place);
      DataType request = types.resolve(rpc.getRequestType(), scope, place);
      DataType response = types.resolve(rpc.getResponseType(), scope, place);
      boolean streams = rpc.getRequestStreaming() || rpc.getResponseStreaming();
      List<Parameter> parameters = List.of();
      if (rpc.getRequestStreaming()) {
        parameters =
            List.of(new Parameter("requests", new DataType.Sequence(request), Direction.IN));
      } else if (!request.typeName().equals(EMPTY)) {
        parameters = List.of(new Parameter("request", request, Direction.IN));
      }
      DataType returned = response;
      if (rpc.getResponseStreaming()) {
        returned = new DataType.Sequence(response);
      } else if (response.typeName().equals(EMPTY)) {
        returned = new DataType.Scalar(ScalarType.VOID);
      }
      return new Method(
          name,
          returned,
          parameters,
          streams ? CallType.NONBLOCKING : CallType.BLOCKING,
          place.line());
    }

    private static String packageName(ProtoFileElement file) {
      return file.getPackageName() == null ? "" : file.getPackageName();
    }
  }
}
