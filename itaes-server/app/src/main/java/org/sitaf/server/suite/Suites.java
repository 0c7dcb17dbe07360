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
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.server.activity.StoredActivities;
import org.sitaf.server.computation.Computations;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.quota.Quotas;
import org.sitaf.server.web.Requests;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** Generates, stores and edits suites. */
@Service
public class Suites {
  /** Maximum number of cases in the cache. */
  private static final int MAX_CASES = 500_000;

  private static final Duration CACHED = Duration.ofMinutes(30);

  private final SuiteRepository suites;
  private final StoredActivities activities;
  private final Quotas quotas;
  private final TransactionTemplate transaction;
  private final Clock clock;
  private final SuiteDocuments documents;
  private final SuiteRevisions revisions;
  private final Computations computations;

  /**
   * Cache of parsed suites, so that paging through a large suite does not parse its document for
   * each page.
   */
  private final Cache<Key, TestSuite> parsed =
      Caffeine.newBuilder()
          .maximumWeight(MAX_CASES)
          .weigher((Key key, TestSuite suite) -> suite.cases().size())
          .expireAfterAccess(CACHED)
          .build();

  private record Key(String id, long version) {}

  Suites(
      SuiteRepository suites,
      StoredActivities activities,
      Quotas quotas,
      TransactionTemplate transaction,
      Clock clock,
      SuiteDocuments documents,
      SuiteRevisions revisions,
      Computations computations) {
    this.suites = suites;
    this.activities = activities;
    this.quotas = quotas;
    this.documents = documents;
    this.revisions = revisions;
    this.computations = computations;
    this.transaction = transaction;
    this.clock = clock;
  }

  /**
   * Generates the test application of a suite from the current state of its activity.
   *
   * @param ros what a ROS 2 node runs with
   * @throws RequestException if there is no such suite, or if it no longer matches its model
   * @throws org.sitaf.core.diagnostic.InvalidInputException if the application cannot be generated
   */
  public TestApplication application(String suiteId, RosImplementation ros) {
    StoredSuite stored = find(suiteId);
    Activity activity = activities.activity(stored.activityId()).with(ros);
    TestModel model = StoredActivities.model(activity, stored.model());
    TestSuite suite = suite(stored);
    requireFit(suite, model);
    return InterfaceTestApplicationGenerator.generate(activity, model, suite);
  }

  /**
   * Returns the activity and the model of a suite.
   *
   * @throws RequestException if there is no such suite
   */
  public SuiteOrigin origin(String suiteId) {
    StoredSuite stored = find(suiteId);
    return new SuiteOrigin(
        stored.activityId(), activities.name(stored.activityId()), stored.id(), stored.model());
  }

  /**
   * Checks that an activity has a model.
   *
   * @throws RequestException if it has no model with this name
   */
  public void requireModel(String activityId, String modelName) {
    StoredActivities.model(activities.activity(activityId), modelName);
  }

  /**
   * Generates and stores a suite from the current state of a model.
   *
   * @param seed null for the default
   * @return its id
   * @throws org.sitaf.core.diagnostic.InvalidInputException if the suite cannot be generated
   */
  public String generate(String activityId, String modelName, @Nullable Long seed) {
    return generate(activityId, modelName, new SuiteOptions(seed, null, null, null).toGeneration());
  }

  String generate(String activityId, String modelName, GenerationOptions options) {
    return store(
        activityId,
        generate(StoredActivities.model(activities.activity(activityId), modelName), options));
  }

  /**
   * Generates the suite of a model that is not stored, with the default options.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException if it cannot be generated
   */
  public GeneratedSuite generate(TestModel model) {
    return generate(model, SuiteOptions.NONE.toGeneration());
  }

  private GeneratedSuite generate(TestModel model, GenerationOptions options) {
    return computations.generation(
        "The generation of the suite", () -> TestCaseGenerator.generate(model, options));
  }

