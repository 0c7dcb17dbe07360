"""Range devices compared with exact results: each kind of geom from outside, inside, beside and behind."""

import math

import pytest

from tests.client import Bridge, ranges, world

INF = math.inf
CUBE_OBJ = b"""
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 1 3 2
f 1 4 3
f 5 6 7
f 5 7 8
f 1 2 6
f 1 6 5
f 2 3 7
f 2 7 6
f 3 4 8
f 3 8 7
f 4 1 5
f 4 5 8
"""

# The half length along x that each geom of this table has at its centre line.
SHAPES = {
    "box": ('type="box" size="1 2 3"', 1.0),
    "turned box": ('type="box" size="1 2 3" euler="0 0 90"', 2.0),
    "slanted box": ('type="box" size="1 1 3" euler="0 0 45"', math.sqrt(2)),
    "sphere": ('type="sphere" size="1.5"', 1.5),
    "lying capsule": ('type="capsule" size="0.5 1" euler="0 90 0"', 1.5),
    "standing capsule": ('type="capsule" size="0.5 1"', 0.5),
    "cylinder": ('type="cylinder" size="0.75 1"', 0.75),
    "lying cylinder": ('type="cylinder" size="0.75 1" euler="0 90 0"', 1.0),
    "ellipsoid": ('type="ellipsoid" size="2 1 0.5"', 2.0),
    "mesh": ('type="mesh" mesh="cube"', 1.0),
    "turned mesh": ('type="mesh" mesh="cube" euler="0 0 45"', math.sqrt(2)),
}
DEVICE = "devices:\n  eye: {kind: range, sensor: eye, min: %g, max: %g}\n"
MOVED = "parameters:\n  X: {unit: m, range: [-50, 50], default: 20, bind: {set: body.thing.pos.x}}\n"
EYE = '<body name="eye"><site name="eye" quat="0.5 0.5 0.5 0.5"/></body>'


def scene(geom: str, low: float = 0.0, high: float = 10.0, more: str = "", eye: str = EYE):
    """A sensor at the origin that looks along +x, and a geom whose centre X moves along the line of sight."""
    mjcf = f"""
    <asset><mesh name="cube" file="cube.obj"/></asset>
    <worldbody>{eye}{more}<body name="thing" mocap="true"><geom name="thing" {geom}/></body></worldbody>
    <sensor><rangefinder name="eye" site="eye"/></sensor>"""
    return world(mjcf, DEVICE % (low, high) + MOVED, {"cube.obj": CUBE_OBJ})


def readings(bridge: Bridge, source, values: list[float]) -> list[float]:
    session = bridge.create(source)
    found = [ranges(session.prepare(X=value))["eye"] for value in values]
    session.delete()
    return found


@pytest.mark.parametrize("shape", SHAPES)
def test_every_shape_is_measured_from_outside_and_noticed_from_inside(bridge: Bridge, shape: str) -> None:
    geom, half = SHAPES[shape]
    centres = [half + 0.25, half + 9.75, half + 10.25, half * 0.9, 0.0, -half * 0.9, -half - 0.25]
    outside, far, beyond, entering, middle, leaving, behind = readings(bridge, scene(geom), centres)
    assert outside == pytest.approx(0.25, abs=1e-6)
    assert far == pytest.approx(9.75, abs=1e-6)
    assert (beyond, behind) == (INF, INF)
    assert (entering, middle, leaving) == (-INF, -INF, -INF)


@pytest.mark.parametrize("shape", ["box", "sphere", "cylinder", "mesh"])
def test_what_is_nearer_than_min_reads_minus_infinity(bridge: Bridge, shape: str) -> None:
    geom, half = SHAPES[shape]
    near, at, touching = readings(bridge, scene(geom, low=0.5), [half + 0.49, half + 0.51, half])
    assert near == -INF
    assert at == pytest.approx(0.51, abs=1e-6)
    assert touching == -INF


@pytest.mark.parametrize("shape", ["box", "sphere", "mesh"])
def test_touching_is_zero_and_not_inside(bridge: Bridge, shape: str) -> None:
    geom, half = SHAPES[shape]
    assert readings(bridge, scene(geom), [half]) == [0.0]


def test_a_plane_is_solid_behind_its_front(bridge: Bridge) -> None:
    wall = 'type="plane" size="0 0 1" quat="0.5 -0.5 -0.5 0.5"'
    assert readings(bridge, scene(wall), [3.0, 0.0, -0.5, -40.0, 10.5]) == [3.0, 0.0, -INF, -INF, INF]


