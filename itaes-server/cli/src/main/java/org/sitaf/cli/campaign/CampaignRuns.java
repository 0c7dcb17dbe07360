package org.sitaf.cli.campaign;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.campaign.CampaignCase;
import org.sitaf.core.campaign.CampaignModel;
import org.sitaf.core.campaign.CampaignResult;
import org.sitaf.core.campaign.Classification;
import org.sitaf.core.campaign.Observed;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.GivenCases;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/** Executes the cases of a campaign as builds on this machine. */
final class CampaignRuns {
  /** Each fault has three parameters, and a method of Java has at most 127 numbers. */
  private static final int MAX_FAULTS_PER_BUILD = 30;

  private final LocalBuilds builds;
  private final Activity activity;
  private final TestModel model;
  private final TestSuite suite;
  private final PrintWriter progress;

  /**
   * Creates an execution.
   *
   * @param model without repeated calls and relations
   * @param suite the cases of the model
   */
  CampaignRuns(
      LocalBuilds builds,
      Activity activity,
      TestModel model,
      TestSuite suite,
      PrintWriter progress) {
    this.builds = builds;
    this.activity = activity;
    this.model = model;
    this.suite = suite;
    this.progress = progress;
  }

  /** A case that passes without faults. */
  record Healthy(List<Value> values, Observed observed) {
    /** The time from the call to the end of the case. */
    double seconds() {
      Trace trace = observed.trace();
      return trace == null ? 0 : trace.seconds(trace.count() - 1);
    }
  }

  /** Runs valid cases without faults; returns those that pass, in their order. */
  List<Healthy> healthy(List<TestCase> cases) throws InterruptedException {
    Map<Integer, Observed> observed = new ConcurrentHashMap<>();
    run(model, suite.withCases(cases), (no, found) -> observed.put(no, found));
    List<Healthy> passing = new ArrayList<>();
    for (TestCase testCase : cases) {
      Observed found = observed.get(testCase.no());
      if (found != null && found.result().verdict() == Verdict.PASS) {
        passing.add(new Healthy(values(testCase), found));
      }
    }
    return passing;
  }

  /** Runs the cases with faults. */
  List<CampaignResult.Entry> faulty(
      List<CampaignCase> cases, List<Healthy> bases, Classification classification)
      throws InterruptedException {
    Map<Integer, CampaignResult.Entry> entries = new TreeMap<>();
    int done = 0;
    for (List<CampaignCase> part : parts(cases)) {
      CampaignModel extended = CampaignModel.of(model, part);
      GivenCases given = new GivenCases(extended.model());
      Map<Integer, CampaignCase> byNumber = new TreeMap<>();
      List<TestCase> rows = new ArrayList<>();
      for (CampaignCase campaignCase : part) {
        List<Value> values = bases.get(campaignCase.base()).values();
        given
            .of(campaignCase.no(), extended.row(values, campaignCase))
            .ifPresent(
                testCase -> {
                  rows.add(testCase);
                  byNumber.put(campaignCase.no(), campaignCase);
                });
      }
      if (!rows.isEmpty()) {
        run(
            extended.model(),
            suiteOf(extended.model(), rows),
            (no, observed) -> {
              CampaignCase of = byNumber.get(no);
              if (of != null) {
                classification
                    .of(bases.get(of.base()).observed(), observed)
                    .ifPresent(c -> put(entries, new CampaignResult.Entry(of, c)));
              }
            });
      }
      done += part.size();
      progress.printf("%s: %d of %d cases with faults%n", model.name(), done, cases.size());
      progress.flush();
    }
    return List.copyOf(entries.values());
  }

  private static void put(Map<Integer, CampaignResult.Entry> entries, CampaignResult.Entry entry) {
    synchronized (entries) {
      entries.put(entry.campaignCase().no(), entry);
    }
  }

  /** Cases whose faults fit into one test application. */
  private static Collection<List<CampaignCase>> parts(List<CampaignCase> cases) {
    List<List<CampaignCase>> parts = new ArrayList<>();
    List<Set<String>> names = new ArrayList<>();
    for (CampaignCase campaignCase : cases) {
      List<String> used = campaignCase.faults().stream().map(f -> f.name().text()).toList();
      int at =
          IntStream.range(0, parts.size())
              .filter(i -> fits(names.get(i), used))
              .findFirst()
              .orElse(parts.size());
      if (at == parts.size()) {
        parts.add(new ArrayList<>());
        names.add(new HashSet<>());
      }
      parts.get(at).add(campaignCase);
      names.get(at).addAll(used);
    }
    return parts;
  }

  private static boolean fits(Set<String> names, List<String> further) {
    Set<String> all = new HashSet<>(names);
    all.addAll(further);
    return all.size() <= MAX_FAULTS_PER_BUILD;
  }

  private TestSuite suiteOf(TestModel extended, List<TestCase> cases) {
    return new TestSuite(
        suite.name(),
        suite.description(),
        suite.modelName(),
        suite.generation(),
        extended.inputs().stream()
            .map(i -> new CaseParameter(i.name(), i.kind(), i.realType()))
            .toList(),
        cases);
  }

  private List<Value> values(TestCase testCase) {
    return IntStream.range(0, model.inputs().size())
        .mapToObj(i -> model.inputs().get(i).value(testCase.values().get(i)))
        .toList();
  }

  private interface Observer {
    void observed(int no, Observed observed);
  }

  private void run(TestModel tested, TestSuite cases, Observer observer)
      throws InterruptedException {
    Map<Integer, Trace> traces = new ConcurrentHashMap<>();
    BuildOutcome outcome =
        builds.observe(
            activity.withoutTiming(),
            tested,
            cases,
            0,
            false,
            new LocalBuilds.CaseObserver() {
              @Override
              public void signals(int no, Trace trace) {
                traces.put(no, trace);
              }

              @Override
              public void caseFinished(CaseResult result) {
                observer.observed(result.no(), new Observed(result, traces.remove(result.no())));
              }
            });
    var unused = builds.completed(activity, outcome);
  }
}
