"""`./sitaf compare --new-bridge`: the same activity on another simulation bridge, also of another release of MuJoCo."""

import json
import os
import re
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

import pytest

OTHER_MUJOCO = "3.17.0"


@contextmanager
def bridge(modules=None, endpoints=True):
    """A running bridge; yields its address. The path of a socket must be short."""
    with tempfile.TemporaryDirectory(prefix="sitaf-n") as folder:
        address = f"unix:{folder}/control"
        process = subprocess.Popen(
            [sys.executable, "-m", "sitaf_bridge", "serve", "--listen", address]
            + (["--endpoints", folder] if endpoints else []),
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | ({"PYTHONPATH": str(modules)} if modules else {}),
        )
        try:
            assert process.stdout.readline().startswith("listening")
            yield address
            assert process.poll() is None
            # Its endpoints are closed.
            assert {path.name for path in Path(folder).iterdir()} <= {"control", "control.ops"}
        finally:
            process.terminate()
            process.wait(30)


@pytest.fixture(scope="module")
def other_mujoco(tmp_path_factory):
    """The modules of another release of MuJoCo."""
    folder = tmp_path_factory.mktemp("mujoco")
    subprocess.run(
        [sys.executable, "-m", "pip", "install", "-q", "--no-deps", "--target", folder, f"mujoco=={OTHER_MUJOCO}"],
        check=True,
    )
    return folder


def compared(sitaf, tmp_path, name, address):
    file = tmp_path / "comparison.json"
    activity = f"examples/{name}"
    done = sitaf("compare", activity, activity, "--new-bridge", address, "--json", file)
    return done.returncode, json.loads(file.read_text()) if file.exists() else None, done.stdout + done.stderr


def test_the_same_release_on_another_bridge_has_no_differences(sitaf, tmp_path):
    with bridge() as address:
        code, found, output = compared(sitaf, tmp_path, "joint-pid", address)
    assert code == 0, output
    assert found["cases"] > 0
    assert found["differences"] == found["unstable"] == found["not_comparable"] == []
    assert "simulator of NEW: sitaf-bridge " in output


def test_another_release_of_the_simulator(sitaf, tmp_path, other_mujoco):
    with bridge(other_mujoco) as address:
        code, found, output = compared(sitaf, tmp_path, "joint-pid", address)
    # Whether the releases differ is for MuJoCo to say.
    assert code in (0, 1), output
    assert found["cases"] == 6
    assert re.search(rf"simulator sitaf-bridge \S+ \(MuJoCo \S+\) -> sitaf-bridge \S+ \(MuJoCo {OTHER_MUJOCO}\)", output)


def test_a_bridge_that_cannot_be_used_is_refused(sitaf, tmp_path):
    with bridge(endpoints=False) as address:
        code, _, output = compared(sitaf, tmp_path, "joint-pid", address)
        assert code == 2
        assert f"--new-bridge {address}: error: opens no endpoints for builds" in output
        assert "--endpoints FOLDER" in output
        code, _, output = compared(sitaf, tmp_path, "simple-pid", address)
        assert code == 2
        assert "has no effect, because NEW has no world" in output
    code, _, output = compared(sitaf, tmp_path, "joint-pid", "unix:/nowhere/control")
    assert code == 2
    assert "unix:/nowhere/control does not answer" in output
    assert "python -m sitaf_bridge serve" in output
