"""Malformed and hostile worlds are rejected with file and line, and the bridge continues to run."""

import os
import subprocess
import sys
import time
from pathlib import Path

import grpc
import pytest

from sitaf_bridge.wire import simulation_pb2 as pb
from tests.client import Bridge, TestSession, ir_world, ranges, world
from tests.conftest import Refused

INVALID = grpc.StatusCode.INVALID_ARGUMENT
EXHAUSTED = grpc.StatusCode.RESOURCE_EXHAUSTED
BALL = '<worldbody><body name="ball"><geom name="ball" size="0.1"/></body></worldbody>'
INCLUDED = b'<mujocoinclude><worldbody><geom size="1"/></worldbody></mujocoinclude>'


@pytest.fixture(autouse=True)
def lives_on(ir: TestSession):
    """After every test, the same bridge and an earlier session still answer."""
    yield
    assert set(ranges(ir.read()).values()) == {5.0}


@pytest.mark.parametrize(
    ("content", "what"),
    [
        ('<include file="/etc/passwd"/>', "is absolute"),
        ('<include file="../../etc/passwd"/>', "'..'"),
        ('<include file="file:///etc/passwd"/>', "is absolute"),
        ('<include file="a/../../x.xml"/>', "'..'"),
        ('<include file="w.xml"/>', "includes itself"),
        ('<include file="missing.xml"/>', "is not among the world's files"),
        ('<asset><mesh name="m" file="/usr/share/x.stl"/></asset>', "is absolute"),
        ('<asset><mesh name="m" file="C:/x.stl"/></asset>', "is absolute"),
        ('<asset><mesh name="m" file="..\\x.stl"/></asset>', "backslash"),
        ('<asset><texture name="t" type="cube" fileright="/x.png"/></asset>', "is absolute"),
        ('<asset><mesh name="m" file="x.usd"/></asset>', "suffix"),
        ('<asset><mesh name="m" file="x.stl" content_type="text/usd"/></asset>', "content_type"),
        ('<compiler meshdir="/usr"/>', "is absolute"),
        ('<compiler assetdir="../up"/>', "'..'"),
        ('<asset><model name="m" file="/x.xml"/></asset>', "is absolute"),
    ],
)
def test_paths_out_of_the_world_are_refused_with_file_and_line(
    bridge: Bridge, refused: Refused, content: str, what: str
) -> None:
    code, message = refused(lambda: bridge.describe(world(f"<!-- line 2 -->\n{content}")))
    assert code is INVALID
    assert what in message
    assert message.startswith(("w.xml:3: ", "w.xml: includes"))


@pytest.mark.parametrize(
    "path", ["/etc/x.xml", "../x.xml", "a//b.xml", "./x.xml", "a\\b.xml", "", "a/./b", "http://x/y.xml"]
)
def test_paths_of_the_file_map_must_stay_inside(bridge: Bridge, refused: Refused, path: str) -> None:
    code, message = refused(lambda: bridge.describe(world(BALL, files={path: b""})))
    assert code is INVALID
    assert "world.files" in message


def test_the_compiler_process_cannot_open_files_of_the_host(tmp_path: Path) -> None:
    """Second line of defence: called directly, the compiler process cannot open files."""
    secret = tmp_path / "secret.xml"
    secret.write_bytes(INCLUDED)
    program = tmp_path / "attack.py"
    program.write_text(
        "import sys\n"
        "from sitaf_bridge.errors import BadWorld\n"
        "from sitaf_bridge.world.compiler import compile_mjcf\n"
        "if __name__ == '__main__':\n"
        "    mjcf = f'<mujoco><include file=\"{sys.argv[1]}\"/></mujoco>'.encode()\n"
        "    try:\n"
        "        print('read', compile_mjcf('w.xml', {'w.xml': mjcf}, 'w.xml').ngeom)\n"
        "    except BadWorld as error:\n"
        "        print('refused', error)\n"
    )
    ran = subprocess.run([sys.executable, program, secret], capture_output=True, text=True, cwd=tmp_path)
    assert ran.stdout.startswith("refused w.xml: "), ran
    assert "XML_ERROR_FILE" in ran.stdout or "secret.xml" in ran.stdout


