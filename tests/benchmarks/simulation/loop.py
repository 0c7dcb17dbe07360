"""A controller of all joints at 250 Hz. Prints microseconds per tick, best of five. Arguments: target, world, joints."""

import sys
import time
from pathlib import Path

from sitaf_runtime.simulation.session import Simulation
from sitaf_runtime.stopwatch import Stopwatch

target, world, joints = sys.argv[1:]
simulation = Simulation(target, Path(world), 1, Stopwatch())
hardware = simulation.hardware
pairs = [
    (hardware.joint_motor(f"motor{i}"), hardware.joint_encoder(f"encoder{i}")) for i in range(1, int(joints) + 1)
]


def tick():
    for motor, encoder in pairs:
        motor.set_effort(8 * (0.5 - encoder.position()) - encoder.velocity())


best = float("inf")
for _ in range(5):
    simulation.prepare({})
    simulation.every(0.004, tick)
    began = time.perf_counter()
    simulation.advance(2)
    best = min(best, (time.perf_counter() - began) * 1e6 / 500)
    if abs(pairs[0][1].position() - 0.5) > 0.1:
        sys.exit(f"not controlled: {pairs[0][1].position()}")
print(best)
simulation.close()
