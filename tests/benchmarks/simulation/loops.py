"""Control loops of test applications in each language, as parts of real time and of an empty exchange."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from sitaf_bridge.wire import simulation_pb2 as pb

JOINTS = 6
PERIOD_US = 4000
FASTER = {"C++": 12, "Java": 12, "Python": 8}
HERE = Path(__file__).resolve().parent


def write_world(folder):
    """A chain of joints with a motor and an encoder each."""
    bodies, motors, devices = "", "", ""
    for i in range(1, JOINTS + 1):
        bodies += f'<body pos="0.1 0 0"><joint name="j{i}" axis="0 0 1" damping="1" armature="0.1"/>'
        bodies += '<geom type="capsule" fromto="0 0 0 0.1 0 0" size="0.02" contype="0" conaffinity="0"/>'
        motors += f'<motor name="m{i}" joint="j{i}" ctrlrange="-50 50"/>'
        devices += f"  motor{i}: {{kind: joint_motor, actuator: m{i}}}\n"
        devices += f"  encoder{i}: {{kind: joint_encoder, joint: j{i}}}\n"
    mjcf = f'<mujoco><option timestep="0.002"/><worldbody>{bodies}{"</body>" * JOINTS}</worldbody>'
    (folder / "arm.xml").write_text(f"{mjcf}<actuator>{motors}</actuator></mujoco>")
    world = folder / "arm.world.yaml"
    world.write_text(f"mjcf: arm.xml\ndevices:\n{devices}")
    return str(world)


def programs():
    """The command of each language's program."""
    classpath, library = os.environ["SITAF_BENCH_CLASSPATH"], os.environ.get("SITAF_BENCH_CPP", "")
    if library:
        yield "C++", [library], {}
    yield "Java", ["java", "-cp", classpath, "Loops"], {}
    yield "Python", [sys.executable, str(HERE / "loop.py")], {"PYTHONPATH": os.environ["SITAF_BENCH_PYTHONPATH"]}


def loops(target, control, empty_us):
    """Yields what, value, unit, target and whether it is held, for each language."""

    def exchanges():
        operations = control.GetStatistics(pb.GetStatisticsRequest()).operations
        return {operation.rpc: operation.count for operation in operations}

    with tempfile.TemporaryDirectory() as folder:
        world = write_world(Path(folder))
        for language, command, extra in programs():
            before = exchanges()
            output = subprocess.run(
                [*command, target, world, str(JOINTS)], check=True, capture_output=True, text=True, env={**os.environ, **extra}
            ).stdout
            after = exchanges()
            ticks = 5 * 500
            made = sum(after.get(rpc, 0) - before.get(rpc, 0) for rpc in ("StepSimulation", "WriteDevices"))
            tick_us, least = float(output), FASTER[language]
            speed, each, ratio = PERIOD_US / tick_us, made / ticks, tick_us / empty_us
            yield f"{JOINTS} joints at 250 Hz, {language}", speed, "x time", f">= {least}", speed >= least
            yield "    exchanges per tick", each, "", "1", each == 1
            yield "    tick / empty unary call of Java", ratio, "", "<= 1.6", ratio <= 1.6