@pytest.mark.parametrize(
    ("mjcf", "line", "what"),
    [
        ("<mujoco>\n<worldbody>\n<geom", 3, "not well-formed"),
        ("<mujoco>\n</worldbody>", 2, "mismatched tag"),
        ('<!DOCTYPE mujoco [<!ENTITY a "b">]>\n<mujoco/>', 1, "DOCTYPE"),
        ('<!DOCTYPE mujoco SYSTEM "file:///etc/passwd">\n<mujoco/>', 1, "DOCTYPE"),
        ('<?xml version="1.0" encoding="UTF-7"?>\n<mujoco/>', 1, "encoding"),
        ("<robots/>", 1, "root element"),
    ],
)
def test_malformed_xml_is_refused(bridge: Bridge, refused: Refused, mjcf: str, line: int, what: str) -> None:
    source = world("<mujoco/>")
    source.files["w.xml"] = mjcf.encode()
    code, message = refused(lambda: bridge.describe(source))
    assert code is INVALID
    assert message.startswith(f"w.xml:{line}: ")
    assert what in message


def test_mujocos_error_message_is_reported(bridge: Bridge, refused: Refused) -> None:
    code, message = refused(lambda: bridge.describe(world('<worldbody>\n<geom siz="1"/></worldbody>')))
    assert code is INVALID
    assert message.startswith("w.xml: ")
    assert "unrecognized attribute: 'siz'" in message
    assert "line 3" in message


@pytest.mark.parametrize("content", [b"\xff\xfe\x00<", b"", b"\x00" * 100, os.urandom(1000)])
def test_a_binary_file_is_refused(bridge: Bridge, refused: Refused, content: bytes) -> None:
    for key in ("w.xml", "w.world.yaml"):
        source = world(BALL)
        source.files[key] = content
        assert refused(lambda source=source: bridge.describe(source))[0] is INVALID


def _bomb(depth: int, count: int) -> str:
    inside = '<geom size="1"/>'
    for _ in range(depth):
        inside = f'<replicate count="{count}" offset="1 0 0">{inside}</replicate>'
    return f"<worldbody>{inside}</worldbody>"


@pytest.mark.parametrize(
    "content",
    [
        _bomb(9, 10),
        _bomb(2, 1_000_000_000),
        _bomb(1, 10**15),
        '<worldbody><body name="b"><flexcomp name="f" type="grid" dim="3" count="900 900 900"/></body></worldbody>',
    ],
)
def test_a_replicate_bomb_is_refused_at_once(bridge: Bridge, refused: Refused, content: str) -> None:
    began = time.monotonic()
    code, message = refused(lambda: bridge.describe(world(content)))
    assert code is INVALID
    assert "the limit is 100000" in message
    assert time.monotonic() - began < 10.0


def test_copies_through_includes_are_counted(bridge: Bridge, refused: Refused) -> None:
    row = '<mujocoinclude><replicate count="400" offset="0 1 0"><geom size="1"/></replicate></mujocoinclude>'
    mjcf = '<worldbody><replicate count="400" offset="1 0 0"><include file="row.xml"/></replicate></worldbody>'
    code, message = refused(lambda: bridge.describe(world(mjcf, files={"row.xml": row.encode()})))
    assert code is INVALID
    assert "the limit is 100000" in message


def test_a_model_that_crashes_mujoco_is_refused(bridge: Bridge, refused: Refused) -> None:
    texture = '<asset><texture name="t" type="2d" builtin="flat" width="16384" height="16384"/></asset>'
    code, message = refused(lambda: bridge.describe(world(texture)))
    assert code in (INVALID, EXHAUSTED)
    assert message.startswith("w.xml: ")


def test_a_model_that_asks_for_too_much_memory_is_refused(bridge: Bridge, refused: Refused) -> None:
    code, message = refused(lambda: bridge.describe(world(f'<size memory="3G"/>{BALL}')))
    assert code is EXHAUSTED
    assert "limit" in message


def test_too_many_or_too_large_files_are_refused(bridge: Bridge, refused: Refused) -> None:
    many = {f"f{i}.txt": b"" for i in range(1_001)}
    large = {"a.bin": bytes(49 * 1024 * 1024)}
    huge = {"a.bin": bytes(65 * 1024 * 1024)}
    for files in (many, large, huge):
        assert refused(lambda files=files: bridge.describe(world(BALL, files=files)))[0] is EXHAUSTED


