package org.sitaf.core.activity.hardware;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.hardware.DeviceBackend.Kind;
import org.sitaf.core.activity.hardware.DeviceBackend.Range;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.Device;
import org.sitaf.core.description.WorldDescription.WorldParameter;
import org.sitaf.core.description.WorldSignals;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.NearestName;
import org.sitaf.core.document.YamlMapping;

/** Reads the entry {@code hardware} of {@code activity.yaml}. */
public final class HardwareReader {
  private static final String HARDWARE = "hardware";
  private static final String BACKEND = "backend";
  private static final String ADDRESS = "address";
  private static final String MAX_AGE = "max_age_s";
  private static final String FILE = "file";
  private static final String TOPIC = "topic";
  private static final String ENVELOPE = "envelope";
  private static final String RATE = "rate";
  private static final String INDEPENDENT = "independent_of";

  /** The entries of each backend, in addition to {@code backend}. */
  private static final Map<String, Set<String>> ENTRIES =
      Map.of(
          "sim", Set.of(),
          "provider", Set.of(ADDRESS, MAX_AGE, ENVELOPE, INDEPENDENT),
          "shadow", Set.of(ADDRESS, MAX_AGE, INDEPENDENT),
          "replay", Set.of(FILE, TOPIC, MAX_AGE, INDEPENDENT));

  private static final double MAX_AGE_LIMIT_S = 3600;
  private static final String CAMERA = "camera";

  private HardwareReader() {}

  /** Reads the devices that are not simulated. Problems are reported through the mapping. */
  public static List<DeviceBackend> read(YamlMapping root) {
    Optional<YamlMapping> found = root.mapping(HARDWARE);
    List<DeviceBackend> backends = new ArrayList<>();
    found.ifPresent(
        devices ->
            devices
                .names()
                .forEach(
                    name ->
                        devices
                            .mapping(name)
                            .flatMap(entry -> backend(name, entry, devices.line(name)))
                            .ifPresent(backends::add)));
    if (!backends.isEmpty() && !root.has("world")) {
      root.problem(HARDWARE, "needs a world, which declares the devices; add world");
    }
    if (backends.stream().anyMatch(DeviceBackend::isReal)
        && root.booleanValue("parallel").orElse(false)) {
      root.problem(HARDWARE, "a real device serves one case at a time; remove parallel: true");
    }
    if (backends.stream().anyMatch(DeviceBackend::isReal) && root.has("reference")) {
      root.problem(
          HARDWARE,
          "a real device gives a reference other readings than the component; simulate it");
    }
    return backends;
  }

  private static Optional<DeviceBackend> backend(String device, YamlMapping entry, int line) {
    String kind = entry.requiredText(BACKEND);
    Set<String> known = ENTRIES.get(kind);
    if (known == null) {
      if (entry.has(BACKEND)) {
        entry.problem(
            BACKEND,
            "must be sim, provider, replay or shadow, not '"
                + kind
                + "'"
                + NearestName.hint(kind, ENTRIES.keySet()));
      }
      return Optional.empty();
    }
    Set<String> allowed = new java.util.TreeSet<>(known);
    allowed.add(BACKEND);
    entry.allowOnly(allowed);
    if (kind.equals("sim")) {
      return Optional.empty();
    }
    boolean isReplay = kind.equals("replay");
    Map<String, Double> rates = new TreeMap<>();
    Map<String, Range> envelope = new TreeMap<>();
    entry.mapping(ENVELOPE).ifPresent(limits -> envelope(limits, envelope, rates));
    return Optional.of(
        new DeviceBackend(
            device,
            isReplay ? Kind.REPLAY : kind.equals("shadow") ? Kind.SHADOW : Kind.PROVIDER,
            address(entry),
            maxAge(entry, isReplay),
            isReplay ? entry.requiredText(FILE) : null,
            entry.text(TOPIC).orElse(""),
            envelope,
            rates,
            entry.texts(INDEPENDENT),
            line));
  }

  private static @Nullable String address(YamlMapping entry) {
    Optional<String> address = entry.text(ADDRESS);
    if (address.isPresent() && !DeviceBackend.isAddress(address.get())) {
      entry.problem(
          ADDRESS,
          "'" + address.get() + "' is not an address; write " + DeviceBackend.ADDRESS_FORM);
    }
    return address.orElse(null);
  }

