"""Scenes and motions as glTF, against closed-form solutions; and statistics of the simulator."""

import math

import grpc
import pytest

from client import Gltf, folder, pb, world

G = 9.81
SHAPES = """
<option timestep="0.001"/>
<asset><mesh name="wedge" vertex="0 0 0 1 0 0 0 1 0 0 0 1"/>
  <material name="red" rgba="1 0 0 1"/><hfield name="hill" nrow="3" ncol="4" size="2 1 0.5 0.1" elevation="0 0 0 0 0 1 1 0 0 0 0 0"/></asset>
<worldbody>
  <geom name="floor" type="plane" size="0 0 0.1"/>
  <geom name="hill" type="hfield" hfield="hill" pos="20 0 0"/>
  <body name="ball" pos="1 2 10"><freejoint/><geom type="sphere" size="0.25" material="red"/></body>
  <body name="crate" pos="5 0 1"><geom type="box" size="0.1 0.2 0.3"/><geom type="box" size="9 9 9" group="3"/></body>
  <body name="rod" pos="6 0 1"><geom type="cylinder" size="0.1 0.4"/></body>
  <body name="pill" pos="7 0 1"><geom type="capsule" size="0.1 0.4"/></body>
  <body name="egg" pos="8 0 1"><geom type="ellipsoid" size="0.1 0.2 0.3"/></body>
  <body name="wedge" pos="9 0 1"><geom type="mesh" mesh="wedge" rgba="0 0 1 0.5"/></body>
  <body name="ghost" pos="9 0 5"><geom type="sphere" size="1" rgba="0 0 0 0"/></body>
  <body pos="10 0 1"><joint name="hinge" axis="0 0 1"/><geom type="box" size="0.5 0.1 0.1" contype="0"/><site name="s"/></body>
</worldbody>
<actuator><velocity name="spin" joint="hinge" kv="10"/></actuator>"""
SHAPES_YAML = """
parameters:
  Height: {unit: m, range: [1, 100], default: 10, bind: {set: body.ball.pos.z}}
devices:
  imu: {kind: imu, site: s, noise: 0.1}
  encoder: {kind: joint_encoder, joint: hinge}
  scan: {kind: laser_scan, site: s, angles: [-3, 3], rays: 100, min: 0, max: 20}
observations:
  height: {entity: ball, axis: z}
"""


@pytest.fixture
def shapes(client):
    with client.open(world(SHAPES, SHAPES_YAML)) as session:
        yield session


def extent(corners):
    return [(min(axis), max(axis)) for axis in zip(*corners, strict=True)]


def near(expected):
    return [pytest.approx(pair, abs=1e-6) for pair in expected]


def test_a_scene_contains_each_solid_with_its_size_and_position(shapes):
    scene = Gltf(shapes("GetScene").gltf)
    nodes = scene.nodes()
    assert nodes["ball"]["translation"] == pytest.approx([1, 2, 10])
    assert extent(scene.corners("ball")) == near([(-0.25, 0.25)] * 3)
    assert extent(scene.corners("crate")) == near([(-0.1, 0.1), (-0.2, 0.2), (-0.3, 0.3)])
    assert extent(scene.corners("rod")) == near([(-0.1, 0.1), (-0.1, 0.1), (-0.4, 0.4)])
    assert extent(scene.corners("pill")) == near([(-0.1, 0.1), (-0.1, 0.1), (-0.5, 0.5)])
    assert extent(scene.corners("egg")) == near([(-0.1, 0.1), (-0.2, 0.2), (-0.3, 0.3)])
    assert len(scene.corners("wedge")) == 4
    assert scene.corners("ghost") == []
    # Solids of the world itself: an infinite floor, and a hill around x = 20.
    low, high = extent(scene.corners("world"))[2]
    assert (low, high) == pytest.approx((0, 0.5))
    assert extent(scene.corners("world"))[0] == pytest.approx((-10, 22))
    # The unnamed body has a generated name, and the device has a position in it.
    assert [d["kind"] for d in scene.extras["devices"]] == ["imu", "joint_encoder", "laser_scan"]
    assert scene.extras["devices"][0]["body"] in nodes
    assert "animations" not in scene.document


def test_all_triangles_of_solids_face_outwards(shapes):
    scene = Gltf(shapes("GetScene").gltf)
    checked = 0
    for mesh in scene.document["meshes"]:
        (primitive,) = mesh["primitives"]
        if "NORMAL" not in primitive["attributes"]:
            continue
        corners, normals = (scene.rows(primitive["attributes"][name]) for name in ("POSITION", "NORMAL"))
        indices = [index for (index,) in scene.rows(primitive["indices"])]
        for a, b, c in zip(*[iter(indices)] * 3, strict=True):
            u, v = ([q - p for p, q in zip(corners[a], corners[other], strict=True)] for other in (b, c))
            face = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            towards = [sum(normals[corner][axis] for corner in (a, b, c)) for axis in range(3)]
            # Triangles at the poles of a sphere have no area.
            assert sum(f * t for f, t in zip(face, towards, strict=True)) > -1e-9
            checked += 1
    assert checked > 1000


