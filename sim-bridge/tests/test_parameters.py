"""Parameters: each kind of `set` path, and gaps that are solved."""

import math

import grpc
import mujoco
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sitaf_bridge.world.geometry.geom_bounds import refit
from tests.client import Bridge, observed, ranges, world
from tests.conftest import Refused

EYE = '<body name="eye"><site name="eye" quat="0.5 0.5 0.5 0.5"/></body>'
SENSOR = '<sensor><rangefinder name="eye" site="eye"/></sensor>'
DEVICE = "devices:\n  eye: {kind: range, sensor: eye, min: 0, max: 50}\n"


def gap_world(geom: str, bind: str = "body.thing.pos.x", body: str = 'mocap="true" pos="5 0 0"', eye: str = EYE):
    mjcf = f'<worldbody>{eye}<body name="thing" {body}><geom name="thing" {geom}/></body></worldbody>{SENSOR}'
    parameter = f"{{unit: m, range: [-20, 45], default: 5, bind: {{set: {bind}, gap: [site.eye, geom.thing]}}}}"
    return world(mjcf, f"parameters:\n  Gap: {parameter}\n{DEVICE}observations:\n  x: {{entity: thing, axis: x}}\n")


@pytest.mark.parametrize(
    "geom",
    [
        'type="box" size="1 2 3"',
        'type="box" size="0.3 0.3 0.3" euler="10 20 30"',
        'type="sphere" size="0.7"',
        'type="sphere" size="0.7" pos="0 0.3 0.2"',
        'type="capsule" size="0.3 1" euler="30 40 50"',
        'type="cylinder" size="0.3 1" euler="30 40 50"',
        'type="ellipsoid" size="0.3 0.5 1" euler="30 40 50"',
        'type="plane" size="0 0 1" zaxis="-1 0.3 0.2"',
    ],
)
@pytest.mark.parametrize("gap", [0.0, 0.1, 0.5, 7.3, 40.0])
def test_the_gap_to_any_shape_is_what_the_sensor_reads(bridge: Bridge, geom: str, gap: float) -> None:
    session = bridge.create(gap_world(geom))
    assert ranges(session.prepare(Gap=gap))["eye"] == pytest.approx(gap, rel=1e-14, abs=1e-14)
    assert session.parameters() == {"Gap": gap}
    session.delete()


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.integers(min_value=0, max_value=45 * 256))
def test_a_representable_gap_is_exact(bridge: Bridge, fraction: int) -> None:
    session = bridge.create(gap_world('type="box" size="1 2 3"'))
    assert ranges(session.prepare(Gap=fraction / 256))["eye"] == fraction / 256
    session.delete()


def test_a_negative_gap_puts_the_surface_behind_the_sensor(bridge: Bridge) -> None:
    session = bridge.create(gap_world('type="box" size="1 2 3"'))
    state = session.prepare(Gap=-0.75)
    assert observed(state)["x"] == 0.25
    assert ranges(state)["eye"] == -math.inf
    # Two metres thick: three metres behind the front, the sensor is out again.
    assert ranges(session.prepare(Gap=-3.0))["eye"] == math.inf
    session.delete()


def test_a_gap_moves_a_fixed_body_a_free_body_or_the_sensor_itself(bridge: Bridge) -> None:
    box = 'type="box" size="1 2 3"'
    free = box + "/><freejoint"
    slide = '<body name="eye"><joint name="rail" type="slide" axis="1 0 0"/><geom size="0.1"/>{}</body>'.format(
        '<site name="eye" quat="0.5 0.5 0.5 0.5"/>'
    )
    for source, x in (
        (gap_world(box, body='pos="5 0 0"'), 3.5),
        (gap_world(free, body='pos="5 0 0"'), 3.5),
        (gap_world(box, bind="joint.rail.pos", eye=slide), 5.0),
    ):
        session = bridge.create(source)
        state = session.prepare(Gap=2.5)
        assert (ranges(state)["eye"], observed(state)["x"]) == (2.5, x)
        session.delete()


def test_a_gap_that_cannot_be_reached_is_refused_and_changes_nothing(bridge: Bridge, refused: Refused) -> None:
    # The sphere grows towards the sensor: it can close the gap, but not be smaller than nothing.
    source = gap_world('type="sphere" size="1"', bind="geom.thing.size.0", body='pos="6 0 0"')
    session = bridge.create(source)
    before = session.read()
    assert ranges(session.prepare(Gap=0.5))["eye"] == pytest.approx(0.5, abs=1e-12)
    assert session.reset() == before
    code, message = refused(lambda: session.prepare(Gap=8.0))
    assert code is grpc.StatusCode.OUT_OF_RANGE
    assert "parameter Gap: 8: gap [site.eye, geom.thing]" in message
    assert session.read() == before
    assert session.parameters() == {"Gap": 5.0}
    session.delete()


def test_a_parameter_that_does_not_change_the_gap_is_refused(bridge: Bridge, refused: Refused) -> None:
    wall = 'type="plane" size="0 0 1" quat="0.5 -0.5 -0.5 0.5"'
    code, message = refused(lambda: bridge.create(gap_world(wall, bind="body.thing.pos.y", body='pos="6 0 0"')))
    assert code is grpc.StatusCode.INVALID_ARGUMENT
    assert "`set` does not change it" in message


def test_one_parameter_may_set_several_quantities(bridge: Bridge) -> None:
    mjcf = '<worldbody><body name="a" mocap="true"/><body name="b" mocap="true"/></worldbody>'
    description = """
parameters:
  Both: {unit: m, range: [0, 9], default: 1, bind: [{set: body.a.pos.x}, {set: body.b.pos.z}]}
observations:
  a: {entity: a, axis: x}
  b: {entity: b, axis: z}
"""
    session = bridge.create(world(mjcf, description))
    assert observed(session.set(Both=4.0)) == {"a": 4.0, "b": 4.0}
    session.delete()


