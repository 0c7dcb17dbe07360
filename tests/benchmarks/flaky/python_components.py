"""Unstable and stable components in Python."""

from activities import Component

MACHINE = "the machine"

PARTS = 'PARTS = ("base", "torso", "shoulder", "elbow", "wrist", "palm", "camera", "lidar")'

LOG_ORDER = """
order = []

def sample(sensor):
    for _ in range(5):
        time.sleep(0.001)
        order.append(sensor)
"""

UNSTABLE = [
    Component("particle-filter", "return step + sum(random.gauss(0, 0.1) for _ in range(20)) / 20"),
    Component("message-id", "return f'scan {step} {uuid.uuid4()}'", returns="string"),
    Component(
        "error-with-token",
        """
        if step > 2:
            raise TimeoutError(f"no answer to request {secrets.token_hex(8)}")
        return step
        """,
    ),
    Component("time-stamp", "return datetime.datetime.now().timestamp() + step"),
    Component(
        "measured-duration",
        """
        began = time.perf_counter()
        math.factorial(200 * step)
        return time.perf_counter() - began
        """,
    ),
    Component(
        "string-set",
        """
        frames = {f"{part}_{step}" for part in PARTS}
        return ">".join(frames)
        """,
        helpers=PARTS,
        returns="string",
    ),
    Component(
        "enum-set",
        """
        joints = {joint for joint in Joint if joint.value != step}
        total = 0.0
        for joint in joints:
            total = total * 0.7 + joint.value
        return total
        """,
        helpers="""
        class Joint(enum.Enum):
            HIP = 1
            KNEE = 2
            ANKLE = 3
            NECK = 4
            ELBOW = 5
            WRIST = 6
            FINGER = 7
            THUMB = 8
        """,
    ),
    Component(
        "object-set",
        """
        landmarks = {Landmark(i * step) for i in range(12)}
        return sum(landmark.x * 0.9**rank for rank, landmark in enumerate(landmarks))
        """,
        helpers="""
        class Landmark:
            def __init__(self, x):
                self.x = x
        """,
    ),
    Component("object-number", "return f'handle {id(object()):x} of {step}'", returns="string"),
    Component(
        "thread-order",
        """
        order.clear()
        threads = [threading.Thread(target=sample, args=(sensor,)) for sensor in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return "".join(map(str, order))
        """,
        helpers=LOG_ORDER,
        returns="string",
    ),
    Component(
        "bus-error",
        """
        if random.random() < 0.5:
            raise OSError("the bus does not answer")
        return 2.0 * step
        """,
    ),
    Component(
        "anytime-planner",
        """
        end = time.monotonic() + 0.02
        tries = 0
        while time.monotonic() < end:
            tries += 1
            math.sqrt(tries)
        return tries
        """,
    ),
    Component(
        "motor-jitter",
        """
        for _ in range(50):
            effort = 12 * (angle - self.encoder.position()) - self.encoder.velocity() + random.uniform(-0.2, 0.2)
            self.motor.set_effort(max(-8.0, min(8.0, effort)))
            self.hardware.sleep(0.01)
        return self.encoder.position()
        """,
        world=True,
    ),
    Component(
        "wall-clock-derivative",
        """
        before, last = self.encoder.position(), time.monotonic()
        for _ in range(50):
            self.hardware.sleep(0.01)
            now, position = time.monotonic(), self.encoder.position()
            effort = 12 * (angle - position) - 1e-3 * (position - before) / max(now - last, 1e-6)
            self.motor.set_effort(max(-8.0, min(8.0, effort)))
            before, last = position, now
        return self.encoder.position()
        """,
        world=True,
    ),
    Component(
        "lost-connection",
        """
        while random.random() < 0.5:
            time.sleep(3)
        time.sleep(0.2)
        return 2.0 * step
        """,
        cause=MACHINE,
        limit_s=1,
    ),
    Component(
        "held-lock",
        """
        lock = threading.Lock()
        def save():
            with lock:
                time.sleep(random.choice((0.2, 3)))
        thread = threading.Thread(target=save, daemon=True)
        thread.start()
        time.sleep(0.05)
        with lock:
            return step + 0.5
        """,
        cause=MACHINE,
        limit_s=1,
    ),
    Component(
        "slow-vision",
        """
        for tick in range(50):
            self.motor.set_effort(max(-8.0, min(8.0, 12 * (angle - self.encoder.position()) - self.encoder.velocity())))
            self.hardware.sleep(0.01)
            if tick == 20:
                time.sleep(3 if os.urandom(1)[0] < 128 else 0.2)
        return self.encoder.position()
        """,
        world=True,
        cause=MACHINE,
        limit_s=1,
    ),
]

