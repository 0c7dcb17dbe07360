package org.sitaf.core.campaign;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.Device;
import org.sitaf.core.description.fault.DeviceFaults;
import org.sitaf.core.description.fault.FaultKind;
import org.sitaf.core.description.fault.FaultName;

/**
 * Plans the cases of a campaign: first every fault for some time, then every fault from the call to
 * the end, then other values of the same faults, then pairs of faults of different devices, and of
 * the same device.
 */
public final class FaultCampaign {
  private static final MathContext DIGITS = new MathContext(3);

  /** The part of a case after which a fault begins, and that it lasts. */
  private static final double QUARTER = 0.25;

  private final WorldDescription world;
  private final int bases;
  private final double seconds;
  private final long seed;

  /**
   * A campaign.
   *
   * @param bases number of cases without faults
   * @param seconds shortest duration of these cases after the call
   * @param seed of the order of pairs
   */
  public FaultCampaign(WorldDescription world, int bases, double seconds, long seed) {
    if (bases < 1) {
      throw new IllegalArgumentException("a campaign needs a case without faults");
    }
    this.world = world;
    this.bases = bases;
    this.seconds = seconds;
    this.seed = seed;
  }

  /** The number of faults that the devices can have, which is the smallest number of cases. */
  public int size() {
    return names().size();
  }

  /**
   * Plans the cases.
   *
   * @param most maximum number, at least {@link #size}
   */
  public List<CampaignCase> cases(int most) {
    List<List<InjectedFault>> chosen = new ArrayList<>();
    boolean moves = seconds > 0;
    if (moves) {
      names().forEach(name -> chosen.add(List.of(transientFault(name, value(name.kind(), 0)))));
    }
    names().forEach(name -> chosen.add(List.of(lasting(name, value(name.kind(), 0)))));
    for (FaultName name : names()) {
      double other = value(name.kind(), 1);
      if (other != value(name.kind(), 0)) {
        chosen.add(List.of(moves ? transientFault(name, other) : lasting(name, other)));
      }
    }
    if (chosen.size() < most) {
      chosen.addAll(pairs(true));
      chosen.addAll(pairs(false));
    }
    List<CampaignCase> cases = new ArrayList<>();
    for (List<InjectedFault> faults : chosen.subList(0, Math.min(most, chosen.size()))) {
      cases.add(new CampaignCase(cases.size() + 1, cases.size() % bases, faults));
    }
    return cases;
  }

  /** As many single faults with random values and times, to compare a campaign with. */
  public List<CampaignCase> random(int count) {
    Random random = new Random(seed);
    List<FaultName> names = names();
    List<CampaignCase> cases = new ArrayList<>();
    for (int no = 1; no <= count; no++) {
      FaultName name = names.get(random.nextInt(names.size()));
      double begin = rounded(random.nextDouble() * seconds);
      double length = rounded(random.nextDouble() * seconds);
      cases.add(
          new CampaignCase(
              no,
              random.nextInt(bases),
              List.of(
                  new InjectedFault(
                      name,
                      randomValue(name.kind(), random),
                      begin,
                      length > 0 ? length : Double.POSITIVE_INFINITY))));
    }
    return cases;
  }

  private static double randomValue(FaultKind kind, Random random) {
    double share = random.nextDouble();
    return rounded(
        switch (kind) {
          case OFFSET -> 2 * share - 1;
          case SCALE -> 3 * share;
          case NOISE, INTERMITTENT, DELAY -> share;
          default -> 1;
        });
  }

  private static double rounded(double value) {
    return new BigDecimal(value).round(DIGITS).doubleValue();
  }

  private List<FaultName> names() {
    List<FaultName> names = new ArrayList<>();
    for (Device device : world.devices()) {
      for (FaultKind kind : DeviceFaults.of(device.kind())) {
        names.add(new FaultName(device.name(), "", kind, FaultName.Part.FAULT));
      }
    }
    return names;
  }

  /** Pairs of transient faults that overlap, in random order. */
  private List<List<InjectedFault>> pairs(boolean ofDifferentDevices) {
    List<FaultName> names = names();
    List<List<InjectedFault>> pairs = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      for (int j = i + 1; j < names.size(); j++) {
        FaultName first = names.get(i);
        FaultName second = names.get(j);
        if (first.device().equals(second.device()) != ofDifferentDevices) {
          pairs.add(List.of(ofPair(first), ofPair(second)));
        }
      }
    }
    Collections.shuffle(pairs, new Random(seed));
    return pairs;
  }

  private InjectedFault ofPair(FaultName name) {
    double value = value(name.kind(), 0);
    return seconds > 0 ? transientFault(name, value) : lasting(name, value);
  }

  private InjectedFault transientFault(FaultName name, double value) {
    double quarter = rounded(QUARTER * seconds);
    return new InjectedFault(name, value, quarter, quarter);
  }

  private static InjectedFault lasting(FaultName name, double value) {
    return new InjectedFault(name, value, 0, Double.POSITIVE_INFINITY);
  }

  /** Usual values of a fault. */
  private static double value(FaultKind kind, int index) {
    double[] values =
        switch (kind) {
          case OFFSET -> new double[] {0.5, -0.5};
          case SCALE -> new double[] {2, 0.5};
          case NOISE -> new double[] {0.1, 0.5};
          case DELAY -> new double[] {0.3, 1};
          case INTERMITTENT -> new double[] {0.5, 0.1};
          default -> new double[] {1, 1};
        };
    return values[index];
  }
}
