"""The command line: `serve`, `describe`, `propose`, `guard` and `provide`."""

import argparse
import gc
import signal
import sys
import threading
from collections.abc import Sequence
from pathlib import Path

from sitaf_bridge import __version__
from sitaf_bridge.errors import BridgeError
from sitaf_bridge.server.address import BadAddress, parse_address, read_guard
from sitaf_bridge.server.serving import Settings, serving
from sitaf_bridge.server.stopping import StopSignal
from sitaf_bridge.world import isolation
from sitaf_bridge.world.catalog import Catalog
from sitaf_bridge.world.description.source import DESCRIPTION_SUFFIX, read_world
from sitaf_bridge.world.devices import KINDS
from sitaf_bridge.world.engine import DEVICE_KINDS, ENGINE, ENGINE_VERSION
from sitaf_bridge.world.proposal.world_proposal import propose as propose_world
from sitaf_bridge.world.world import World

# Exit codes.
OK = 0
CANNOT_LISTEN = 1
BAD_INPUT = 2
# Maximum number of device fields to list; a laser scan has hundreds.
MAX_SHOWN = 16


def main(arguments: list[str] | None = None) -> int:
    """Run one command; returns the exit code."""
    options = _parser().parse_args(arguments)
    if options.command == "propose":
        return _propose(options.robot, options.into)
    if options.command == "guard":
        return _guard(options.listen, options.devices)
    if options.command == "provide":
        return _provide(options)
    return _serve(options) if options.command == "serve" else _describe(options.world)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="sitaf_bridge", description="The robot simulator of SITAF.")
    parser.add_argument("--version", action="version", version=_version())
    commands = parser.add_subparsers(dest="command", required=True)
    serve = commands.add_parser("serve", help="serve simulations over gRPC until stopped")
    serve.add_argument(
        "--listen",
        default="127.0.0.1:0",
        metavar="ADDRESS",
        help="HOST:PORT (port 0: any free port) or unix:/path; beyond loopback with TLS only; default %(default)s",
    )
    serve.add_argument("--tls-cert", type=Path, metavar="FILE", help="PEM certificate chain; enables TLS")
    serve.add_argument("--tls-key", type=Path, metavar="FILE", help="PEM key of the certificate")
    serve.add_argument(
        "--token-file", type=Path, metavar="FILE", help="file with the token that every call must contain"
    )
    serve.add_argument(
        "--default-lease",
        type=_positive_float,
        default=60.0,
        metavar="S",
        help="seconds until a session without calls expires, unless its client requests a lease; default %(default)g",
    )
    serve.add_argument("--max-sessions", type=_positive_int, default=256, help="default %(default)s")
    serve.add_argument(
        "--threads", type=_positive_int, default=16, help="maximum concurrent calls; default %(default)s"
    )
    serve.add_argument(
        "--endpoints",
        type=Path,
        metavar="FOLDER",
        help="create sockets for test applications in FOLDER, each with one session and one world; "
        "a client of --listen opens them",
    )
    serve.add_argument("--parent-pid", type=_positive_int, metavar="PID", help="stop when this process ends")
    serve.add_argument("--stop-with-stdin", action="store_true", help="stop when stdin is closed")
    serve.add_argument(
        "worlds",
        nargs="*",
        type=Path,
        metavar="WORLD",
        help="a *.world.yaml file or a folder of them: compiled at start and listed; clients may send others",
    )
    describe = commands.add_parser("describe", help="print the content of a world, or its errors")
    describe.add_argument("world", type=Path, metavar="WORLD.world.yaml")
    propose = commands.add_parser("propose", help="write a world with guessed devices for a URDF, xacro or MJCF file")
    propose.add_argument("robot", type=Path, metavar="ROBOT")
    propose.add_argument("--into", type=Path, required=True, metavar="FOLDER", help="a folder that does not exist")
    guard = commands.add_parser(
        "guard", help="stand between a simulator and the providers of real devices, until stdin is closed"
    )
    guard.add_argument("--listen", required=True, metavar="unix:/PATH")
    guard.add_argument("--devices", type=Path, required=True, metavar="FILE", help="JSON, written by an agent")
    provide = commands.add_parser(
        "provide", help="serve the devices of a world as a hardware provider, which reads what the simulation says"
    )
    provide.add_argument("world", type=Path, metavar="WORLD.world.yaml")
    provide.add_argument("--listen", required=True, metavar="ADDRESS", help="unix:/PATH or 127.0.0.1:PORT")
    provide.add_argument("--device", action="append", metavar="NAME", help="only this device; may be repeated")
    return parser


def _guard(listen: str, devices: Path) -> int:
    ending = StopSignal()
    ending.on_signals()
    ending.with_stdin()
    try:
        from sitaf_bridge.hardware.guard import BadDevices, run  # noqa: PLC0415  # needs sitaf_hardware
    except ImportError as error:
        return _without_hardware(error)
    try:
        run(listen, devices, ending)
    except (BadDevices, OSError) as error:
        print(error, file=sys.stderr)
        return BAD_INPUT
    return OK


