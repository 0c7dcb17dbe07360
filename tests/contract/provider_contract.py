"""Providers of hardware for the compliance suite: the ones that it starts, or a running one."""

import os
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

from sockets import await_listener

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"


def simulated(world, address):
    """The devices of a world, served by the bridge."""
    return [sys.executable, "-m", "sitaf_bridge", "provide", EXAMPLES / world, "--listen", address]


def example(name, address):
    """The provider of an example with its device."""
    return [sys.executable, EXAMPLES / name / "provider" / "start.py", address]


PROVIDERS = {
    "simulated sensors": lambda address: simulated("ir-sensor/world/ir.world.yaml", address),
    "simulated base": lambda address: simulated("wall-distance/world/maze.world.yaml", address),
    "simulated joint": lambda address: simulated("joint-pid/world/joint.world.yaml", address),
    "serial line": lambda address: example("serial-range", address),
    "Modbus": lambda address: example("modbus-joint", address),
}


@contextmanager
def running(command_of):
    """A provider that ends with the block; yields its process and address."""
    with tempfile.TemporaryDirectory(prefix="sitaf-p") as folder:
        path = Path(folder) / "p.sock"
        command = [str(word) for word in command_of(f"unix:{path}")]
        process = subprocess.Popen(
            command, stdout=subprocess.DEVNULL, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
        )
        try:
            await_listener(path, process)
            yield process, f"unix:{path}"
        finally:
            process.terminate()
            process.wait(20)
