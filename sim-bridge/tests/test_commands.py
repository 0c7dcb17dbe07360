"""The command line, in separate processes."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from sitaf_bridge import __version__
from sitaf_bridge.server.address import BadAddress, parse_address
from tests.client import IR_WORLD, Bridge, ir_world, ranges, running_bridge

COMMAND = [sys.executable, "-m", "sitaf_bridge"]


def run(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=60)


@contextlib.contextmanager
def serve(*options: str) -> Iterator[subprocess.Popen[str]]:
    pipe = subprocess.PIPE
    with subprocess.Popen([*COMMAND, "serve", *options], stdin=pipe, stdout=pipe, stderr=pipe, text=True) as process:
        try:
            yield process
        finally:
            # Otherwise a failed assertion would wait for the process forever.
            process.kill()


def first_lines(process: subprocess.Popen[str]) -> tuple[str, str]:
    assert process.stdout is not None
    return process.stdout.readline(), process.stdout.readline()


def test_serve_prints_its_address_first_and_then_its_versions() -> None:
    with serve() as process:
        address, version = first_lines(process)
        assert re.fullmatch(r"listening 127\.0\.0\.1:\d+\n", address)
        assert version.startswith(f"sitaf_bridge {__version__}, MuJoCo 4.0.0, device kinds: range, laser_scan, imu, ")
        process.terminate()


def test_serve_lists_the_given_worlds(tmp_path: Path) -> None:
    (tmp_path / "bad.world.yaml").write_text("mjcf: nothing.xml\n", "utf-8")
    with serve(str(IR_WORLD.parent), str(tmp_path)) as process:
        first_lines(process)
        assert process.stdout is not None
        good, bad, count = (process.stdout.readline().rstrip("\n") for _ in range(3))
        assert good == f"world {IR_WORLD}/ir.world.yaml: 1 parameters, 7 devices, 1 observations"
        assert bad.startswith(f"world {tmp_path}/bad.world.yaml: cannot be loaded: bad.world.yaml:1: ")
        assert count.startswith("2 worlds")
        process.terminate()


def test_serve_reports_a_missing_world() -> None:
    ran = run("serve", "nowhere/at/all")
    assert ran.returncode == 2
    assert "nowhere/at/all: no such file or folder" in ran.stderr


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_serve_ends_cleanly_on_a_signal(number: signal.Signals) -> None:
    with serve() as process:
        address = first_lines(process)[0].split()[1]
        bridge = Bridge(address)
        bridge.create(ir_world())
        bridge.channel.close()
        process.send_signal(number)
        _, errors = process.communicate(timeout=120)
        assert (process.returncode, errors) == (0, "")


def test_serve_ends_with_its_standard_input() -> None:
    with serve("--stop-with-stdin") as process:
        first_lines(process)
        assert process.stdin is not None
        assert process.poll() is None
        process.stdin.close()
        assert process.wait(120) == 0


@pytest.mark.slow
def test_serve_ends_with_its_parent() -> None:
    parent = subprocess.Popen(["sleep", "60"])
    try:
        with serve("--parent-pid", str(parent.pid)) as process:
            first_lines(process)
            time.sleep(1)
            assert process.poll() is None
            parent.kill()
            assert process.wait(120) == 0
    finally:
        parent.kill()
        parent.wait()


@pytest.mark.slow
def test_a_killed_bridge_leaves_no_process() -> None:
    with serve() as process:
        bridge = Bridge(first_lines(process)[0].split()[1])
        bridge.create(ir_world())
        children = _descendants(process.pid)
        assert children
        process.kill()
        process.wait()
        bridge.channel.close()
    deadline = time.monotonic() + 10
    while any(_is_running(child) for child in children):
        assert time.monotonic() < deadline, "a compiling process outlived its bridge"
        time.sleep(0.05)


def _descendants(pid: int) -> list[int]:
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            name, _, rest = stat.read_text().rpartition(")")
        except OSError:
            continue
        if int(rest.split()[1]) == pid:
            child = int(name.split()[0])
            found += [child, *_descendants(child)]
    return found


def _is_running(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


@pytest.mark.slow
def test_serve_listens_on_a_unix_socket(tmp_path: Path) -> None:
    path = tmp_path / "bridge.sock"
    for _ in range(2):
        with running_bridge(listen=f"unix:{path}") as address:
            assert address == f"unix:{path}"
            bridge = Bridge(address)
            assert set(ranges(bridge.create(ir_world()).read()).values()) == {5.0}
            bridge.channel.close()


@pytest.mark.parametrize("address", ["0.0.0.0:0", "[::]:0", "192.168.0.1:50051", "example.org:80", "nonsense", "unix:"])
def test_serve_refuses_other_addresses_than_loopback(address: str) -> None:
    ran = run("serve", "--listen", address)
    assert (ran.returncode, ran.stdout) == (1, "")
    assert address in ran.stderr


@pytest.mark.slow
def test_two_bridges_never_share_a_port() -> None:
    with running_bridge() as address:
        ran = run("serve", "--listen", address)
        assert (ran.returncode, ran.stdout) == (1, "")
        assert f"cannot listen on {address}" in ran.stderr


@pytest.mark.parametrize(
    ("text", "target"),
    [
        ("127.0.0.1:0", "127.0.0.1:0"),
        ("127.9.9.9:1", "127.9.9.9:1"),
        ("localhost:7", "127.0.0.1:7"),
        ("[::1]:0", "[::1]:0"),
        ("unix:/a/b", "unix:/a/b"),
        ("unix:///a/b", "unix:/a/b"),
        ("unix:b", f"unix:{os.getcwd()}/b"),
    ],
)
def test_an_address_becomes_a_target(text: str, target: str) -> None:
    assert parse_address(text).target == target


@pytest.mark.parametrize("text", ["127.0.0.1", "127.0.0.1:99999", ":0", "127.0.0.1:x", "unix:/" + "x" * 200])
def test_a_malformed_address_is_refused(text: str) -> None:
    with pytest.raises(BadAddress):
        parse_address(text)


def test_describe_prints_a_world() -> None:
    ran = run("describe", IR_WORLD / "ir.world.yaml")
    assert ran.returncode == 0
    assert ran.stderr == ""
    assert (
        "parameter    Distance [m] -1..20, default 5: sets body.obstacle.pos.x by gap ir1..obstacle_front" in ran.stdout
    )
    assert "device       ir7: range" in ran.stdout
    assert "observation  robot_x [m]: x of robot" in ran.stdout


def test_describe_prints_errors_and_exits_with_2(tmp_path: Path) -> None:
    bad = tmp_path / "bad.world.yaml"
    bad.write_text("mjcf: none.xml\nnonsense: 1\n")
    for path, what in ((bad, "bad.world.yaml:2: nonsense"), (tmp_path / "missing.world.yaml", "No such file")):
        ran = run("describe", path)
        assert (ran.returncode, ran.stdout) == (2, "")
        assert what in ran.stderr


def test_describe_ignores_links_to_other_folders(tmp_path: Path) -> None:
    outside = tmp_path / "outside.xml"
    outside.write_text('<mujocoinclude><worldbody><geom size="1"/></worldbody></mujocoinclude>')
    folder = tmp_path / "world"
    folder.mkdir()
    (folder / "link.xml").symlink_to(outside)
    (folder / "w.xml").write_text('<mujoco>\n<include file="link.xml"/></mujoco>')
    (folder / "w.world.yaml").write_text("mjcf: w.xml")
    ran = run("describe", folder / "w.world.yaml")
    assert ran.returncode == 2
    assert "w.xml:2: 'link.xml' is not among the world's files" in ran.stderr
