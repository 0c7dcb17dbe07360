package org.sitaf.server.suite;

import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.server.activity.Workspaces;
import org.sitaf.server.computation.Computations;
import org.sitaf.server.quota.Quotas;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.web.Requests;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** The suites on the server. */
@Service
public class Suites {
  /** Of all suites in memory together. */
  private static final int MAX_CASES = 500_000;

  private static final Duration KEPT = Duration.ofMinutes(30);

  private final SuiteRepository suites;
  private final Workspaces workspaces;
  private final Quotas quotas;
  private final TransactionTemplate transaction;
  private final Clock clock;
  private final SuiteDocuments documents;
  private final SuiteRevisions revisions;
  private final Computations computations;

  /**
   * The suites used last, as read from their documents: a person who scrolls through 100,000 cases
   * must not have them parsed for every page.
   */
  private final Cache<Key, TestSuite> parsed =
      Caffeine.newBuilder()
          .maximumWeight(MAX_CASES)
          .weigher((Key key, TestSuite suite) -> suite.cases().size())
          .expireAfterAccess(KEPT)
          .build();

  private record Key(String id, long version) {}

  Suites(
      SuiteRepository suites,
      Workspaces workspaces,
      Quotas quotas,
      TransactionTemplate transaction,
      Clock clock,
      SuiteDocuments documents,
      SuiteRevisions revisions,
      Computations computations) {
    this.suites = suites;
    this.workspaces = workspaces;
    this.quotas = quotas;
    this.documents = documents;
    this.revisions = revisions;
    this.computations = computations;
    this.transaction = transaction;
    this.clock = clock;
  }

  /**
   * The test application that executes a suite, generated from the present state of its activity.
   *
   * @throws Refusal when there is no such suite, or its model has changed so that it no longer fits
   * @throws org.sitaf.core.diagnostic.InvalidInputException when no application can be made of it
   */
  public TestApplication application(String suiteId) {
    StoredSuite stored = find(suiteId);
    Activity activity = workspaces.activity(stored.activityId());
    TestModel model = Workspaces.model(activity, stored.model());
    TestSuite suite = suite(stored);
    requireFit(suite, model);
    return InterfaceTestApplicationGenerator.generate(activity, model, suite);
  }

  /**
   * What a suite belongs to, whether or not an application can be made of it.
   *
   * @throws Refusal when there is no such suite
   */
  public SuiteOrigin origin(String suiteId) {
    StoredSuite stored = find(suiteId);
    return new SuiteOrigin(
        stored.activityId(), workspaces.name(stored.activityId()), stored.id(), stored.model());
  }

  /**
   * Makes sure that an activity has a model.
   *
   * @throws Refusal when it has not
   */
  public void requireModel(String activityId, String modelName) {
    Workspaces.model(workspaces.activity(activityId), modelName);
  }

  /**
   * Makes a suite from the present state of a model.
   *
   * @param seed null as a suite is generated without one
   * @return its id
   * @throws org.sitaf.core.diagnostic.InvalidInputException when the model gives none
   */
  public String generateAnew(String activityId, String modelName, @Nullable Long seed) {
    return generate(activityId, modelName, new SuiteOptions(seed, null, null).toGeneration());
  }

  String generate(String activityId, String modelName, GenerationOptions options) {
    TestModel model = Workspaces.model(workspaces.activity(activityId), modelName);
    GeneratedSuite generated =
        computations.generation(
            "The generation of the suite", () -> TestCaseGenerator.generate(model, options));
    String id = UUID.randomUUID().toString();
    byte[] document = document(generated.suite());
    quotas.requireSuite(document.length);
    StoredSuite stored =
        new StoredSuite(id, activityId, generated.suite(), generated.notes(), now());
    transaction.executeWithoutResult(
        status -> {
          suites.saveAndFlush(stored);
          documents.save(id, document);
          quotas.ownSuite(id, document.length);
        });
    parsed.put(new Key(id, version(id)), generated.suite());
    return id;
  }

  /** Puts an edited document into the place of a suite's. */
  void replaceDocument(String id, byte[] document, Requests.Expected expected) {
    TestSuite edited = TestSuiteXml.read(new ByteArrayInputStream(document), "the document");
    edit(id, expected, (suite, model) -> edited);
  }