def test_deep_nesting_is_refused(bridge: Bridge, refused: Refused) -> None:
    deep = "<worldbody>" + "<body>" * 5_000 + "</body>" * 5_000 + "</worldbody>"
    code, message = refused(lambda: bridge.describe(world(deep)))
    assert code is INVALID
    assert "nested deeper" in message
    for opening in ("[" * 100_000, "{" * 100_000, "\n".join(" " * i + "a:" for i in range(500))):
        code, message = refused(lambda opening=opening: bridge.describe(world(BALL, f"parameters:\n {opening}")))
        assert code is INVALID
        assert "nested deeper" in message


def test_every_problem_of_a_description_is_reported_at_once(bridge: Bridge, refused: Refused) -> None:
    description = """
parameters:
  Distance: {unit: m, range: [20, -1], default: 5, bind: {set: body.ball.pos.x}}
  1st: {unit: m, range: [0, 1], default: 0, bind: {set: body.ball.pos.y}}
  Size: {unit: m, range: [0, 1], default: 7, bind: {set: body.ball.pos.z, colour: red}}
  Mass: {unit: kg, range: [0, .inf], default: 1}
  Again: {unit: m, range: [0, 1], default: 0, bind: {set: body.ball.pos.x}}
devices:
  eye: {kind: telescope}
  ir: {kind: range, sensor: ir, min: 3, max: 1}
observations:
  t: {entity: ball, axis: t}
extra: 1
"""
    code, message = refused(lambda: bridge.describe(world(BALL, description)))
    assert code is INVALID
    lines = message.splitlines()
    for start, words in (
        (4, ["Distance.range", "20 is above -1"]),
        (5, ["'1st'"]),
        (6, ["Size.default", "outside the range"]),
        (6, ["colour is not a known key", "known keys: gap, set"]),
        (7, ["Mass.range", "finite number"]),
        (7, ["Mass.bind is missing"]),
        (8, ["body.ball.pos.x is already set by Distance"]),
        (10, ["telescope", "known: range"]),
        (11, ["0 <= min < max"]),
        (13, ["axis", "'t'"]),
        (14, ["extra is not a known key"]),
    ):
        found = [text for text in lines if text.startswith(f"w.world.yaml:{start}: ") and all(w in text for w in words)]
        assert found, (start, words, message)


def test_every_name_that_the_mjcf_does_not_have_is_reported_at_once(bridge: Bridge, refused: Refused) -> None:
    description = """
parameters:
  A: {unit: m, range: [0, 1], default: 0, bind: {set: body.nobody.pos.x}}
  B: {unit: m, range: [0, 1], default: 0, bind: {set: sky.colour}}
  C: {unit: m, range: [0, 1], default: 0, bind: {set: body.ball.pos.x, gap: [site.nosite, geom.ball]}}
  D: {unit: "1", range: [-1, 1], default: 0, bind: {set: geom.ball.friction.0}}
  E: {unit: m, range: [1, 2], default: 1, bind: {set: geom.ball.size.1}}
  F: {unit: rad, range: [1, 2], default: 1, bind: {set: joint.nojoint.pos}}
  G: {unit: kg, range: [0, 2], default: 1, bind: {set: body.ball.mass}}
devices:
  ir: {kind: range, sensor: nosensor, min: 0, max: 1}
observations:
  o: {entity: noentity, axis: x}
"""
    code, message = refused(lambda: bridge.describe(world(BALL, description)))
    assert code is INVALID
    for words in (
        "w.world.yaml:4: parameters.A.bind: set: body.nobody.pos.x: the MJCF has no body 'nobody'",
        "w.world.yaml:5: parameters.B.bind: set: sky.colour: is not a known path; known forms: body.NAME.pos",
        "w.world.yaml:6: parameters.C.bind: set: body.ball.pos.x: the MJCF has no site 'nosite'",
        "w.world.yaml:7: parameters.D.bind: set: geom.ball.friction.0: cannot be less than 0",
        "w.world.yaml:8: parameters.E.bind: set: geom.ball.size.1: the geom 'ball' has 1 sizes",
        "w.world.yaml:9: parameters.F.bind: set: joint.nojoint.pos: the MJCF has no joint 'nojoint'",
        "w.world.yaml:10: parameters.G.bind: set: body.ball.mass: cannot be less than 1e-15",
        "w.world.yaml:12: devices.ir.sensor: the MJCF has no sensor 'nosensor'",
        "w.world.yaml:14: observations.o: the MJCF has no body 'noentity'",
    ):
        assert words in message, message


