import com.google.gson.JsonObject;
import com.google.protobuf.ByteString;
import io.grpc.ManagedChannel;
import io.grpc.Metadata;
import io.grpc.netty.shaded.io.grpc.netty.NettyChannelBuilder;
import io.grpc.stub.MetadataUtils;
import io.grpc.stub.StreamObserver;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.sitaf.agent.v1.AgentMessage;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.EnrolRequest;
import org.sitaf.agent.v1.Heartbeat;
import org.sitaf.agent.v1.Register;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.agent.v1.SubmitResultResponse;
import org.sitaf.agent.v1.Toolchain;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;

/**
 * Simulates agents that answer each assignment at once, and clients that request builds and read. The
 * server receives the same messages as from real ones. Arguments: options, then PHASE...; prints a line of JSON per phase.
 */
public final class Load {
  private static final int CASES_OF_LARGE = 2000;
  private static final int HEARTBEAT_S = 4;

  private final Rest rest;
  private final int grpc;
  private final String enrolment;
  private final ScheduledExecutorService timer = Executors.newScheduledThreadPool(4);
  private final ExecutorService workers = Executors.newFixedThreadPool(64);
  private final Map<String, Long> assigned = new ConcurrentHashMap<>();
  private final Map<String, Long> finished = new ConcurrentHashMap<>();
  private final Map<String, byte[]> results = new ConcurrentHashMap<>();
  private final Map<String, String> suiteOf = new ConcurrentHashMap<>();
  private final AtomicInteger registered = new AtomicInteger();
  private final AtomicInteger lost = new AtomicInteger();
  private final AtomicLong rows = new AtomicLong();
  private final AtomicInteger underWay = new AtomicInteger();
  private final List<ManagedChannel> channels = new ArrayList<>();

  private Load(Rest rest, int grpc, String enrolment) {
    this.rest = rest;
    this.grpc = grpc;
    this.enrolment = enrolment;
  }

  public static void main(String[] arguments) throws Exception {
    Load load =
        new Load(
            new Rest(Integer.parseInt(arguments[0]), System.getenv("SITAF_TOKEN")),
            Integer.parseInt(arguments[1]),
            System.getenv("SITAF_ENROLMENT_TOKEN"));
    int agents = Integer.parseInt(arguments[2]);
    int seconds = Integer.parseInt(arguments[3]);
    byte[] zip = Files.readAllBytes(Path.of(arguments[4]));
    String small = load.suite(zip);
    String large = load.suite(zip);
    load.enlarge(large);
    load.prepare(small);
    load.prepare(large);
    load.connect(agents);
    load.phase("warm-up", small, 5, large, 1, 5, 10);
    load.phase("builds", small, 20, large, 0, 0, seconds);
    load.phase("rows", small, 0, large, 10_000.0 / CASES_OF_LARGE, 20, seconds);
    load.phase("mixed", small, 10, large, 5_000.0 / CASES_OF_LARGE, 10, seconds);
    System.exit(0);
  }

  // --- agents

  private void connect(int count) throws Exception {
    long began = System.nanoTime();
    for (int i = 0; i < count; i++) {
      new Agent("load-" + i).connect();
      if (i % 20 == 19) {
        Thread.sleep(20);
      }
    }
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(120);
    while (registered.get() < count && System.nanoTime() < end) {
      Thread.sleep(50);
    }
    JsonObject report = new JsonObject();
    report.addProperty("phase", "connect");
    report.addProperty("agents", registered.get());
    report.addProperty("seconds", (System.nanoTime() - began) / 1e9);
    System.out.println(report);
  }

  private final class Agent implements StreamObserver<ServerMessage> {
    private final String name;
    private final ManagedChannel channel;
    private final AgentServiceGrpc.AgentServiceStub calls;
    private final Map<Long, AttemptRef> running = new ConcurrentHashMap<>();
    private StreamObserver<AgentMessage> stream;

    Agent(String name) {
      this.name = name;
      this.channel = NettyChannelBuilder.forAddress("127.0.0.1", grpc).usePlaintext().build();
      EnrolRequest request = EnrolRequest.newBuilder().setToken(enrolment).setName(name).build();
      Metadata headers = new Metadata();
      headers.put(
          Metadata.Key.of("authorization", Metadata.ASCII_STRING_MARSHALLER),
          "Bearer " + AgentServiceGrpc.newBlockingStub(channel).enrol(request).getKey());
      this.calls =
          AgentServiceGrpc.newStub(channel)
              .withInterceptors(MetadataUtils.newAttachHeadersInterceptor(headers));
      channels.add(channel);
    }