def _provide(options: argparse.Namespace) -> int:
    try:
        from sitaf_bridge.hardware.provide import devices_of, serve  # noqa: PLC0415  # needs sitaf_hardware
    except ImportError as error:
        return _without_hardware(error)
    try:
        devices = devices_of(Catalog().world(read_world(options.world)), options.device)
        serve(devices, options.listen)
    except (BridgeError, OSError) as error:
        print(error, file=sys.stderr)
        return BAD_INPUT
    return OK


def _without_hardware(error: ImportError) -> int:
    print(f"the package sitaf_hardware is missing ({error}); pip install ./hardware/python", file=sys.stderr)
    return CANNOT_LISTEN


def _propose(robot: Path, into: Path) -> int:
    try:
        proposed = propose_world(robot)
        into.mkdir(parents=True)
        for path, content in proposed.files.items():
            (into / path).parent.mkdir(parents=True, exist_ok=True)
            (into / path).write_bytes(content)
    except (BridgeError, OSError) as error:
        print(error, file=sys.stderr)
        return BAD_INPUT
    print(proposed.description)
    return OK


def _serve(options: argparse.Namespace) -> int:
    # A fork of this process costs nothing; a new interpreter would load all modules again.
    isolation.prepare()
    ending = StopSignal()
    ending.on_signals()
    missing = [str(path) for path in options.worlds if not path.exists()]
    if missing:
        print(f"sitaf_bridge serve: {', '.join(missing)}: no such file or folder", file=sys.stderr)
        return BAD_INPUT
    try:
        guard = read_guard(options.tls_cert, options.tls_key, options.token_file)
        address = parse_address(options.listen, guard)
        settings = Settings(
            address, options.default_lease, options.max_sessions, options.threads, guard, options.endpoints
        )
        # Modules are never freed, and scanning them for garbage doubled the time of a bulk call.
        gc.collect()
        gc.freeze()
        gc.set_threshold(100_000, 20, 20)
        catalog = Catalog()
        # Otherwise the first world would wait for the start of the compiler process.
        warming = threading.Thread(target=catalog.warm_up, name="warm-up", daemon=True)
        with serving(settings, catalog) as target:
            print(f"listening {target}", flush=True)
            print(_version(), flush=True)
            if options.parent_pid is not None:
                ending.with_parent(options.parent_pid)
            if options.stop_with_stdin:
                # Ctrl-C in a terminal is for the program that started this one, which closes the input.
                signal.signal(signal.SIGINT, signal.SIG_IGN)
                ending.with_stdin()
            if options.endpoints is not None:
                warming.start()
            _list_worlds(options.worlds, catalog)
            ending.wait()
    except BadAddress as error:
        print(f"sitaf_bridge serve: {error}", file=sys.stderr)
        return CANNOT_LISTEN
    return OK


def _list_worlds(places: Sequence[Path], catalog: Catalog) -> None:
    """Compile the given worlds and print a line for each."""
    found = [
        f for place in places for f in (sorted(place.rglob(f"*{DESCRIPTION_SUFFIX}")) if place.is_dir() else [place])
    ]
    for path in found:
        try:
            world = catalog.world(read_world(path))
        except BridgeError as error:
            reason = str(error).partition("\n")[0]
            print(f"world {path}: cannot be loaded: {reason}", flush=True)
            continue
        d = world.description
        counts = f"{len(d.parameters)} parameters, {len(d.devices)} devices, {len(d.observations)} observations"
        print(f"world {path}: {counts}", flush=True)
    if found:
        print(f"{len(found)} worlds; use `describe` for the content of a world", flush=True)


def _describe(path: Path) -> int:
    try:
        world = Catalog().world(read_world(path))
    except BridgeError as error:
        print(error, file=sys.stderr)
        return BAD_INPUT
    _print_world(world)
    return OK


def _print_world(world: World) -> None:
    description = world.description
    print(f"world        {description.file} (MJCF {description.mjcf})")
    print(f"digest       {world.digest}")
    print(f"timestep     {world.timestep_ns} ns")
    for p in description.parameters.values():
        bound = ", ".join(b.path + (f" by gap {b.gap.site}..{b.gap.geom}" if b.gap else "") for b in p.binds)
        print(f"parameter    {p.name} [{p.unit}] {p.low:g}..{p.high:g}, default {p.default:g}: sets {bound}")
    for d in description.devices.values():
        numbers = ", ".join(KINDS[d.kind].fields(d)[:MAX_SHOWN])
        print(f"device       {d.name}: {d.kind}" + (f" ({numbers})" if numbers else ""))
    for o in description.observations.values():
        print(f"observation  {o.name} [{o.unit}]: {o.text}")


def _version() -> str:
    kinds = ", ".join(DEVICE_KINDS)
    return f"sitaf_bridge {__version__}, {ENGINE} {ENGINE_VERSION}, device kinds: {kinds}"


def _positive_float(text: str) -> float:
    value = float(text)
    if not 0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} must be positive")
    return value


def _positive_int(text: str) -> int:
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} must be at least 1")
    return value