  /** A change of a suite, made with the model that it belongs to. */
  @FunctionalInterface
  interface Edit {
    TestSuite apply(TestSuite suite, TestModel model);
  }

  /** Changes a suite; what it was can be brought back with {@link #undo}. */
  void edit(String id, Requests.Expected expected, Edit edit) {
    StoredSuite seen = find(id);
    expected.require("suite", seen.version());
    TestModel model = Workspaces.model(workspaces.activity(seen.activityId()), seen.model());
    TestSuite edited = edit.apply(suite(seen), model);
    requireFit(edited, model);
    byte[] document = document(edited);
    if (Arrays.equals(document, document(id))) {
      // Nothing changed, so there is nothing to bring back.
      return;
    }
    transaction.executeWithoutResult(
        status -> {
          StoredSuite stored = find(id);
          // What was changed is what was seen, whether or not its author named a version.
          Requests.Expected.version(seen.version()).require("suite", stored.version());
          revisions.push(id, stored.version(), document(id));
          stored.replace(edited, now());
          suites.saveAndFlush(stored);
          documents.save(id, document);
        });
    parsed.put(new Key(id, version(id)), edited);
  }

  /** Brings back what a suite was before its latest change. */
  void undo(String id, Requests.Expected expected) {
    transaction.executeWithoutResult(
        status -> {
          StoredSuite stored = find(id);
          expected.require("suite", stored.version());
          byte[] document =
              revisions
                  .pop(id)
                  .orElseThrow(() -> Refusal.conflict("There is no change left to undo."));
          stored.replace(
              TestSuiteXml.read(new ByteArrayInputStream(document), stored.name()), now());
          suites.saveAndFlush(stored);
          documents.save(id, document);
        });
  }

  /** The suite of the same model that was made last before this one. */
  Optional<StoredSuite> previous(StoredSuite stored) {
    return suites.findFirstByActivityIdAndModelAndCreatedBeforeOrderByCreatedDesc(
        stored.activityId(), stored.model(), stored.created());
  }

  /** The present version of a suite. */
  long version(String id) {
    return suites.versionOf(id).orElseThrow(() -> Refusal.notFound("suite", id));
  }

  /** The suite of an id, as its document says. */
  TestSuite suite(String id) {
    Key key = new Key(id, version(id));
    return Optional.ofNullable(parsed.getIfPresent(key)).orElseGet(() -> suite(find(id)));
  }

  /** A suite as people and programs see it; within a transaction. */
  SuiteView view(StoredSuite stored) {
    return SuiteView.of(stored, revisions.count(stored.id()));
  }

  StoredSuite find(String id) {
    return suites.findById(id).orElseThrow(() -> Refusal.notFound("suite", id));
  }

  /** Views a suite, within a transaction. */
  <T> T inspect(String id, Function<StoredSuite, T> view) {
    return Objects.requireNonNull(transaction.execute(status -> view.apply(find(id))));
  }

  /** A page of an activity's suites, each viewed within the transaction. */
  <T> Page<T> ofActivity(String activityId, Pageable page, Function<StoredSuite, T> view) {
    workspaces.name(activityId);
    return Objects.requireNonNull(
        transaction.execute(status -> suites.findByActivityId(activityId, page).map(view)));
  }

  /** The suite as its document says. */
  TestSuite suite(StoredSuite stored) {
    return parsed.get(
        new Key(stored.id(), stored.version()),
        key -> TestSuiteXml.read(new ByteArrayInputStream(document(key.id())), stored.name()));
  }

  /**
   * The document of a suite.
   *
   * @throws Refusal when there is no such suite
   */
  byte[] document(String id) {
    return documents.find(id).orElseThrow(() -> Refusal.notFound("suite", id));
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }

  private static byte[] document(TestSuite suite) {
    ByteArrayOutputStream document = new ByteArrayOutputStream();
    TestSuiteXml.write(suite, document);
    return document.toByteArray();
  }

  private static void requireFit(TestSuite suite, TestModel model) {
    var expected =
        model.inputs().stream()
            .map(i -> new CaseParameter(i.name(), i.kind(), i.realType()))
            .toList();
    if (!suite.parameters().equals(expected)) {
      throw Refusal.conflict(
          "The suite's parameters are not those of the model '"
              + model.name()
              + "' any more; generate a suite anew.");
    }
  }
}
