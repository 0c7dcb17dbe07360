"""Measures the simulator against its targets, and against plain in-process MuJoCo in the same run."""

import os

os.environ.setdefault("MUJOCO_GL", "egl")

import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import grpc
import mujoco
import numpy as np
from mujoco.batch import Batch

from loops import loops
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.wire import simulation_pb2_grpc as pb_grpc
from sitaf_bridge.world.catalog import Catalog
from sitaf_bridge.world.description.source import read_world

HOME = Path(os.environ["SITAF_HOME"])
IR = HOME / "examples" / "ir-sensor" / "world" / "ir.world.yaml"
MAZE = HOME / "examples" / "worlds" / "maze" / "maze.world.yaml"
SESSIONS = 64
RESETS = 640
STEPPED_CASES, STEPS = 4_000, 200
THREADS = 2


@dataclass
class Row:
    what: str
    value: float
    unit: str
    target: str
    held: bool
    plain: str


def timed(work, seconds=1.0):
    """Seconds of a piece of work, the best of many runs, because other load only slows it down."""
    best, end = float("inf"), time.perf_counter() + seconds
    while time.perf_counter() < end:
        began = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - began)
    return best


def source(path):
    world = read_world(path)
    return pb.WorldSource(description=world.description, files=dict(world.files))


def plain_ir():
    """Set, step, forward and read of the infrared world, without anything around it: model, data and a step."""
    model = mujoco.MjModel.from_xml_path(str(IR.with_name("ir.xml")))
    data = mujoco.MjData(model)

    def cycle(value):
        data.mocap_pos[0, 0] = value
        mujoco.mj_step(model, data)
        mujoco.mj_forward(model, data)
        return data.sensordata.tolist()

    return model, data, cycle


def calls(target, control):
    session = control.CreateSession(pb.CreateSessionRequest(world=source(IR), seed=1)).session_id
    command = ["java", "-cp", os.environ["SITAF_BENCH_CLASSPATH"], "Calls", target, session, str(IR)]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    seen = {name: float(value) for name, value in (line.split() for line in output.splitlines())}
    model, data, cycle = plain_ir()
    plain_us = timed(lambda: [cycle(i / 10) for i in range(100)]) * 1e4
    for kind in ("unary", "stream"):
        empty, step = seen[f"{kind}_empty"], seen[f"{kind}_step"]
        yield Row(f"{kind}: empty call", empty, "us", "", True, "")
        yield Row(f"{kind}: set + step + read", step, "us", "", True, f"{step / plain_us:.1f} x {plain_us:.1f} us")
        yield Row(f"{kind}: their ratio", step / empty, "", "<= 1.3", step <= 1.3 * empty, "")

    def prepared():
        for i in range(1000):
            data.mocap_pos[0, 0] = i / 50
            mujoco.mj_forward(model, data)
            data.sensordata.tolist()

    plain = 1000 / timed(prepared)
    for what, value, unit, aim, held in loops(target, control, seen["unary_empty"]):
        yield Row(what, value, unit, aim, held, "")
    bulk = seen["bulk"]
    yield Row("bulk: cases over the wire", bulk, "cases/s", ">= 100,000", bulk >= 1e5, f"{bulk / plain:.2f} x {plain:,.0f}")
    read = seen["read"] / 1e3
    yield Row("read between two steps", read, "us", "< 2", read < 2, f"{read / plain_us:.3f} x {plain_us:.1f} us")


def stepped(control):
    values = np.linspace(0, 20, STEPPED_CASES)
    session = control.CreateSession(pb.CreateSessionRequest(world=source(IR), seed=1)).session_id
    model, *_ = plain_ir()
    request = pb.PrepareManyRequest(
        session_id=session,
        parameters=["Distance"],
        values=values,
        cases=STEPPED_CASES,
        settle_ns=STEPS * round(model.opt.timestep * 1e9),
        threads=THREADS,
    )
    batch = Batch(model, STEPPED_CASES, THREADS)
    batch.bind("sensordata")

    def plain():
        batch.reset(stage=int(mujoco.mjtStage.mjSTAGE_NONE))
        batch.bind("mocap_pos")[:, 0, 0] = values
        batch.step(nstep=STEPS, stage=int(mujoco.mjtStage.mjSTAGE_POS))

    ours, theirs = float("inf"), float("inf")
    for _ in range(3):
        theirs = min(theirs, timed(plain, 0.01))
        ours = min(ours, timed(lambda: control.PrepareMany(request), 0.01))
    ratio = theirs / ours
    rates = STEPPED_CASES / ours, STEPPED_CASES / theirs
    yield Row(f"bulk: cases of {STEPS} steps", rates[0], "cases/s", ">= 0.8 x", ratio >= 0.8, f"{ratio:.2f} x {rates[1]:,.0f}")