def test_a_recorded_fall_equals_the_simulated_fall(shapes):
    shapes("RecordMotion", interval_ns=10_000_000)
    shapes.prepare(Height=20)
    shapes.step(495)
    taken = shapes("TakeMotion")
    motion = Gltf(taken.gltf)
    times, places = motion.track("ball", "translation")
    # Every 10 ms from 0, and at the end.
    assert taken.frames == len(times) == 51
    assert times == pytest.approx([i / 100 for i in range(50)] + [0.495], abs=1e-6)
    for time, (x, y, z) in zip(times, places, strict=True):
        assert (x, y) == (1, 2)
        # Semi-implicit Euler with steps of 1 ms.
        assert z == pytest.approx(20 - G * time * (time + 0.001) / 2, abs=1e-5)
    assert motion.track("crate", "translation") is None
    readings = motion.extras["readings"]
    assert readings["columns"][-3:] == ["encoder.position", "encoder.velocity", "height"]
    assert not any(column.startswith("scan") for column in readings["columns"])
    assert list(motion.view(readings["times"])) == times
    width = len(readings["columns"])
    assert list(motion.view(readings["rows"])[width - 1 :: width]) == [z for _, _, z in places]


def test_a_recorded_rotation_equals_the_simulated_rotation(client):
    free = """<option timestep="0.001" gravity="0 0 0"/><worldbody><body name="b"><joint name="j" axis="0 0 1"/>
      <geom type="box" size="0.2 0.1 0.1" mass="1"/></body></worldbody>"""
    with client.open(world(free, "observations: {yaw: {entity: b, axis: yaw}}")) as session:
        session("RecordMotion", interval_ns=50_000_000)
        session("ApplyWrench", entity="b", wrench=pb.Wrench(torque=pb.Vector3(z=0.1)))
        session.step(4000)
        motion = Gltf(session("TakeMotion").gltf)
        times, turns = motion.track("b", "rotation")
        acceleration = 0.1 / (1 / 12 * (0.4**2 + 0.2**2))
        for before, after in zip(turns, turns[1:], strict=False):
            assert sum(p * q for p, q in zip(before, after, strict=True)) > 0
        for time, (x, y, z, w) in zip(times, turns, strict=True):
            angle = acceleration * time * (time + 0.001) / 2
            assert (x, y) == (0, 0)
            assert abs(z * math.sin(angle / 2) + w * math.cos(angle / 2)) == pytest.approx(1, abs=1e-5)


def test_recording_changes_nothing(client):
    def final(record):
        with client.open(world(SHAPES, SHAPES_YAML)) as session:
            if record:
                session("RecordMotion", interval_ns=7_000_000)
            session.prepare(Height=3, settle_ns=100_000_000)
            session.step(1500)
            return session("TakeSnapshot").digest

    assert final(True) == final(False)


def test_each_recording_contains_the_sizes_that_parameters_set(client):
    wall = """<worldbody><body name="wall" pos="0 0 1"><geom name="wall" type="box" size="0.1 1 1"/></body></worldbody>"""
    description = "parameters: {Width: {unit: m, range: [0.5, 3], default: 1, bind: {set: geom.wall.size.1}}}"
    with client.open(world(wall, description)) as session:
        session("RecordMotion", interval_ns=10_000_000)
        for width in (1, 2, 2, 0.5):
            session.prepare(Width=width)
            session.step(3)
            assert extent(Gltf(session("TakeMotion").gltf).corners("wall"))[1] == pytest.approx((-width, width))


def test_devices_that_a_recording_leaves_out_are_still_read(client):
    nearest = "  ahead: {device: scan, field: ranges.50}\n"
    observed = SHAPES_YAML.replace("observations:\n", "observations:\n" + nearest)
    assert observed != SHAPES_YAML

    def films(description):
        with client.open(world(SHAPES, description)) as session:
            session("RecordMotion", interval_ns=10_000_000)
            session.prepare(settle_ns=50_000_000)
            state = session.step(100)
            return state, Gltf(session("TakeMotion").gltf)

    with client.open(world(SHAPES, observed)) as session:
        session.prepare(settle_ns=50_000_000)
        unfilmed = session.step(100)
    state, film = films(observed)
    assert state == unfilmed
    readings = film.extras["readings"]
    column = readings["columns"].index("ahead")
    ahead = list(film.view(readings["rows"])[column :: len(readings["columns"])])
    assert len(ahead) == 16
    (seen,) = (o.value for o in state.observations if o.name == "ahead")
    assert ahead[-1] == pytest.approx(seen, rel=1e-6)
    # The scan is available at the end, although nothing needs it before.
    plain, _ = films(SHAPES_YAML)
    assert plain.readings == unfilmed.readings