STABLE = [
    Component("seeded-filter", "return step + sum(random.Random(step).gauss(0, 0.1) for _ in range(20))"),
    Component(
        "seeded-module",
        """
        random.seed(7)
        waypoints = list(range(10))
        random.shuffle(waypoints)
        return waypoints[step] + random.random()
        """,
    ),
    Component(
        "sorted-set",
        """
        frames = {f"{part}_{step}" for part in PARTS}
        return ">".join(sorted(frames))
        """,
        helpers=PARTS,
        returns="string",
    ),
    Component(
        "exact-sum-of-set",
        """
        weights = {"base": 0.1, "torso": 1e16, "elbow": -1e16, "wrist": 0.3, "palm": 0.7, "lidar": 1e-9}
        return math.fsum(weights[part] * step for part in set(weights))
        """,
    ),
    Component(
        "number-set",
        """
        cells = {(17 * i * step) % 101 for i in range(40)}
        return sum(cell * 0.9**rank for rank, cell in enumerate(cells))
        """,
    ),
    Component(
        "logged-time",
        """
        began = time.perf_counter()
        result = math.factorial(20 * step) % 1000003
        print(f"{datetime.datetime.now()}: {time.perf_counter() - began} s in process {os.getpid()}, {uuid.uuid4()}")
        return result
        """,
    ),
    Component(
        "joined-threads",
        """
        squares = [0.0] * 8
        def work(place):
            time.sleep(random.uniform(0, 0.005))
            squares[place] = (place + step) ** 2 * 0.1
        threads = [threading.Thread(target=work, args=(place,)) for place in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return sum(squares)
        """,
    ),
    Component(
        "pool-in-order",
        """
        def work(place):
            time.sleep(random.uniform(0, 0.005))
            return str(place * step)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            return ",".join(pool.map(work, range(12)))
        """,
        returns="string",
    ),
    Component(
        "error-with-address",
        """
        if step % 2:
            raise ValueError(f"cannot localise {Landmark()}")
        return step
        """,
        helpers="""
        class Landmark:
            pass
        """,
    ),
    Component(
        "error-with-folder",
        """
        folder = tempfile.mkdtemp()
        with open(os.path.join(folder, "calibration.yaml")) as file:
            return len(file.read())
        """,
    ),
    Component(
        "shuffled-then-sorted",
        """
        points = [(i * step) % 13 for i in range(30)]
        random.shuffle(points)
        return sum(point * 0.5**rank for rank, point in enumerate(sorted(points)))
        """,
    ),
    Component(
        "long-call",
        """
        time.sleep(0.4)
        return 0.1 * step + 0.2
        """,
        limit_s=2,
    ),
    Component(
        "backoff",
        """
        for attempt in range(3):
            time.sleep(random.uniform(0.001, 0.02))
        return attempt + step
        """,
    ),
    Component(
        "joint-controller",
        """
        for _ in range(50):
            effort = 12 * (angle - self.encoder.position()) - self.encoder.velocity()
            self.motor.set_effort(max(-8.0, min(8.0, effort)))
            self.hardware.sleep(0.01)
        return self.encoder.position()
        """,
        world=True,
    ),
    Component(
        "noisy-encoder",
        """
        for _ in range(50):
            time.sleep(random.uniform(0, 0.001))
            reads = [self.encoder.position() for _ in range(random.randrange(1, 6))]
            self.motor.set_effort(max(-8.0, min(8.0, 12 * (angle - reads[-1]) - self.encoder.velocity())))
            self.hardware.sleep(0.01)
        return self.encoder.position()
        """,
        world=True,
        noise=0.01,
    ),
]