def sessions(control):
    """Sessions and resets as measured in the server's process, without gRPC."""

    def statistics():
        return control.GetStatistics(pb.GetStatisticsRequest())

    before = statistics()
    create = pb.CreateSessionRequest(world=source(IR), seed=1)
    mine = [control.CreateSession(create).session_id for _ in range(SESSIONS)]
    after = statistics()
    models = after.models - before.models
    opened = after.sessions - before.sessions
    # Earlier sessions already hold the model of the same world.
    held = opened == SESSIONS and models == 0
    yield Row(f"{SESSIONS} sessions: more compiled models", models, "", "0", held, "")
    for session in mine:
        for _ in range(RESETS // SESSIONS):
            control.ResetSimulation(pb.ResetSimulationRequest(session_id=session))
    (reset,) = (o for o in statistics().operations if o.rpc == "ResetSimulation")
    loaded = Catalog().world(read_world(IR))
    data = mujoco.MjData(loaded.model)

    def plain():
        for _ in range(100):
            mujoco.mj_resetData(loaded.model, data)
            mujoco.mj_forward(loaded.model, data)

    plain_us = timed(plain) * 1e4
    for what, nanoseconds in (("mean", reset.total_ns / reset.count), ("best", reset.shortest_ns)):
        us = nanoseconds / 1e3
        ratio = f"{us / plain_us:.1f} x {plain_us:.1f} us"
        yield Row(f"session reset in the server, {what}", us, "us", "< 100", us < 100, ratio)
    for session in mine:
        control.DeleteSession(pb.DeleteSessionRequest(session_id=session))


def cameras(control, hardware):
    session = control.CreateSession(pb.CreateSessionRequest(world=source(MAZE), seed=1)).session_id
    model = Catalog().world(read_world(MAZE)).model
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    for device, what in (("camera", "RGB"), ("depth", "depth")):
        request = pb.ReadDevicesRequest(session_id=session, devices=[device])
        try:
            hardware.ReadDevices(request)
        except grpc.RpcError as error:
            yield Row(f"camera 320 x 240, {what}", 0, "frames/s", ">= 100", False, error.details())
            continue
        ours = 20 / timed(lambda r=request: [hardware.ReadDevices(r) for _ in range(20)], 2)
        renderer = mujoco.Renderer(model, 240, 320)
        if device == "depth":
            renderer.enable_depth_rendering()

        def plain(renderer=renderer):
            for _ in range(20):
                renderer.update_scene(data, camera="front")
                renderer.render()

        theirs = 20 / timed(plain, 2)
        renderer.close()
        yield Row(f"camera 320 x 240, {what}", ours, "frames/s", ">= 100", ours >= 100, f"{ours / theirs:.2f} x {theirs:,.0f}")


def main():
    rows = []
    # A Unix socket, as agents use.
    folder = tempfile.TemporaryDirectory()
    command = [sys.executable, "-m", "sitaf_bridge", "serve", "--listen", f"unix:{folder.name}/s", "--stop-with-stdin"]
    with folder, subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        try:
            target = process.stdout.readline().split()[1]
            options = [("grpc.max_receive_message_length", 64 << 20), ("grpc.max_send_message_length", 64 << 20)]
            with grpc.insecure_channel(target, options) as channel:
                control = pb_grpc.SimulationControlStub(channel)
                hardware = pb_grpc.VirtualHardwareStub(channel)
                print(f"{'':36}{'measured':>14} {'':9}{'target':>11}   plain in-process MuJoCo")
                for rows_of in (calls(target, control), stepped(control), sessions(control), cameras(control, hardware)):
                    for row in rows_of:
                        rows.append(row)
                        mark = "" if row.held else "  SHORT"
                        print(f"{row.what:36}{row.value:>14,.2f} {row.unit:9}{row.target:>11}   {row.plain}{mark}", flush=True)
        finally:
            process.stdin.close()
            process.wait(20)
            process.stdout.close()
    short = [row.what for row in rows if not row.held]
    print("simulation: held" if not short else f"simulation: short: {'; '.join(short)}")
    return 1 if short else 0


if __name__ == "__main__":
    sys.exit(main())