@pytest.mark.parametrize(
    ("description", "what"),
    [
        ("a: [", "w.world.yaml:2: not YAML"),
        ("a: &x 1\nb: *x", "aliases"),
        ("a: !!python/object/apply:os.system [id]", "a is not a known key"),
        ("mjcf: other.xml", "mjcf is given twice"),
        ("parameters: 3", "parameters must be a mapping"),
        ("--- {}\n--- {}", "not YAML"),
    ],
)
def test_invalid_yaml_is_refused(bridge: Bridge, refused: Refused, description: str, what: str) -> None:
    code, message = refused(lambda: bridge.describe(world(BALL, description)))
    assert code is INVALID
    assert what in message


def test_unsupported_range_finder_attributes_are_refused(bridge: Bridge, refused: Refused) -> None:
    mjcf = """
    <worldbody><camera name="c"/><body><geom size="0.1"/><site name="s"/></body></worldbody>
    <sensor>
      <rangefinder name="cut" site="s" cutoff="5"/>
      <rangefinder name="more" site="s" data="dist normal"/>
      <rangefinder name="camera" camera="c"/>
      <accelerometer name="acc" site="s"/>
    </sensor>"""
    description = "devices:\n" + "".join(
        f"  {name}: {{kind: range, sensor: {name}, min: 0, max: 10}}\n" for name in ("cut", "more", "camera", "acc")
    )
    code, message = refused(lambda: bridge.describe(world(mjcf, description)))
    assert code is INVALID
    for words in ("cutoff", "distance only", "attached to a site", "not a rangefinder"):
        assert words in message


def test_a_fractional_timestep_in_nanoseconds_is_refused(bridge: Bridge, refused: Refused) -> None:
    code, message = refused(lambda: bridge.describe(world(f'<option timestep="0.0000010005"/>{BALL}')))
    assert code is INVALID
    assert "whole number of nanoseconds" in message


def test_a_default_that_cannot_be_reached_is_refused(bridge: Bridge, refused: Refused) -> None:
    mjcf = """<worldbody><site name="s" quat="0.5 0.5 0.5 0.5"/>
      <body name="wall" mocap="true" pos="3 9 0"><geom name="wall" type="box" size="1 1 1"/></body></worldbody>"""
    description = """
parameters:
  D: {unit: m, range: [0, 9], default: 1, bind: {set: body.wall.pos.x, gap: [site.s, geom.wall]}}
"""
    code, message = refused(lambda: bridge.describe(world(mjcf, description)))
    assert code is INVALID
    assert "the defaults cannot be set: parameter D: 1: the line of gap [site.s, geom.wall] does not enter" in message


def test_paths_are_relative_to_the_description(bridge: Bridge) -> None:
    files = {
        "world/w.world.yaml": b"mjcf: w.xml",
        "world/w.xml": b'<mujoco><compiler meshdir="parts"/><include file="more/inc.xml"/>'
        b'<asset><mesh name="m" file="a.obj"/></asset>'
        b'<worldbody><geom type="mesh" mesh="m"/></worldbody></mujoco>',
        "world/more/inc.xml": INCLUDED,
        "world/parts/a.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
        "notes.txt": b"not part of it",
    }
    described = bridge.describe(pb.WorldSource(description="world/w.world.yaml", files=files))
    assert described.timestep_ns == 2_000_000


def test_the_digest_covers_every_file_and_nothing_else(bridge: Bridge) -> None:
    first, second = ir_world(), ir_world()
    assert bridge.describe(first).digest == bridge.describe(second).digest
    second.files["README.txt"] = b"."
    assert bridge.describe(first).digest != bridge.describe(second).digest