  private static double maxAge(YamlMapping entry, boolean isReplay) {
    Optional<Double> age = entry.number(MAX_AGE);
    if (age.isPresent() && (age.get() <= 0 || age.get() > MAX_AGE_LIMIT_S)) {
      entry.problem(MAX_AGE, "must be above 0 and at most 3600 seconds");
    }
    return age.orElse(isReplay ? 0 : DeviceBackend.DEFAULT_MAX_AGE_S);
  }

  private static void envelope(
      YamlMapping limits, Map<String, Range> envelope, Map<String, Double> rates) {
    for (String name : limits.names()) {
      if (name.equals(RATE)) {
        limits
            .mapping(RATE)
            .ifPresent(
                each ->
                    each.names()
                        .forEach(n -> positive(each, n).ifPresent(rate -> rates.put(n, rate))));
        continue;
      }
      List<String> pair =
          limits.items(name).stream().map(i -> i.text() == null ? "" : i.text()).toList();
      if (pair.size() == 1) {
        positive(limits, name).ifPresent(most -> envelope.put(name, new Range(-most, most)));
        continue;
      }
      try {
        double min = Double.parseDouble(pair.get(0));
        double max = Double.parseDouble(pair.get(1));
        if (pair.size() == 2 && min <= max) {
          envelope.put(name, new Range(min, max));
          continue;
        }
      } catch (NumberFormatException | IndexOutOfBoundsException e) {
        // Reported below.
      }
      limits.problem(name, "must be [MIN, MAX], or one number for both directions");
    }
  }

  private static Optional<Double> positive(YamlMapping entry, String name) {
    Optional<Double> number = entry.number(name);
    if (number.isPresent() && number.get() <= 0) {
      entry.problem(name, "must be above 0");
      return Optional.empty();
    }
    return number;
  }

  /** Verifies the devices against the world and the files of the activity. */
  public static void verify(
      List<DeviceBackend> backends,
      WorldDescription world,
      FileTree files,
      String profile,
      Diagnostics diagnostics) {
    List<String> names = world.devices().stream().map(Device::name).toList();
    List<String> parameters = world.parameters().stream().map(WorldParameter::name).toList();
    for (DeviceBackend backend : backends) {
      String where = HARDWARE + "." + backend.device();
      Optional<Device> device =
          world.devices().stream().filter(d -> d.name().equals(backend.device())).findFirst();
      if (device.isEmpty()) {
        diagnostics.error(
            profile,
            backend.line(),
            where,
            world.path()
                + " has no such device"
                + NearestName.hint(backend.device(), names)
                + " It has "
                + String.join(", ", names));
        continue;
      }
      if (device.get().kind().equals(CAMERA)) {
        diagnostics.error(
            profile, backend.line(), where, "is a camera, which can only be simulated");
      }
      List<String> commands = WorldSignals.commands(device.get().kind());
      for (Map<String, ?> limits : List.of(backend.envelope(), backend.rates())) {
        for (String number : limits.keySet()) {
          if (!commands.contains(number)) {
            diagnostics.error(
                profile,
                backend.line(),
                where + "." + ENVELOPE,
                "commands of a "
                    + device.get().kind()
                    + " have no number '"
                    + number
                    + "'"
                    + NearestName.hint(number, commands)
                    + (commands.isEmpty() ? "; remove it" : ""));
          }
        }
      }
      for (String name : backend.independentOf()) {
        if (!parameters.contains(name)) {
          diagnostics.error(
              profile,
              backend.line(),
              where + "." + INDEPENDENT,
              world.path()
                  + " has no parameter '"
                  + name
                  + "'"
                  + NearestName.hint(name, parameters));
        }
      }
      file(backend, files, profile, where, diagnostics);
    }
  }

  private static void file(
      DeviceBackend backend,
      FileTree files,
      String profile,
      String where,
      Diagnostics diagnostics) {
    String file = backend.file();
    if (file == null || file.isEmpty()) {
      return;
    }
    if (!file.endsWith(".csv") && !file.endsWith(".mcap")) {
      diagnostics.error(
          profile, backend.line(), where + "." + FILE, "must be a .csv or .mcap file");
    } else if (!files.contains(file)) {
      diagnostics.error(
          profile,
          backend.line(),
          where + "." + FILE,
          "'" + file + "' does not exist in the activity");
    } else if (file.endsWith(".mcap") == backend.topic().isEmpty()) {
      diagnostics.error(
          profile,
          backend.line(),
          where + "." + TOPIC,
          file.endsWith(".mcap") ? "names the topic of an MCAP file; add it" : "is only for .mcap");
    }
  }
}
