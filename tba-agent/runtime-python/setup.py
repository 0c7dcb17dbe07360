"""Builds the package; generates the protocol messages first, which pyproject.toml cannot declare."""

import shutil
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = Path(__file__).resolve().parent
PROTO_ROOT = HERE.parents[1] / "proto" / "src" / "main" / "proto"
PROTO = "sitaf/sim/v1/simulation.proto"
WIRE = HERE / "src" / "sitaf_runtime" / "simulation" / "wire"


class BuildWithStubs(build_py):
    """Generates the messages in `sitaf_runtime.simulation.wire` from the proto files, then builds; also for `-e`."""

    def run(self) -> None:
        """Generate into the source tree (ignored by git), where both kinds of installation find them."""
        generate_stubs()
        # Otherwise modules of an earlier version would be installed, too.
        for package in ("sitaf_runtime", "sitaf_ros"):
            shutil.rmtree(Path(self.build_lib) / package, ignore_errors=True)
        super().run()


def generate_stubs() -> None:
    """Run protoc on the simulator's protocol."""
    from importlib.resources import files

    from grpc_tools import protoc  # only the build environment has it

    if not (PROTO_ROOT / PROTO).is_file():
        raise SystemExit(f"{PROTO_ROOT / PROTO} is missing: build sitaf-runtime inside a checkout of the project")
    arguments = [
        "protoc",
        f"-I{PROTO_ROOT}",
        f"-I{files('grpc_tools') / '_proto'}",
        f"--python_out={WIRE}",
        f"--pyi_out={WIRE}",
        PROTO,
    ]
    if protoc.main(arguments) != 0:
        raise SystemExit(f"protoc failed on {PROTO}")


setup(cmdclass={"build_py": BuildWithStubs})