PENDULUM = world(
    """
    <option timestep="0.0005" integrator="RK4"/>
    <worldbody>
      <body name="arm"><joint name="hinge" axis="0 1 0"/>
        <body name="bob" pos="0 0 -1"><geom name="bob" size="0.001" mass="1"/></body>
      </body>
    </worldbody>""",
    """
parameters:
  Angle: {unit: rad, range: [-3, 3], default: 0, bind: {set: joint.hinge.pos}}
  Length: {unit: m, range: [-3, -0.1], default: -1, bind: {set: body.bob.pos.z}}
  Gravity: {unit: m/s^2, range: [-20, 0], default: -9.81, bind: {set: option.gravity.z}}
observations:
  x: {entity: bob, axis: x}
  z: {entity: bob, axis: z}
  pitch: {entity: arm, axis: pitch}
""",
)


@pytest.mark.parametrize(("length", "gravity"), [(1.0, 9.81), (0.25, 9.81), (1.0, 1.62)])
def test_a_pendulum_swings_with_its_closed_form_period(bridge: Bridge, length: float, gravity: float) -> None:
    period = 2 * math.pi * math.sqrt(length / gravity)
    session = bridge.create(PENDULUM)
    start = observed(session.prepare(Angle=0.02, Length=-length, Gravity=-gravity))
    assert start["pitch"] == pytest.approx(0.02, abs=1e-12)
    assert start["z"] == pytest.approx(-length * math.cos(0.02), abs=1e-12)
    steps = round(period / 0.0005 / 4)
    quarter = observed(session.step(steps))
    half = observed(session.step(steps))
    assert abs(quarter["x"]) < 1e-3 * abs(start["x"]) * 2
    assert half["x"] == pytest.approx(-start["x"], rel=1e-3)
    session.delete()


def test_a_heavier_body_keeps_its_shape_of_inertia(bridge: Bridge) -> None:
    # A physical pendulum's motion does not depend on its mass if, and only if, its inertia grows along.
    mjcf = """
    <option timestep="0.001"/>
    <worldbody>
      <body name="arm"><joint axis="0 1 0"/><geom type="box" size="0.2 0.1 0.5" pos="0 0 -0.5" mass="2"/></body>
    </worldbody>"""
    description = """
parameters:
  Mass: {unit: kg, range: [0.1, 100], default: 2, bind: {set: body.arm.mass}}
  Pull: {unit: m/s^2, range: [-20, 20], default: -1, bind: {set: option.gravity.x}}
observations:
  pitch: {entity: arm, axis: pitch}
"""
    session = bridge.create(world(mjcf, description))
    light, heavy, again = (observed(session.prepare(Mass=mass, settle_ns=10**8))["pitch"] for mass in (2.0, 50.0, 2.0))
    assert abs(light) > 1e-3
    assert heavy == pytest.approx(light, rel=1e-9)
    assert again == light
    session.delete()


@pytest.mark.parametrize("kind", ["sphere", "capsule", "cylinder", "ellipsoid", "box"])
def test_bounds_of_a_resized_geom_are_those_that_mujoco_compiles(kind: str) -> None:
    def compiled(size: str) -> mujoco.MjModel:
        return mujoco.MjModel.from_xml_string(
            f'<mujoco><worldbody><body><geom name="g" type="{kind}" size="{size}" mass="1" pos="1 2 3" '
            'euler="10 20 30"/>'
            '<geom size="0.3" mass="1"/><geom type="box" size="1 1 0.2" pos="-3 0 0" mass="1"/><freejoint/></body>'
            '<geom type="plane" size="1 1 1"/></worldbody></mujoco>'
        )

    # Inertia follows the size when MuJoCo compiles, and the tree's frame follows the inertia: so it is kept equal.
    small, large = compiled("0.1 0.2 0.3"), compiled("0.7 0.5 0.4")
    for field in ("body_ipos", "body_iquat"):
        getattr(small, field)[:] = getattr(large, field)
    geom = mujoco.mj_name2id(small, mujoco.mjtObj.mjOBJ_GEOM, "g")
    small.geom_size[geom] = large.geom_size[geom]
    refit(small, geom)
    np.testing.assert_allclose(small.geom_aabb, large.geom_aabb, atol=1e-12)
    np.testing.assert_allclose(small.geom_rbound, large.geom_rbound, atol=1e-12)
    root = large.body_bvhadr[1]
    low = small.bvh_aabb[root, :3] - small.bvh_aabb[root, 3:]
    high = small.bvh_aabb[root, :3] + small.bvh_aabb[root, 3:]
    np.testing.assert_array_less(low - 1e-9, large.bvh_aabb[root, :3] - large.bvh_aabb[root, 3:])
    np.testing.assert_array_less(large.bvh_aabb[root, :3] + large.bvh_aabb[root, 3:], high + 1e-9)


def test_rays_hit_a_resized_geom_at_its_new_size(bridge: Bridge) -> None:
    mjcf = (
        f'<worldbody>{EYE}<body pos="9 0 0"><geom name="b" type="box" size="1 1 1"/><geom size="1"/></body></worldbody>'
    )
    description = "parameters:\n  S: {unit: m, range: [0.1, 8], default: 1, bind: {set: geom.b.size.0}}\n" + DEVICE
    session = bridge.create(world(mjcf + SENSOR, description))
    assert [ranges(session.prepare(S=s))["eye"] for s in (1.0, 7.0, 0.5, 1.0)] == [8.0, 2.0, 8.0, 8.0]
    session.delete()
