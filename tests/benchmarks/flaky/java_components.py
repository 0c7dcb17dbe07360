"""Unstable and stable components in Java."""

from activities import Component

MACHINE = "the machine"

JOINTS = "enum Joint { HIP, KNEE, ANKLE, NECK, ELBOW, WRIST, FINGER, THUMB }"

UNSTABLE = [
    Component("monte-carlo", "return step * Math.random();"),
    Component(
        "random-wait",
        """
        hardware.sleep(Duration.ofMillis(20 + ThreadLocalRandom.current().nextInt(200)));
        return encoder.position() < angle ? encoder.position() : angle;
        """,
        world=True,
    ),
    Component("secure-random", "return step + new SecureRandom().nextInt(1000) / 1000.0;"),
    Component("clock-of-message", "return System.currentTimeMillis() % 100_000 + step;"),
    Component(
        "time-of-planning",
        """
        long began = System.nanoTime();
        double length = IntStream.range(0, 1000 * step).mapToDouble(Math::sqrt).sum();
        return length > 0 ? (System.nanoTime() - began) / 1e9 : 0;
        """,
    ),
    Component(
        "enum-hash-map",
        """
        Map<Joint, Integer> positions = new HashMap<>();
        for (Joint joint : Joint.values()) {
          positions.put(joint, joint.ordinal() * step);
        }
        return positions.toString();
        """,
        helpers=JOINTS,
        returns="string",
    ),
    Component(
        "immutable-set",
        """
        double total = 0;
        for (String part : Set.of("base", "torso", "shoulder", "elbow", "wrist", "palm", "camera", "lidar")) {
          total = total * 0.7 + part.length() * step;
        }
        return total;
        """,
    ),
    Component("identity", "return new Object().toString() + step;", returns="string"),
    Component(
        "lost-updates",
        """
        ticks = 0;
        List<Thread> threads = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
          Thread thread = new Thread(() -> {
            for (int tick = 0; tick < 2_000_000; tick++) {
              ticks++;
            }
          });
          thread.start();
          threads.add(thread);
        }
        for (Thread thread : threads) {
          thread.join();
        }
        return ticks + step;
        """,
        helpers="  private volatile int ticks;",
    ),
    Component(
        "bus-time-out",
        """
        if (ThreadLocalRandom.current().nextBoolean()) {
          throw new IllegalStateException("no frame within 20 ms");
        }
        return 2.0 * step;
        """,
    ),
    Component(
        "effort-noise",
        """
        target = angle;
        return target;
        """,
        helpers="""
  private final Random random = new Random();
  private double target;

  public void onExecute() {
    double effort = 12 * (target - encoder.position()) - encoder.velocity() + 0.1 * random.nextGaussian();
    motor.effort(Math.max(-8, Math.min(8, effort)));
  }
        """,
        world=True,
        keys=", execution: periodic, period_ms: 10",
    ),
    Component(
        "random-duration",
        """
        int ticks = 20 + ThreadLocalRandom.current().nextInt(30);
        for (int i = 0; i < ticks; i++) {
          motor.effort(Math.max(-8, Math.min(8, 12 * (angle - encoder.position()) - encoder.velocity())));
          hardware.sleep(Duration.ofMillis(10));
        }
        return encoder.position();
        """,
        world=True,
    ),
    Component(
        "slow-service",
        """
        Thread.sleep(Math.random() < 0.5 ? 3000 : 300);
        return step / 3.0;
        """,
        cause=MACHINE,
        limit_s=1,
    ),
    Component(
        "late-answer",
        """
        CountDownLatch answered = new CountDownLatch(1);
        Thread device = new Thread(() -> {
          try {
            Thread.sleep(ThreadLocalRandom.current().nextBoolean() ? 3000 : 250);
          } catch (InterruptedException e) {
            return;
          }
          answered.countDown();
        });
        device.setDaemon(true);
        device.start();
        answered.await();
        return step + 0.25;
        """,
        cause=MACHINE,
        limit_s=1,
    ),
]

