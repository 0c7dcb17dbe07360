"""Hostile worlds: files that replace or extend those of examples/ir-sensor.

`worlds()` gives (name, {path: content}, outcome). The outcome is `refused` (the build ends before it is compiled, with a
message that names what is wrong), `limited` (a limit of time or memory ends what it does, as an ERROR or a refusal), or
`survived` (nothing of it reaches the simulator, or it does no harm: the cases run).
"""

import struct
import zlib
from pathlib import Path

WORLD = Path(__file__).resolve().parents[3] / "examples" / "ir-sensor" / "world"
MJCF, DESCRIPTION = "world/ir.xml", "world/ir.world.yaml"

REFUSED, LIMITED, SURVIVED = "refused", "limited", "survived"


def worlds():
    """All worlds by unique name."""
    found = [(name, {MJCF: _mjcf(**parts).encode()}, outcome) for name, parts, outcome in _MJCF_ONLY]
    found += [(name, {DESCRIPTION: text.encode()}, outcome) for name, text, outcome in _descriptions()]
    return found + _with_assets() + _through_includes()


def _text(name):
    return (WORLD / name).read_text("utf-8")


def _mjcf(option="", top="", bodies="", sensors="", before=""):
    """The example's MJCF with attributes of <option>, and elements at its top, in its world and among its sensors."""
    text = _text("ir.xml")
    if option:
        given = option.split("=")[0]
        old = '<option timestep="0.002" integrator="implicitfast"/>'
        text = text.replace(old, f'<option {option}{"" if given == "timestep" else " timestep=%s0.002%s" % (chr(34), chr(34))}/>')
    text = text.replace("  <worldbody>", f"  {top}\n  <worldbody>\n    {bodies}", 1)
    return before + text.replace("  <sensor>", f"  <sensor>\n    {sensors}", 1)