def test_a_plane_with_an_edge_is_solid_within_it_only(bridge: Bridge) -> None:
    aside = 'type="plane" size="1 1 1" quat="0.5 -0.5 -0.5 0.5" pos="0 5 0"'
    assert readings(bridge, scene(aside), [3.0, -0.5]) == [INF, INF]


def test_the_back_of_a_plane_lets_rays_through(bridge: Bridge) -> None:
    turned = 'type="plane" size="1 1 1" quat="0.5 0.5 0.5 0.5"'
    # The sensor is in front of it only when the plane is behind the sensor; ahead of it, it is in the solid.
    assert readings(bridge, scene(turned), [-3.0, 3.0]) == [INF, -INF]


def test_invisible_objects_are_ignored(bridge: Bridge) -> None:
    assert readings(bridge, scene('type="box" size="1 1 1" rgba="1 1 1 0"'), [3.0, 0.0]) == [INF, INF]


def test_the_nearest_object_is_measured(bridge: Bridge) -> None:
    post = '<geom type="box" size="0.5 0.5 0.5" pos="4 0 0"/>'
    found = readings(bridge, scene(SHAPES["box"][0], more=post), [3.0, 8.0])
    assert found == [2.0, 3.5]


def test_inside_of_one_object_hides_the_next(bridge: Bridge) -> None:
    post = '<geom type="box" size="0.05 0.5 0.5" pos="0.5 0 0"/>'
    assert readings(bridge, scene(SHAPES["box"][0], more=post), [0.0]) == [-INF]


def test_a_hollow_mesh_is_entered_through_its_triangles(bridge: Bridge) -> None:
    # An L of two bars: its convex hull holds the sensor, its surface does not.
    bars = [((0, 0), (4, 1)), ((0, 0), (1, 4))]
    vertices, faces = [], []
    for (x0, y0), (x1, y1) in bars:
        base = len(vertices)
        vertices += [(x, y, z) for z in (-1, 1) for y in (y0, y1) for x in (x0, x1)]
        quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        faces += [tuple(base + corner + 1 for corner in quad) for quad in quads]
    obj = "".join(f"v {x} {y} {z}\n" for x, y, z in vertices)
    obj += "".join(f"f {a} {b} {c}\nf {a} {c} {d}\n" for a, b, c, d in faces)
    mjcf = """
    <asset><mesh name="l" file="l.obj"/></asset>
    <worldbody>
      <body name="thing" mocap="true"><site name="eye" quat="0.5 0.5 -0.5 -0.5" pos="0 2 0"/></body>
      <geom type="mesh" mesh="l"/>
    </worldbody>
    <sensor><rangefinder name="eye" site="eye"/></sensor>"""
    source = world(mjcf, DEVICE % (0, 10) + MOVED, {"l.obj": obj.encode()})
    in_the_corner, in_a_bar = readings(bridge, source, [2.0, 0.5])
    assert in_the_corner == pytest.approx(1.0, abs=1e-6)
    assert in_a_bar == -INF


OWN_CHASSIS = """
<body name="robot"><freejoint/>
  <geom name="chassis" type="box" size="0.5 0.5 0.5"/>
  <geom name="shield" type="box" size="0.05 0.5 0.5" pos="0.8 0 0"/>
  <body name="eye"><site name="eye" quat="0.5 0.5 0.5 0.5"/></body>
</body>"""


def test_a_sensor_does_not_see_its_own_chassis(bridge: Bridge) -> None:
    assert readings(bridge, scene(SHAPES["box"][0], eye=OWN_CHASSIS), [4.0, 0.5]) == [3.0, -INF]


def test_a_sensor_sees_an_arm_of_its_own_robot(bridge: Bridge) -> None:
    arm = OWN_CHASSIS.replace(
        "</body>\n</body>",
        '</body><body pos="2 0 0"><joint/><geom type="box" size="0.5 0.5 0.5"/></body></body>',
    )
    assert arm != OWN_CHASSIS
    assert readings(bridge, scene(SHAPES["box"][0], eye=arm), [9.0]) == [1.5]


def test_a_sensor_fixed_to_the_world_sees_its_walls(bridge: Bridge) -> None:
    eye = '<site name="eye" quat="0.5 0.5 0.5 0.5"/><geom type="box" size="0.5 0.5 0.5" pos="5 0 0"/>'
    assert readings(bridge, scene(SHAPES["box"][0], eye=eye), [20.0, 3.0, 5.5]) == [4.5, 2.0, 4.5]


def test_reading_twice_changes_nothing(bridge: Bridge) -> None:
    session = bridge.create(scene(SHAPES["sphere"][0]))
    assert session.prepare(X=3.0) == session.read() == session.read()
    session.delete()