def test_a_long_recording_is_thinned_out_and_begins_with_the_case(shapes):
    shapes("RecordMotion", interval_ns=1_000_000, max_frames=20)
    shapes.step(30)
    shapes.prepare()
    shapes.step(100)
    taken = shapes("TakeMotion")
    times, _ = Gltf(taken.gltf).track("ball", "translation")
    assert taken.frames <= 21
    assert times == pytest.approx([i * 0.008 for i in range(13)] + [0.1], abs=1e-6)
    # The next motion is a separate recording.
    shapes.step(8)
    times, _ = Gltf(shapes("TakeMotion").gltf).track("ball", "translation")
    assert times == pytest.approx([0.1 + i / 1000 for i in range(9)], abs=1e-6)


def test_undone_steps_are_not_recorded(shapes):
    shapes("RecordMotion", interval_ns=10_000_000)
    shapes.prepare()
    kept = shapes("TakeSnapshot").snapshot_id
    shapes.step(300)
    shapes("RestoreSnapshot", snapshot_id=kept)
    shapes.step(25)
    times, _ = Gltf(shapes("TakeMotion").gltf).track("ball", "translation")
    assert times == pytest.approx([0, 0.01, 0.02, 0.025], abs=1e-6)


def test_an_advance_is_recorded_and_spawned_solids_are_drawn(shapes):
    shapes("RecordMotion", interval_ns=10_000_000)
    shapes(
        "SpawnEntity",
        entity="stone",
        shape=pb.SHAPE_SPHERE,
        size_m=[0.5],
        mass_kg=1,
        pose=pb.Pose(position=pb.Vector3(x=3, z=9)),
    )
    below = pb.Condition(time_ns=40_000_000)
    assert shapes("AdvanceUntil", condition=below, limit_ns=10**9).met
    motion = Gltf(shapes("TakeMotion").gltf)
    assert extent(motion.corners("stone")) == near([(-0.5, 0.5)] * 3)
    times, _ = motion.track("ball", "translation")
    assert times == pytest.approx([0, 0.01, 0.02, 0.03, 0.04], abs=1e-6)


def test_a_recording_of_one_frame_has_no_animation(shapes):
    shapes("RecordMotion", interval_ns=10_000_000)
    taken = shapes("TakeMotion")
    assert taken.frames == 1
    assert "animations" not in Gltf(taken.gltf).document


def test_motion_that_is_not_recorded_cannot_be_taken(shapes, refused):
    assert refused(lambda: shapes("TakeMotion"))[0] == grpc.StatusCode.FAILED_PRECONDITION
    assert refused(lambda: shapes("RecordMotion", interval_ns=-1))[0] == grpc.StatusCode.INVALID_ARGUMENT
    assert refused(lambda: shapes("RecordMotion", interval_ns=1, max_frames=1))[0] == grpc.StatusCode.INVALID_ARGUMENT
    shapes("RecordMotion", interval_ns=1)
    shapes("RecordMotion", interval_ns=0)
    assert refused(lambda: shapes("TakeMotion"))[0] == grpc.StatusCode.FAILED_PRECONDITION


def test_the_examples_can_be_drawn(client, worlds):
    for name in ("ir-sensor/world", "worlds/maze"):
        with client.open(folder(worlds / name)) as session:
            assert len(session("GetScene").gltf) < 200_000


def test_statistics_count_what_was_done(client, shapes):
    def count(rpc):
        seen = client.control.GetStatistics(pb.GetStatisticsRequest())
        return next((o for o in seen.operations if o.rpc == rpc), pb.OperationStatistics())

    before = count("ResetSimulation")
    shapes("ResetSimulation")
    after = count("ResetSimulation")
    assert after.count >= before.count + 1
    assert after.total_ns > before.total_ns
    assert 0 < after.shortest_ns <= after.total_ns
    before = client.control.GetStatistics(pb.GetStatisticsRequest())
    with client.open(world(SHAPES, SHAPES_YAML)):
        # The second session shares the model of the first.
        after = client.control.GetStatistics(pb.GetStatisticsRequest())
        assert (after.sessions, after.models) == (before.sessions + 1, before.models)
