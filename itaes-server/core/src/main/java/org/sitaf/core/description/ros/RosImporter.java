package org.sitaf.core.description.ros;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.ros.RosName.Kind;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Importer;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.description.source.SourceFiles;

/**
 * Reads interface files of ROS 2. A package becomes an interface; each service and action becomes a
 * method whose parameters are the fields of the request or goal. A response or result with a single
 * field becomes the return value; several fields become out-parameters. The feedback of an action
 * is an out-parameter with one element per message.
 */
public final class RosImporter implements Importer {
  private static final Pattern PACKAGE_NAME = Pattern.compile("<name>\\s*([^<>\\s]+)\\s*</name>");

  @Override
  public boolean supports(String path) {
    return Kind.of(path).isPresent();
  }

  @Override
  public void read(SourceFiles files, Findings findings) {
    new Reading(files, findings).read();
  }

  private static final class Reading {
    private final SourceFiles files;
    private final Findings findings;
    private final RosTypes types;
    private final Map<String, Optional<String>> packageNames = new HashMap<>();

    Reading(SourceFiles files, Findings findings) {
      this.files = files;
      this.findings = findings;
      this.types = new RosTypes(findings);
    }

    void read() {
      List<RosFile> requested = new ArrayList<>();
      for (String path : files.requested()) {
        RosFile file = RosFile.read(files.text(path), path, name(path), findings);
        requested.add(file);
        declareMessage(file);
      }
      for (String path : files.files().keySet()) {
        if (!files.isRequested(path) && Kind.of(path).orElse(Kind.SRV) == Kind.MSG) {
          Findings ignored = new Findings();
          declareMessage(RosFile.read(files.text(path), path, name(path), ignored));
          findings.warnUnreadable(ignored.result().diagnostics());
        }
      }
      Map<String, List<RosFile>> packages = new TreeMap<>();
      for (RosFile file : requested) {
        if (file.name().kind() != Kind.MSG) {
          packages.computeIfAbsent(interfaceName(file), p -> new ArrayList<>()).add(file);
        }
      }
      packages.forEach(this::describe);
      types.declaredIn(files::isRequested).forEach(findings::type);
    }

    private void declareMessage(RosFile file) {
      file.constants().forEach(findings::constant);
      if (file.name().kind() == Kind.MSG) {
        types.declare(file);
      }
    }

    private void describe(String name, List<RosFile> services) {
      List<Method> methods = services.stream().map(this::method).toList();
      String source = services.get(0).path();
      InterfaceDescription description =
          new InterfaceDescription(
              findings.identifier(name, new Place(source, 0, "package")), methods, source);
      findings.checkDistinct(description);
      findings.provides(description);
    }

    private Method method(RosFile file) {
      String name = findings.identifier(file.name().name(), new Place(file.path(), 0, "file name"));
      List<Parameter> parameters = new ArrayList<>();
      file.sections().get(0).forEach(f -> parameters.add(parameter(f, f.name(), file, false)));
      Set<String> taken =
          parameters.stream().map(Parameter::name).collect(Collectors.toCollection(HashSet::new));
      List<RosFile.Field> results = file.sections().get(1);
      DataType returned = new DataType.Scalar(ScalarType.VOID);
      if (results.size() == 1) {
        returned = types.resolve(results.get(0), file);
      } else {
        for (RosFile.Field field : results) {
          parameters.add(parameter(field, free(field.name(), "result_", taken), file, true));
        }
      }
      if (file.name().kind() == Kind.ACTION && !file.sections().get(2).isEmpty()) {
        DataType feedback =
            types.struct(file.name().qualified("Feedback"), file.sections().get(2), file);
        parameters.add(
            new Parameter(
                free("feedback", "action_", taken),
                new DataType.Sequence(feedback),
                Direction.OUT));
      }
      return new Method(name, returned, parameters, CallType.BLOCKING, 1);
    }

    private Parameter parameter(RosFile.Field field, String name, RosFile file, boolean isResult) {
      return new Parameter(
          name, types.resolve(field, file), isResult ? Direction.OUT : Direction.IN);
    }

    /** Request and response may have fields of the same name; parameters must be unique. */
    private static String free(String name, String prefix, Set<String> taken) {
      String free = name;
      while (!taken.add(free)) {
        free = prefix + free;
      }
      return free;
    }

    /** The package name. A file without a package becomes its own interface. */
    private static String interfaceName(RosFile file) {
      return file.name().packageName().isEmpty() ? file.name().name() : file.name().packageName();
    }

    private RosName name(String path) {
      Kind kind = Kind.of(path).orElseThrow();
      String[] folders = path.split("/", -1);
      String file = folders[folders.length - 1];
      String name = file.substring(0, file.length() - kind.folder().length() - 1);
      boolean inFolder =
          folders.length > 1 && Kind.of("." + folders[folders.length - 2]).isPresent();
      if (!inFolder) {
        return new RosName("", kind, name);
      }
      String folder = path.substring(0, path.length() - file.length());
      String parent = folder.substring(0, folder.lastIndexOf('/', folder.length() - 2) + 1);
      String packageName = folders.length > 2 ? folders[folders.length - 3] : files.name();
      return new RosName(declaredName(parent).orElse(identifier(packageName)), kind, name);
    }

    /** The package name in the {@code package.xml} of a folder. */
    private Optional<String> declaredName(String folder) {
      return packageNames.computeIfAbsent(
          folder,
          f -> {
            if (!files.files().containsKey(f + "package.xml")) {
              return Optional.empty();
            }
            Matcher name = PACKAGE_NAME.matcher(files.text(f + "package.xml"));
            return name.find() ? Optional.of(identifier(name.group(1))) : Optional.empty();
          });
    }

    private static String identifier(String text) {
      return text.replace('-', '_').replace('.', '_');
    }
  }
}