    void connect() {
      stream = calls.connect(this);
      Register register =
          Register.newBuilder()
              .setName(name)
              .setVersion("load")
              .setSlots(2)
              .setSimulation(true)
              .addToolchains(Toolchain.newBuilder().setLanguage("java").setVersion("load"))
              .build();
      send(AgentMessage.newBuilder().setRegister(register).build());
      timer.scheduleAtFixedRate(this::beat, HEARTBEAT_S, HEARTBEAT_S, TimeUnit.SECONDS);
    }

    private synchronized void send(AgentMessage message) {
      stream.onNext(message);
    }

    private void beat() {
      try {
        send(AgentMessage.newBuilder().setHeartbeat(Heartbeat.newBuilder().addAllRunning(running.values())).build());
      } catch (RuntimeException e) {
        lost.incrementAndGet();
        throw e;
      }
    }

    @Override
    public void onNext(ServerMessage message) {
      if (message.hasRegistered()) {
        registered.incrementAndGet();
      } else if (message.hasAssignment()) {
        execute(message.getAssignment());
      }
    }

    private void execute(Assignment assignment) {
      AttemptRef attempt = assignment.getAttempt();
      assigned.put(attempt.getBuildId(), System.nanoTime());
      running.put(attempt.getFencingToken(), attempt);
      String suite =
          assignment.getFilesList().stream().filter(f -> f.getPath().equals("suite.xml")).findFirst().orElseThrow().getSha256();
      byte[] document = results.get(suite);
      SubmitResultRequest request =
          SubmitResultRequest.newBuilder()
              .setAttempt(attempt)
              .setResultDescriptor(ByteString.copyFrom(document))
              .setSha256(Rest.sha256(document))
              .build();
      calls.submitResult(
          request,
          new StreamObserver<SubmitResultResponse>() {
            @Override
            public void onNext(SubmitResultResponse response) {
              if (response.getAccepted()) {
                finished.put(attempt.getBuildId(), System.nanoTime());
                rows.addAndGet(document.length > 200_000 ? CASES_OF_LARGE : 55);
              }
            }

            @Override
            public void onError(Throwable error) {
              running.remove(attempt.getFencingToken());
              System.err.println("a result was rejected: " + error);
            }

            @Override
            public void onCompleted() {
              running.remove(attempt.getFencingToken());
            }
          });
    }

    @Override
    public void onError(Throwable error) {
      lost.incrementAndGet();
      System.err.println(name + ": " + error);
    }

    @Override
    public void onCompleted() {
      lost.incrementAndGet();
    }
  }

  // --- phases

  private void phase(
      String name, String small, double smallRate, String large, double largeRate, double readRate, int seconds)
      throws Exception {
    assigned.clear();
    finished.clear();
    rows.set(0);
    Map<String, Long> requested = new ConcurrentHashMap<>();
    ConcurrentLinkedQueue<Long> reads = new ConcurrentLinkedQueue<>();
    AtomicInteger failures = new AtomicInteger();
    ConcurrentLinkedQueue<String> seen = new ConcurrentLinkedQueue<>();
    long began = System.nanoTime();
    List<Runnable> stops = new ArrayList<>();
    stops.add(atRate(smallRate, () -> request(small, requested, seen, failures)));
    stops.add(atRate(largeRate, () -> request(large, requested, seen, failures)));
    stops.add(atRate(readRate, () -> read(reads, seen, failures)));
    Thread.sleep(seconds * 1000L);
    stops.forEach(Runnable::run);
    long accepted = rows.get();
    double tookS = (System.nanoTime() - began) / 1e9;
    int finishedInTime = finished.size();
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(120);
    while ((underWay.get() > 0 || !finished.keySet().containsAll(requested.keySet())) && System.nanoTime() < end) {
      Thread.sleep(50);
    }
    long[] dispatch =
        requested.entrySet().stream()
            .filter(e -> assigned.containsKey(e.getKey()))
            .mapToLong(e -> assigned.get(e.getKey()) - e.getValue())
            .sorted()
            .toArray();
    long[] readTimes = reads.stream().mapToLong(Long::longValue).sorted().toArray();
    JsonObject report = new JsonObject();
    report.addProperty("phase", name);
    report.addProperty("seconds", tookS);
    report.addProperty("requested", requested.size());
    report.addProperty("finished", requested.keySet().stream().filter(finished::containsKey).count());
    report.addProperty("finishedPerSecond", finishedInTime / tookS);
    report.addProperty("rowsPerSecond", accepted / tookS);
    report.addProperty("dispatchP50", percentile(dispatch, 0.5));
    report.addProperty("dispatchP99", percentile(dispatch, 0.99));
    report.addProperty("reads", readTimes.length);
    report.addProperty("readP50", percentile(readTimes, 0.5));
    report.addProperty("readP99", percentile(readTimes, 0.99));
    report.addProperty("failures", failures.get());
    report.addProperty("lost", lost.get());
    System.out.println(report);
    System.out.flush();
  }