def _balls(count, side, size="0.5", more=""):
    """Spheres on a grid of `side`, each a body that may move; close together they all touch."""
    body = '<body pos="{:g} {:g} {:g}"><freejoint/><geom size="{}" {}/></body>'
    step = 0.05
    places = ((i % side * step + 50, i // side % side * step, i // side // side * step + 50) for i in range(count))
    return "".join(body.format(x, y, z, size, more) for x, y, z in places)


def _nested(element, depth, inside):
    for _ in range(depth):
        inside = f"<{element}>{inside}</{element.split()[0]}>"
    return inside


_DEEP_DEFAULTS = "".join(f'<default class="d{i}">' for i in range(5000)) + "</default>" * 5000
_REPLICATES = _nested('replicate count="100" offset="1 0 0"', 6, '<geom size="0.1"/>')
_FLEX = '<body name="f"><flexcomp name="f" type="grid" dim="3" count="{0} {0} {0}" spacing=".1 .1 .1"/></body>'
_ROPE = '<body name="c"><composite type="cable" curve="s" count="{} 1 1" size="1"><joint kind="main"/><geom size=".01"/></composite></body>'

_MJCF_ONLY = [
    ("a timestep that is no number", {"option": 'timestep="nan"'}, REFUSED),
    ("an infinite timestep", {"option": 'timestep="inf"'}, REFUSED),
    ("a timestep of a nanosecond", {"option": 'timestep="0.000000001"'}, REFUSED),
    ("a negative timestep", {"option": 'timestep="-0.002"'}, REFUSED),
    ("a hexadecimal timestep of 2^40 s", {"option": 'timestep="0x1p40"'}, REFUSED),
    ("gravity that is no number", {"option": 'gravity="0 0 nan"'}, REFUSED),
    ("two thousand million iterations", {"option": 'iterations="2000000000" tolerance="0"'}, REFUSED),
    ("two thousand million iterations of the line search", {"option": 'ls_iterations="2000000000"'}, REFUSED),
    ("two thousand million iterations without slip", {"option": 'noslip_iterations="2000000000"'}, REFUSED),
    ("two thousand million iterations of distance fields", {"option": 'sdf_iterations="2000000000"'}, REFUSED),
    ("an arena of a terabyte", {"top": '<size memory="1T"/>'}, REFUSED),
    ("two thousand million contacts", {"top": '<size nconmax="2000000000"/>'}, REFUSED),
    ("a hundred million keyframes", {"top": '<size nkey="100000000"/>'}, REFUSED),
    ("a billion numbers for users", {"top": '<size nuser_body="1000000000"/>'}, REFUSED),
    ("a numeric of two thousand million", {"top": '<custom><numeric name="n" size="2000000000" data="1"/></custom>'}, REFUSED),
    ("pictures of 2^31 pixels", {"top": '<visual><global offwidth="2147483647" offheight="2147483647"/></visual>'}, REFUSED),
    ("spheres drawn in a million slices", {"top": '<visual><quality numslices="1000000" numstacks="1000000"/></visual>'}, REFUSED),
    ("a texture of 10^10 pixels", {"top": '<asset><texture name="t" type="2d" builtin="flat" width="100000" height="100000"/></asset>'}, REFUSED),
    ("a texture at the limit of each side", {"top": '<asset><texture name="t" type="2d" builtin="flat" width="16384" height="16384"/></asset>'}, REFUSED),
    ("a height field of 10^10 points", {"top": '<asset><hfield name="h" nrow="100000" ncol="100000" size="1 1 1 1"/></asset>'}, REFUSED),
    ("a plugin", {"top": '<extension><plugin plugin="mujoco.sdf.torus"/></extension>'}, REFUSED),
    ("10^12 copies of a geom", {"bodies": _REPLICATES}, REFUSED),
    ("a flex of 10^9 points", {"bodies": _FLEX.format(1000)}, REFUSED),
    ("a flex at the limit of elements", {"bodies": _FLEX.format(46)}, REFUSED),
    ("a rope of 10^8 links", {"bodies": _ROPE.format(100_000_000)}, REFUSED),
    ("bodies nested 5000 deep", {"bodies": _nested("body", 5000, '<geom size="0.1"/>')}, REFUSED),
    ("defaults nested 5000 deep", {"top": f"<default>{_DEEP_DEFAULTS}</default>"}, REFUSED),
    ("a name of a million characters", {"bodies": f'<body name="{"n" * 1_000_000}"><geom size="0.1"/></body>'}, REFUSED),
    ("a place that is no number", {"bodies": '<body pos="nan 0 0"><geom size="0.1"/></body>'}, REFUSED),
    ("a body beyond what can be computed with", {"bodies": '<body pos="1e300 0 0"><freejoint/><geom size="1e200"/></body>'}, REFUSED),
    ("a document type with entities", {"before": '<!DOCTYPE m [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>\n'}, REFUSED),
    ("a file of the host included", {"top": '<include file="/etc/passwd"/>'}, REFUSED),
    ("a mesh of the host", {"top": '<asset><mesh name="m" file="../../../etc/hostname.stl"/></asset>'}, REFUSED),
    ("a user's sensor of 10^9 numbers", {"sensors": '<user name="u" dim="1000000000"/>'}, REFUSED),
    ("a sensor that remembers 10^9 readings", {"sensors": '<rangefinder name="u" site="ir1" nsample="1000000000" delay="1"/>'}, REFUSED),
    ("a sensor delayed by 10^9 seconds", {"sensors": '<rangefinder name="u" site="ir1" nsample="10" delay="1e9"/>'}, REFUSED),
    ("a camera that measures 10^10 rays", {"bodies": '<camera name="c" resolution="100000 100000"/>'}, REFUSED),
    ("3000 balls that all touch", {"bodies": _balls(3000, 15)}, LIMITED),
    ("600 balls that all touch", {"bodies": _balls(600, 9)}, LIMITED),
    ("2000 bodies that touch nothing", {"bodies": '<body><geom size="0.001" contype="0" conaffinity="0"/></body>' * 2_000}, SURVIVED),
    ("a body named nan", {"bodies": '<body name="nan"><geom size="0.001" pos="0 0 9"/></body>'}, SURVIVED),
]  # fmt: skip


def _descriptions():
    good = _text("ir.world.yaml")
    bomb = "".join(f"x{i}: &x{i} [{', '.join(f'*x{i - 1}' for _ in range(10)) if i else 'x'}]\n" for i in range(10))
    cameras = "\n".join(f"  c{i}: {{kind: camera, camera: overview, width: 4096, height: 4096}}" for i in range(3000))
    return [
        ("aliases that expand to 10^9", bomb + good, REFUSED),
        ("YAML nested 10000 deep", good + "extra: " + "[" * 10_000, REFUSED),
        ("a tag that makes an object", good.replace("mjcf: ir.xml", "mjcf: !!python/object/apply:os.system [id]"), REFUSED),
        ("a range that is no number", good.replace("range: [-1, 20]", "range: [.nan, .inf]"), REFUSED),
        ("a range beyond all numbers", good.replace("range: [-1, 20]", "range: [-1e999, 1e999]"), REFUSED),
        ("a default that is no number", good.replace("default: 5", "default: .nan"), REFUSED),
        ("an enormous range", good.replace("range: [-1, 20]", "range: [-1e308, 1e308]"), SURVIVED),
        ("a delay of 10^9 s", good.replace("max: 10}", "max: 10, delay: 1000000000}", 1), REFUSED),
        ("a picture of 10^12 pixels", good.replace("devices:", "devices:\n  c: {kind: camera, camera: overview, width: 1000000, height: 1000000}"), REFUSED),
        ("a scanner of 10^9 rays", good.replace("devices:", "devices:\n  s: {kind: laser_scan, site: ir1, angles: [-1, 1], rays: 1000000000, min: 0, max: 9}"), REFUSED),
        ("3000 cameras of 16 million pixels", good.replace("devices:", "devices:\n" + cameras), SURVIVED),
        ("a description of a megabyte", good + "# " + "x" * (1 << 20), REFUSED),
        ("a description that is no text", "\x00\x01\x02" * 1000, REFUSED),
        ("the world outside of the activity", good.replace("mjcf: ir.xml", "mjcf: ../../../../etc/passwd"), REFUSED),
    ]  # fmt: skip


def _png(width, height):
    """A black image, small as a file and large in memory."""
    packer, rows = zlib.compressobj(9), b""
    line = bytes(1 + width)
    for _ in range(height):
        rows += packer.compress(line)
    rows += packer.flush()

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


def _stl(faces):
    """A mesh that claims many faces but has one."""
    return bytes(80) + struct.pack("<I", faces) + struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)


def _sheet(side):
    """A mesh of side * side points on a paraboloid, all of which are corners of its convex hull."""
    points = "".join(f"v {x} {y} {(x * x + y * y) / side:g}\n" for x in range(side) for y in range(side))
    corner = range(1, side * (side - 1))
    return (points + "".join(f"f {i} {i + 1} {i + side}\n" for i in corner if i % side)).encode()


def _with_assets():
    texture = {"top": '<asset><texture name="t" type="2d" file="t.png"/></asset>'}
    mesh = {"top": '<asset><mesh name="m" file="m.{}"/></asset>', "bodies": '<geom type="mesh" mesh="m" pos="0 0 9"/>'}

    def meshed(suffix):
        return _mjcf(top=mesh["top"].format(suffix), bodies=mesh["bodies"]).encode()

    hfield = '<asset><hfield name="h" file="h.bin" size="1 1 1 1"/></asset>'
    return [
        ("a PNG of 10^9 pixels", {MJCF: _mjcf(**texture).encode(), "world/t.png": _png(30_000, 30_000)}, REFUSED),
        ("a PNG cut off", {MJCF: _mjcf(**texture).encode(), "world/t.png": _png(100, 100)[:60]}, REFUSED),
        ("a mesh that claims 2^32 faces", {MJCF: meshed("stl"), "world/m.stl": _stl(0xFFFFFFFF)}, REFUSED),
        ("a mesh of noise", {MJCF: meshed("msh"), "world/m.msh": struct.pack("<4i", 2**31 - 1, 2**31 - 1, 0, 2**31 - 1)}, REFUSED),
        ("a mesh of 160000 corners", {MJCF: meshed("obj"), "world/m.obj": _sheet(400)}, SURVIVED),
        ("a height field that claims 2^62 points", {MJCF: _mjcf(top=hfield).encode(), "world/h.bin": struct.pack("<2i", 2**31 - 1, 2**31 - 1)}, REFUSED),
    ]  # fmt: skip


def _through_includes():
    twice = b'<mujocoinclude><include file="b.xml"/><include file="b.xml"/></mujocoinclude>'
    attached = '<asset><model name="a" file="a.xml"/></asset>'
    frames = "".join(f'<frame pos="{i} 0 0"><attach model="a" body="r" prefix="p{i}_"/></frame>' for i in range(2000))
    model = b'<mujoco><worldbody><body name="r">' + b'<geom size="0.001"/>' * 2000 + b"</body></worldbody></mujoco>"
    return [
        ("includes that include each other", {MJCF: _mjcf(top='<include file="a.xml"/>').encode(), "world/a.xml": twice, "world/b.xml": b'<mujocoinclude><include file="a.xml"/></mujocoinclude>'}, REFUSED),
        ("4 million elements by attaching", {MJCF: _mjcf(top=attached, bodies=frames).encode(), "world/a.xml": model}, LIMITED),
    ]  # fmt: skip
