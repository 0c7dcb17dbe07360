"""A server of the protocol: the one given by --server, or a bridge that ends with the tests."""

import subprocess
import sys
from pathlib import Path

import grpc
import pytest

from client import Client


def pytest_addoption(parser):
    parser.addoption("--server", help="gRPC target of a running simulator; default: start the bridge")
    parser.addoption("--provider", help="gRPC target of a running hardware provider; default: start those of the project")


@pytest.fixture(scope="session")
def address(request):
    """The address of the server."""
    named = request.config.getoption("--server")
    if named:
        yield named
        return
    command = [sys.executable, "-m", "sitaf_bridge", "serve", "--stop-with-stdin"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        word, _, target = process.stdout.readline().strip().partition(" ")
        assert word == "listening"
        yield target
        process.stdin.close()
        process.wait(20)
        process.stdout.close()


@pytest.fixture(scope="session")
def client(address):
    with grpc.insecure_channel(address) as channel:
        yield Client(channel)


@pytest.fixture
def refused():
    """Makes a call that must fail; returns the status code and the message."""

    def call(action):
        with pytest.raises(grpc.RpcError) as raised:
            action()
        return raised.value.code(), raised.value.details()

    return call


@pytest.fixture(scope="session")
def worlds():
    return Path(__file__).resolve().parents[2] / "examples"
