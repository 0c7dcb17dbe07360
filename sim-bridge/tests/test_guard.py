"""TLS and token of a bridge that other machines can connect to."""

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import grpc
import pytest

from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.wire import simulation_pb2_grpc as pb_grpc
from tests.client import running_bridge

TOKEN = "a-token-of-enough-length"


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("guard")
    command = ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes"]
    command += ["-keyout", "key.pem", "-out", "cert.pem", "-days", "2", "-subj", "/CN=localhost"]
    command += ["-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1"]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    (folder / "token").write_text(TOKEN + "\n")
    return folder


def options(files: Path) -> list[str]:
    return [
        f"--tls-cert={files / 'cert.pem'}",
        f"--tls-key={files / 'key.pem'}",
        f"--token-file={files / 'token'}",
    ]


@pytest.fixture(scope="module")
def channel(files: Path) -> Iterator[grpc.Channel]:
    with running_bridge(*options(files), listen="0.0.0.0:0") as address:
        port = address.rpartition(":")[2]
        credentials = grpc.ssl_channel_credentials((files / "cert.pem").read_bytes())
        with grpc.secure_channel(f"localhost:{port}", credentials) as channel:
            yield channel


def ask(channel: grpc.Channel, *metadata: tuple[str, str]) -> str:
    stub = pb_grpc.SimulationControlStub(channel)
    return stub.GetSimulatorFeatures(pb.GetSimulatorFeaturesRequest(), metadata=metadata, timeout=10).engine


def test_every_call_works_with_the_token(channel: grpc.Channel) -> None:
    assert ask(channel, ("authorization", f"Bearer {TOKEN}")) == "MuJoCo"


@pytest.mark.parametrize("given", [[], [("authorization", "Bearer no")], [("authorization", TOKEN)]])
def test_calls_without_the_token_are_rejected(channel: grpc.Channel, given: list[tuple[str, str]]) -> None:
    with pytest.raises(grpc.RpcError) as raised:
        ask(channel, *given)
    assert isinstance(raised.value, grpc.Call)
    assert raised.value.code() == grpc.StatusCode.UNAUTHENTICATED


def test_streams_without_the_token_are_rejected(channel: grpc.Channel) -> None:
    stub = pb_grpc.SimulationControlStub(channel)
    with pytest.raises(grpc.RpcError) as raised:
        list(stub.Operate(iter([pb.OperateRequest(ping=pb.PingRequest())]), timeout=10))
    assert isinstance(raised.value, grpc.Call)
    assert raised.value.code() == grpc.StatusCode.UNAUTHENTICATED


def serve(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "sitaf_bridge", "serve", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=60)


def test_other_addresses_need_tls_and_token() -> None:
    ended = serve("--listen", "0.0.0.0:0")
    assert ended.returncode == 1
    assert "--tls-cert, --tls-key and --token-file" in ended.stderr


def test_certificate_key_and_token_must_be_given_together(files: Path) -> None:
    ended = serve("--listen", "127.0.0.1:0", f"--token-file={files / 'token'}")
    assert ended.returncode == 1
    assert "must be given together" in ended.stderr


def test_a_short_token_is_refused(files: Path, tmp_path: Path) -> None:
    (tmp_path / "token").write_text("short")
    ended = serve("--listen", "0.0.0.0:0", *options(files)[:2], f"--token-file={tmp_path / 'token'}")
    assert ended.returncode == 1
    assert "at least 16" in ended.stderr
