package org.sitaf.core.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.campaign.CampaignResult.Cell;
import org.sitaf.core.campaign.CampaignResult.Entry;
import org.sitaf.core.campaign.Classification.Classified;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.Device;
import org.sitaf.core.description.fault.DeviceFaults;
import org.sitaf.core.description.fault.FaultKind;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.OutputKind;
import org.sitaf.core.model.Tolerance;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Verdict;

class FaultCampaignTest {
  private static final WorldDescription WORLD =
      new WorldDescription(
          "w.world.yaml",
          List.of(),
          List.of(
              new Device("ir1", "range"),
              new Device("base", "differential_drive"),
              new Device("eye", "camera")),
          List.of());
  private static final String COMMAND = "base.linear.command";

  @ParameterizedTest
  @ValueSource(doubles = {0, 4})
  void everyFaultComesAloneBeforePairs(double seconds) {
    FaultCampaign campaign = new FaultCampaign(WORLD, 3, seconds, 1);
    List<CampaignCase> cases = campaign.cases(campaign.size());

    assertThat(campaign.size())
        .isEqualTo(DeviceFaults.of("range").size() + DeviceFaults.of("differential_drive").size());
    assertThat(cases).allMatch(c -> c.faults().size() == 1);
    Set<String> names =
        cases.stream().map(c -> c.faults().get(0).name().text()).collect(Collectors.toSet());
    assertThat(names).hasSize(campaign.size()).contains("fault.base.saturated");
    assertThat(cases).allMatch(c -> c.faults().get(0).isTransient() == seconds > 0);
    assertThat(cases).extracting(CampaignCase::base).contains(0, 1, 2);
  }

  @Test
  void pairsAreOfDifferentDevicesFirstAndNeverRepeat() {
    List<CampaignCase> cases = new FaultCampaign(WORLD, 1, 4, 1).cases(200);
    assertThat(cases).hasSizeBetween(150, 200);
    assertThat(cases).extracting(CampaignCase::no).doesNotHaveDuplicates();
    Set<Set<String>> pairs = new HashSet<>();
    boolean sameDevice = false;
    for (CampaignCase campaignCase : cases) {
      if (campaignCase.faults().size() == 2) {
        assertThat(
                pairs.add(
                    campaignCase.faults().stream()
                        .map(f -> f.name().text())
                        .collect(Collectors.toSet())))
            .isTrue();
        boolean same =
            campaignCase
                .faults()
                .get(0)
                .name()
                .device()
                .equals(campaignCase.faults().get(1).name().device());
        assertThat(sameDevice && !same).isFalse();
        sameDevice = same;
      }
    }
    assertThat(pairs).hasSizeGreaterThan(80);
    assertThat(new FaultCampaign(WORLD, 1, 4, 1).cases(200)).isEqualTo(cases);
    assertThat(new FaultCampaign(WORLD, 1, 4, 2).cases(200)).isNotEqualTo(cases);
  }

  @Test
  void randomFaultsAreSingleAndFitTheirDevices() {
    List<CampaignCase> cases = new FaultCampaign(WORLD, 2, 4, 7).random(300);
    assertThat(cases).hasSize(300).allMatch(c -> c.faults().size() == 1);
    for (CampaignCase campaignCase : cases) {
      InjectedFault fault = campaignCase.faults().get(0);
      assertThat(DeviceFaults.problem(fault.name(), WORLD)).isEmpty();
      assertThat(DeviceFaults.problem(fault.name(), fault.value())).isEmpty();
    }
    assertThat(new FaultCampaign(WORLD, 2, 4, 7).random(300)).isEqualTo(cases);
  }

  @Test
  void theBehaviourFollowsFromOutputsCommandsAndConditions() {
    Observed healthy = observed(Verdict.PASS, "1.0", 0.2, 0.2, 0);
    assertThat(behaviour(healthy, healthy)).isEqualTo(Behaviour.UNCHANGED);
    assertThat(behaviour(healthy, observed(Verdict.PASS, "1.01", 0.2, 0.1, 0)))
        .isEqualTo(Behaviour.RECOVERED);
    assertThat(behaviour(healthy, observed(Verdict.PASS, "0.5", 0.2, 0, 0)))
        .isEqualTo(Behaviour.STOPPED);
    assertThat(behaviour(healthy, observed(Verdict.PASS, "0.5", 0.2, 0.2, 0.2)))
        .isEqualTo(Behaviour.BROKEN);
    assertThat(behaviour(healthy, observed(Verdict.FAIL, "1.0", 0.2, 0.2, 0)))
        .isEqualTo(Behaviour.BROKEN);
    assertThat(behaviour(healthy, observed(Verdict.ERROR, "1.0", 0.2, 0.2, 0)))
        .isEqualTo(Behaviour.CRASHED);
    assertThat(classification().of(healthy, observed(Verdict.DONT, "1.0", 0.2, 0.2, 0)))
        .isEqualTo(Optional.empty());
  }

  @Test
  void theTableShowsTheWorstOfEachFaultAndPairsThatAreWorse() {
    List<CampaignCase> cases = new FaultCampaign(WORLD, 1, 4, 1).cases(200);
    CampaignCase pair = cases.get(cases.size() - 1);
    CampaignCase single = cases.get(0);
    CampaignCase lasting =
        cases.stream()
            .filter(c -> c.no() != single.no())
            .filter(c -> c.faults().get(0).name().equals(single.faults().get(0).name()))
            .findFirst()
            .orElseThrow();
    CampaignResult result =
        new CampaignResult(
            List.of(
                entry(single, Behaviour.UNCHANGED),
                entry(lasting, Behaviour.STOPPED),
                entry(pair, Behaviour.CRASHED)));
    assertThat(result.table().get(new Cell("ir1", FaultKind.STUCK)).behaviour())
        .isEqualTo(Behaviour.STOPPED);
    assertThat(result.worsePairs()).extracting(Entry::campaignCase).containsExactly(pair);
    assertThat(result.hasFailures()).isTrue();
  }

  private static Entry entry(CampaignCase campaignCase, Behaviour behaviour) {
    return new Entry(campaignCase, new Classified(behaviour, ""));
  }

  private static Classification classification() {
    DataType type = new DataType.Scalar(ScalarType.DOUBLE);
    OutputElement output =
        new OutputElement(
            "x", OutputKind.OBSERVED, "double", type, "", null, new Tolerance(0.01, 0, 0), 0);
    return new Classification(List.of(output), WORLD);
  }

  private static Behaviour behaviour(Observed healthy, Observed faulty) {
    return classification().of(healthy, faulty).orElseThrow().behaviour();
  }

  private static Observed observed(Verdict verdict, String output, double... commands) {
    CaseResult result =
        new CaseResult(
            1,
            verdict,
            List.of(),
            List.of(),
            List.of(new NamedValue("", output)),
            null,
            verdict == Verdict.PASS ? "" : "reason");
    return new Observed(result, new Trace(0, 1_000_000, List.of(COMMAND), List.of(commands)));
  }
}