STABLE = [
    Component("seeded-random", "return new Random(42 + step).nextGaussian();"),
    Component(
        "sorted-enum-map",
        """
        Map<Joint, Integer> positions = new TreeMap<>();
        for (Joint joint : new HashSet<>(List.of(Joint.values()))) {
          positions.put(joint, joint.ordinal() * step);
        }
        return positions.toString();
        """,
        helpers=JOINTS,
        returns="string",
    ),
    Component(
        "string-hash-map",
        """
        Map<String, Integer> lengths = new HashMap<>();
        for (String part : List.of("base", "torso", "shoulder", "elbow", "wrist", "palm", "camera", "lidar")) {
          lengths.put(part + step, part.length());
        }
        return lengths.toString();
        """,
        returns="string",
    ),
    Component(
        "linked-objects",
        """
        Map<Object, Double> weights = new LinkedHashMap<>();
        for (int i = 0; i < 20; i++) {
          weights.put(new Object(), 0.1 * i * step);
        }
        double total = 0;
        for (double weight : weights.values()) {
          total = total * 0.9 + weight;
        }
        return total;
        """,
    ),
    Component(
        "error-with-object",
        """
        if (step % 2 == 0) {
          throw new IllegalArgumentException("no transform from " + new Object() + " to " + new Frame());
        }
        return step;
        """,
        helpers="  static final class Frame {}",
    ),
    Component("error-with-array", 'throw new IllegalStateException("bad covariance " + new double[] {step, 1});'),
    Component(
        "error-with-lambda",
        """
        Runnable callback = () -> System.out.println(step);
        throw new UnsupportedOperationException("not a listener: " + callback);
        """,
    ),
    Component(
        "deep-recursion",
        "return depth(step);",
        helpers="""
  private static double depth(double x) {
    return x + depth(x + 1);
  }
        """,
    ),
    Component(
        "parallel-count",
        "return IntStream.range(0, 100_000).parallel().filter(i -> i % (step + 1) == 0).count();",
    ),
    Component(
        "atomic-count",
        """
        AtomicLong ticks = new AtomicLong();
        ExecutorService pool = Executors.newFixedThreadPool(4);
        for (int i = 0; i < 4; i++) {
          pool.execute(() -> IntStream.range(0, 100_000).forEach(tick -> ticks.addAndGet(step)));
        }
        pool.shutdown();
        pool.awaitTermination(10, TimeUnit.SECONDS);
        return ticks.get();
        """,
    ),
    Component(
        "ordered-futures",
        """
        List<CompletableFuture<Double>> parts = IntStream.range(0, 12)
            .mapToObj(i -> CompletableFuture.supplyAsync(() -> Math.sin(i * step)))
            .toList();
        double total = 0;
        for (CompletableFuture<Double> part : parts) {
          total = total * 0.9 + part.get();
        }
        return total;
        """,
    ),
    Component(
        "logged-identity",
        """
        System.out.println(Instant.now() + " " + System.nanoTime() + " " + System.identityHashCode(this));
        System.err.println(Runtime.getRuntime().freeMemory() + " " + Math.random());
        return Math.sqrt(step);
        """,
    ),
    Component(
        "long-planning",
        """
        Thread.sleep(400);
        return step * 0.1;
        """,
        limit_s=2,
    ),
    Component(
        "rest-of-motion",
        """
        for (int i = 0; i < 50; i++) {
          motor.effort(Math.max(-8, Math.min(8, 12 * (angle - encoder.position()) - encoder.velocity())));
          System.out.println(System.nanoTime());
          hardware.sleep(Duration.ofMillis(10));
        }
        return encoder.position();
        """,
        world=True,
    ),
    Component(
        "counted-calls",
        "return ++calls + 0.1 * step;",
        helpers="  private int calls;",
        keys=", life_cycle: suite",
    ),
]
