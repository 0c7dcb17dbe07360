"""Builds the package; generates the protocol messages first, which pyproject.toml cannot declare."""

import re
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = Path(__file__).resolve().parent
PROTO_ROOT = HERE.parents[1] / "proto" / "src" / "main" / "proto"
PROTO = "sitaf/hardware/v1/hardware.proto"
WIRE = HERE / "src" / "sitaf_hardware" / "wire"


class BuildWithStubs(build_py):
    """Generates `sitaf_hardware.wire` from the proto file, then builds; also for `-e`."""

    def run(self) -> None:
        """Generate into the source tree (ignored by git), where both kinds of installation find them."""
        generate_stubs()
        super().run()


def generate_stubs() -> None:
    """Run protoc on the protocol of hardware providers."""
    from grpc_tools import protoc  # noqa: PLC0415  # only the build environment has it

    if not (PROTO_ROOT / PROTO).is_file():
        raise SystemExit(f"{PROTO_ROOT / PROTO} is missing: build sitaf-hardware inside a checkout of the project")
    outputs = [f"--{kind}={WIRE}" for kind in ("python_out", "pyi_out", "grpc_python_out")]
    if protoc.main(["protoc", f"-I{PROTO_ROOT}", *outputs, PROTO]) != 0:
        raise SystemExit(f"protoc failed on {PROTO}")
    # protoc mirrors the proto package as folders; the stubs live inside of this package.
    generated = WIRE / "sitaf" / "hardware" / "v1"
    for file in sorted(generated.iterdir()):
        text = re.sub(r"^from sitaf\.hardware\.v1 import", "from . import", file.read_text("utf-8"), flags=re.M)
        (WIRE / file.name).write_text(text, "utf-8")
        file.unlink()
    for folder in (generated, *list(generated.parents)[:2]):
        folder.rmdir()


setup(cmdclass={"build_py": BuildWithStubs})
