"""Robots from packages: only listed files of known packages are read."""

import importlib.metadata

import grpc
import pytest

from sitaf_bridge.world.description.robot import PACKAGES, read_robot
from sitaf_bridge.world.description.yaml_block import Problems, parse
from tests.client import Bridge, world
from tests.conftest import Refused

GROUND = '<worldbody><geom name="ground" type="plane" size="0 0 .1"/></worldbody>'


def robot(text: str) -> list[str]:
    problems = Problems("w.world.yaml")
    ((name, block),) = parse(f"robots: {{r: {{{text}}}}}".encode(), problems).named_blocks("robots")
    read_robot(name, block)
    return [problem.message for problem in problems.found]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("package: numpy==2.4.6, model: a.xml", "must be NAME==VERSION with NAME of"),
        ("package: robosuite, model: a.xml", "must be NAME==VERSION"),
        ("package: 'robosuite==../../etc', model: a.xml", "must be NAME==VERSION"),
        ("package: robosuite==1.5.2, model: /etc/passwd", "is absolute"),
        ("package: robosuite==1.5.2, model: ../../../etc/passwd", "contains '.', '..'"),
        ("package: robosuite==1.5.2, model: a.xml, base: floating", "is not one of fixed, free"),
        ("package: robosuite==1.5.2, model: a.xml, pos: [0, 1]", "must be a list of three"),
        ("package: robosuite==1.5.2, model: a.xml, colour: red", "colour is not a known key"),
        ("model: a.xml", "file is missing"),
    ],
)
def test_a_bad_declaration_is_refused(text: str, message: str) -> None:
    assert any(message in problem for problem in robot(text))


def test_a_package_of_another_version_is_refused(bridge: Bridge, refused: Refused) -> None:
    yaml = "robots: {r: {package: example-robot-data==0.0.1, model: a/b.urdf}}"
    code, message = refused(lambda: bridge.describe(world(GROUND, yaml)))
    assert code == grpc.StatusCode.INVALID_ARGUMENT
    assert "needs example-robot-data==0.0.1" in message
    assert 'pip install "sitaf-bridge[robots]"' in message


def installed() -> tuple[str, str]:
    for name in PACKAGES:
        try:
            return name, importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
    pytest.skip("no package of robots is installed")


def test_only_files_that_the_package_lists_are_read(bridge: Bridge, refused: Refused) -> None:
    name, version = installed()
    for path in ("etc/passwd", "sitaf_bridge/__init__.py"):
        yaml = f"robots: {{r: {{package: {name}=={version}, model: {path}}}}}"
        code, message = refused(lambda yaml=yaml: bridge.describe(world(GROUND, yaml)))
        assert code == grpc.StatusCode.INVALID_ARGUMENT
        assert "has no file" in message


def test_a_site_on_a_missing_body_is_refused(bridge: Bridge, refused: Refused) -> None:
    name, version = installed()
    if name != "example-robot-data":
        pytest.skip("example-robot-data is not installed")
    model = "cmeel.prefix/share/example-robot-data/robots/panda_description/urdf/panda_collision.urdf"
    yaml = f"robots: {{r: {{package: {name}=={version}, model: {model}, sites: {{s: {{body: nose}}}}}}}}"
    code, message = refused(lambda: bridge.describe(world(GROUND, yaml)))
    assert code == grpc.StatusCode.INVALID_ARGUMENT
    assert "the robot has no body 'nose'" in message


def test_two_robots_of_one_model_stand_in_one_world(bridge: Bridge) -> None:
    name, version = installed()
    if name != "example-robot-data":
        pytest.skip("example-robot-data is not installed")
    model = "cmeel.prefix/share/example-robot-data/robots/go2_description/urdf/go2.urdf"
    one = f"package: {name}=={version}, model: {model}, base: free"
    yaml = f"robots: {{a: {{{one}, pos: [0, 0, 1]}}, b: {{{one}, pos: [2, 0, 1]}}}}"
    entities = bridge.describe(world(GROUND, yaml)).entities
    assert {"a_base", "b_base", "a_FL_foot", "b_FL_foot"} <= set(entities)
