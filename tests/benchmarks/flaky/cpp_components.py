"""Unstable and stable components in C++."""

from activities import Component

MACHINE = "the machine"

NODES = """
struct Node {
  std::string name;
  double weight;
};

std::vector<std::unique_ptr<Node>> nodes() {
  std::vector<std::unique_ptr<Node>> made;
  for (const char* name : {"base", "torso", "shoulder", "elbow", "wrist", "palm", "camera", "lidar"}) {
    made.push_back(std::make_unique<Node>(Node{name, 0.1 * static_cast<double>(made.size() + 1)}));
  }
  return made;
}
"""

CONTROL = """
  for (int i = 0; i < 50; ++i) {
    const double effort = 12 * (angle - encoder.position()) - encoder.velocity() + %s;
    motor.setEffort(std::clamp(effort, -8.0, 8.0));
    hardware.sleep(10ms);
  }
  return encoder.position();
"""

UNSTABLE = [
    Component(
        "sampling-planner",
        """
        std::mt19937 random(std::random_device{}());
        return step * std::uniform_real_distribution<double>(0, 1)(random);
        """,
    ),
    Component(
        "uninitialised-heap",
        """
        // The buffer of a filter that nobody fills before the first sample.
        std::unique_ptr<std::int32_t[]> window(new std::int32_t[16]);
        window[0] = step;
        double total = 0;
        for (int i = 0; i < 16; ++i) {
          total += window[i];
        }
        return total / 16;
        """,
    ),
    Component(
        "address-as-key",
        """
        auto node = std::make_unique<double>(step);
        std::ostringstream key;
        key << node.get();
        return key.str();
        """,
        returns="string",
    ),
    Component(
        "pointer-hash",
        """
        // The order of an unordered_set of pointers would depend only on their distances, which do not change.
        const auto owned = nodes();
        std::vector<std::vector<const Node*>> queues(31);
        for (const auto& node : owned) {
          queues[std::hash<const Node*>{}(node.get()) % queues.size()].push_back(node.get());
        }
        double total = 0;
        for (const auto& queue : queues) {
          for (const Node* node : queue) {
            total = total * 0.7 + node->weight * step;
          }
        }
        return total;
        """,
        helpers=NODES,
    ),
    Component(
        "racing-counter",
        """
        volatile std::int32_t ticks = 0;
        std::vector<std::thread> threads;
        for (int i = 0; i < 4; ++i) {
          threads.emplace_back([&ticks] {
            for (int tick = 0; tick < 2000000; ++tick) {
              ticks = ticks + 1;
            }
          });
        }
        for (auto& thread : threads) {
          thread.join();
        }
        return ticks + step;
        """,
    ),
    Component(
        "null-now-and-then",
        """
        std::random_device random;
        const double* reading = random() % 2 == 0 ? nullptr : new double(step);
        return *reading;
        """,
    ),
    Component(
        "drive-jitter",
        CONTROL % "0.2 * noise(generator)",
        helpers="""
        std::mt19937 generator(static_cast<unsigned>(std::chrono::steady_clock::now().time_since_epoch().count()));
        std::uniform_real_distribution<double> noise(-1, 1);
        """,
        world=True,
    ),
    Component(
        "slow-solver",
        """
        const auto length = std::random_device{}() % 2 == 0 ? 3000ms : 300ms;
        const auto end = std::chrono::steady_clock::now() + length;
        double x = step;
        while (std::chrono::steady_clock::now() < end) {
          x = std::sqrt(x) + 1;
        }
        return step + (x > 0 ? 0.5 : 0.0);
        """,
        cause=MACHINE,
        limit_s=1,
    ),
    Component(
        "held-mutex",
        """
        static std::timed_mutex mutex;
        std::thread writer([] {
          std::lock_guard<std::timed_mutex> lock(mutex);
          std::this_thread::sleep_for(std::random_device{}() % 2 == 0 ? 3000ms : 250ms);
        });
        std::this_thread::sleep_for(50ms);
        mutex.lock();
        mutex.unlock();
        writer.join();
        return step * 1.5;
        """,
        cause=MACHINE,
        limit_s=1,
    ),
]

STABLE = [
    Component(
        "default-seed",
        """
        std::mt19937 random;
        random.discard(step);
        return std::normal_distribution<double>(0, 1)(random) + std::rand() % 100;
        """,
    ),
    Component(
        "string-hash-map",
        """
        std::unordered_map<std::string, double> weights;
        for (const auto& node : nodes()) {
          weights[node->name] = node->weight * step;
        }
        std::string order;
        for (const auto& [name, weight] : weights) {
          order += name + " ";
        }
        return order;
        """,
        helpers=NODES,
        returns="string",
    ),
    Component(
        "pointers-by-name",
        """
        const auto owned = nodes();
        const auto byName = [](const Node* one, const Node* other) { return one->name < other->name; };
        std::set<const Node*, decltype(byName)> open(byName);
        for (const auto& node : owned) {
          open.insert(node.get());
        }
        double total = 0;
        for (const Node* node : open) {
          total = total * 0.7 + node->weight * step;
        }
        return total;
        """,
        helpers=NODES,
    ),
    Component(
        "atomic-counter",
        """
        std::atomic<std::int32_t> ticks{0};
        std::vector<std::thread> threads;
        for (int i = 0; i < 4; ++i) {
          threads.emplace_back([&ticks] {
            for (int tick = 0; tick < 100000; ++tick) {
              ++ticks;
            }
          });
        }
        for (auto& thread : threads) {
          thread.join();
        }
        return ticks + step;
        """,
    ),
    Component(
        "error-with-pointer",
        """
        char text[80];
        std::snprintf(text, sizeof text, "no transform from %p", static_cast<void*>(this));
        throw std::runtime_error(text + std::string(" at step ") + std::to_string(step));
        """,
    ),
    Component(
        "always-null",
        """
        const volatile double* reading = step % 2 == 0 ? nullptr : new double(step);
        return *reading;
        """,
    ),
    Component(
        "cleared-buffer",
        """
        std::vector<std::int32_t> window(16);
        window[0] = step;
        std::unique_ptr<std::int32_t[]> unused(new std::int32_t[64]);
        std::printf("%d\\n", unused[3]);
        double total = 0;
        for (const std::int32_t each : window) {
          total += each;
        }
        return total / 16;
        """,
    ),
    Component(
        "hold-angle",
        CONTROL % "0.2 * noise(generator)",
        helpers="""
        std::mt19937 generator(5);
        std::uniform_real_distribution<double> noise(-1, 1);
        """,
        world=True,
    ),
    Component(
        "measured-not-returned",
        """
        const auto began = std::chrono::steady_clock::now();
        std::this_thread::sleep_for(400ms);
        const auto took = std::chrono::steady_clock::now() - began;
        return took > 399ms ? step * 0.1 : 0;
        """,
        limit_s=2,
    ),
    Component(
        "futures-in-order",
        """
        std::vector<std::future<double>> parts;
        for (int i = 0; i < 8; ++i) {
          parts.push_back(std::async(std::launch::async, [i, step] { return std::sin(i * step); }));
        }
        double total = 0;
        for (auto& part : parts) {
          total = total * 0.9 + part.get();
        }
        return total;
        """,
    ),
]
