"""What tests need beyond the required software; without it they are skipped, except in continuous integration."""

import os
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest


def installed(*packages):
    return all(shutil.which(tool) for tool in ("g++", "pkg-config", "grpc_cpp_plugin")) and all(map(known, packages))


@cache
def known(package):
    # With the libraries that it requires, the answer for gRPC takes most of a second.
    ask = ["pkg-config", "--maximum-traverse-depth=1", "--exists", package]
    return subprocess.run(ask, check=False).returncode == 0


def unless(there, reason):
    # In CI, a skipped test would never run.
    return pytest.mark.skipif(not there and "CI" not in os.environ, reason=reason)


def requires(*packages):
    return unless(installed(*packages), "needs ./sitaf doctor --install cpp, and " + ", ".join(packages))


CPP = ("grpc++", "protobuf", "expat")
cpp = requires(*CPP)
kdl = requires(*CPP, "orocos-kdl")
fmt = requires(*CPP, "eigen3", "fmt")
cmake = unless(shutil.which("cmake") and installed(*CPP, "eigen3"), "needs ./sitaf doctor --install cpp, cmake and eigen3")
clang = unless(shutil.which("clang++"), "needs clang++")
gdb = unless(shutil.which("gdb") and installed(*CPP), "needs ./sitaf doctor --install cpp, and gdb")
socat = unless(shutil.which("socat"), "needs socat, the cable of the serial range finder")
postgresql = unless(
    shutil.which("pg_dump") and Path("/usr/lib/postgresql").is_dir(), "needs the packages postgresql and postgresql-client"
)
sandbox = unless(shutil.which("bwrap"), "needs bubblewrap")