  /** Runs the action at a fixed rate, whether or not earlier ones have ended. */
  private Runnable atRate(double perSecond, Runnable action) {
    if (perSecond == 0) {
      return () -> {};
    }
    var future =
        timer.scheduleAtFixedRate(() -> start(action), 0, Math.round(1_000_000 / perSecond), TimeUnit.MICROSECONDS);
    return () -> future.cancel(false);
  }

  private void start(Runnable action) {
    underWay.incrementAndGet();
    workers.execute(
        () -> {
          try {
            action.run();
          } finally {
            underWay.decrementAndGet();
          }
        });
  }

  private void request(String suite, Map<String, Long> requested, ConcurrentLinkedQueue<String> seen, AtomicInteger failures) {
    long now = System.nanoTime();
    try {
      String id = rest.post("/api/v1/builds", "{\"suiteId\":\"" + suite + "\"}").get("id").getAsString();
      requested.put(id, now);
      seen.add(id);
    } catch (Exception e) {
      failures.incrementAndGet();
      System.err.println("a build was not requested: " + e);
    }
  }

  private void read(ConcurrentLinkedQueue<Long> times, ConcurrentLinkedQueue<String> seen, AtomicInteger failures) {
    String id = finished.keySet().stream().findAny().orElse(null);
    String[] paths =
        id == null
            ? new String[] {"/api/v1/builds?size=50", "/api/v1/agents"}
            : new String[] {
              "/api/v1/builds?size=50",
              "/api/v1/builds/" + id,
              "/api/v1/builds/" + id + "/result",
              "/api/v1/builds/" + id + "/result/cases?size=50"
            };
    String path = paths[(int) (System.nanoTime() / 1000 % paths.length)];
    long began = System.nanoTime();
    try {
      rest.get(path);
      times.add(System.nanoTime() - began);
    } catch (Exception e) {
      failures.incrementAndGet();
      System.err.println("a request failed: " + e);
    }
  }

  private static double percentile(long[] sorted, double part) {
    return sorted.length == 0 ? 0 : sorted[(int) Math.min(sorted.length - 1, Math.ceil(part * sorted.length) - 1)] / 1e9;
  }

  // --- suites and their results

  private String suite(byte[] zip) throws Exception {
    JsonObject activity =
        rest.post("/api/v1/activities", "application/zip", zip);
    return rest.post("/api/v1/activities/" + activity.get("id").getAsString() + "/models/GetInfraredData/suites", "{}")
        .get("id").getAsString();
  }

  /** Repeats the cases with new numbers. */
  private void enlarge(String suiteId) throws Exception {
    TestSuite suite = document(suiteId);
    List<TestCase> cases = new ArrayList<>();
    for (int no = 1; no <= CASES_OF_LARGE; no++) {
      TestCase one = suite.cases().get((no - 1) % suite.cases().size());
      cases.add(new TestCase(no, one.valid(), one.values(), one.expected()));
    }
    ByteArrayOutputStream xml = new ByteArrayOutputStream();
    TestSuiteXml.write(
        new TestSuite(suite.name(), suite.description(), suite.modelName(), suite.generation(), suite.parameters(), cases),
        xml);
    rest.put("/api/v1/suites/" + suiteId + "/document", "application/xml", xml.toByteArray());
  }

  private TestSuite document(String suiteId) throws Exception {
    byte[] xml = rest.get("/api/v1/suites/" + suiteId + "/document");
    return TestSuiteXml.read(new ByteArrayInputStream(xml), "suite");
  }

  /** Creates the result of the agents, in which each case passes. */
  private void prepare(String suiteId) throws Exception {
    byte[] xml = rest.get("/api/v1/suites/" + suiteId + "/document");
    TestSuite suite = TestSuiteXml.read(new ByteArrayInputStream(xml), "suite");
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    TestSuiteXml.write(suite, written);
    results.put(Rest.sha256(written.toByteArray()), Results.of(suite));
  }
}