  /**
   * Stores a generated suite.
   *
   * @return its id
   */
  public String store(String activityId, GeneratedSuite generated) {
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

  /** Replaces the document of a suite. */
  void replaceDocument(String id, byte[] document, Requests.Expected expected) {
    TestSuite edited = TestSuiteXml.read(new ByteArrayInputStream(document), "the document");
    edit(id, expected, (suite, model) -> edited);
  }

  /** A change of a suite; it can use the suite's model. */
  @FunctionalInterface
  interface Edit {
    TestSuite apply(TestSuite suite, TestModel model);
  }

  /** Changes a suite; {@link #undo} reverts the change. */
  void edit(String id, Requests.Expected expected, Edit edit) {
    StoredSuite original = find(id);
    expected.require("suite", original.version());
    TestModel model =
        StoredActivities.model(activities.activity(original.activityId()), original.model());
    TestSuite edited = edit.apply(suite(original), model);
    requireFit(edited, model);
    byte[] document = document(edited);
    if (Arrays.equals(document, document(id))) {
      // Without a change there is nothing to undo.
      return;
    }
    transaction.executeWithoutResult(
        status -> {
          StoredSuite stored = find(id);
          // The edit was applied to this version, also if the client expects any version.
          Requests.Expected.version(original.version()).require("suite", stored.version());
          revisions.push(id, stored.version(), document(id));
          stored.replace(edited, now());
          suites.saveAndFlush(stored);
          documents.save(id, document);
        });
    parsed.put(new Key(id, version(id)), edited);
  }

  /** Reverts the latest change of a suite. */
  void undo(String id, Requests.Expected expected) {
    transaction.executeWithoutResult(
        status -> {
          StoredSuite stored = find(id);
          expected.require("suite", stored.version());
          byte[] document =
              revisions
                  .pop(id)
                  .orElseThrow(() -> RequestException.conflict("There is no change to undo."));
          stored.replace(
              TestSuiteXml.read(new ByteArrayInputStream(document), stored.name()), now());
          suites.saveAndFlush(stored);
          documents.save(id, document);
        });
  }

  /** The previous suite of the same model. */
  Optional<StoredSuite> previous(StoredSuite stored) {
    return suites.findFirstByActivityIdAndModelAndCreatedBeforeOrderByCreatedDesc(
        stored.activityId(), stored.model(), stored.created());
  }

  long version(String id) {
    return suites.versionOf(id).orElseThrow(() -> RequestException.notFound("suite", id));
  }

  TestSuite suite(String id) {
    Key key = new Key(id, version(id));
    return Optional.ofNullable(parsed.getIfPresent(key)).orElseGet(() -> suite(find(id)));
  }

  /** Returns the view of a suite; must be called within a transaction. */
  SuiteView view(StoredSuite stored) {
    return SuiteView.of(stored, revisions.count(stored.id()));
  }

  StoredSuite find(String id) {
    return suites.findById(id).orElseThrow(() -> RequestException.notFound("suite", id));
  }

  /** Applies a function to a suite within a transaction. */
  <T> T inspect(String id, Function<StoredSuite, T> view) {
    return Objects.requireNonNull(transaction.execute(status -> view.apply(find(id))));
  }

  /** Returns a page of an activity's suites. */
  <T> Page<T> ofActivity(String activityId, Pageable page, Function<StoredSuite, T> view) {
    activities.name(activityId);
    return Objects.requireNonNull(
        transaction.execute(status -> suites.findByActivityId(activityId, page).map(view)));
  }

  /** Reads the suite's document, or returns it from the cache. */
  TestSuite suite(StoredSuite stored) {
    return parsed.get(
        new Key(stored.id(), stored.version()),
        key -> TestSuiteXml.read(new ByteArrayInputStream(document(key.id())), stored.name()));
  }

  /**
   * Returns the document of a suite.
   *
   * @throws RequestException if there is no such suite
   */
  byte[] document(String id) {
    return documents.find(id).orElseThrow(() -> RequestException.notFound("suite", id));
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }

  /** The document of a suite, as it is stored. */
  public static byte[] document(TestSuite suite) {
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
      throw RequestException.conflict(
          "The suite no longer matches the parameters of model '"
              + model.name()
              + "'; generate a new suite.");
    }
  }
}
