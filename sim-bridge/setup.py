"""Builds the package; what setuptools cannot say declaratively is that the wire's stubs are generated first."""

import re
import shutil
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = Path(__file__).resolve().parent
PROTO_ROOT = HERE.parent / "proto" / "src" / "main" / "proto"
PROTOS = [f"sitaf/sim/v1/{name}.proto" for name in ("simulation", "administration")]
WIRE = HERE / "src" / "sitaf_bridge" / "wire"


class BuildWithStubs(build_py):
    """Generates `sitaf_bridge.wire` from the project's proto files, then builds as usual (also for `-e`)."""

    def run(self) -> None:
        """Generate into the source tree (ignored by git), where both kinds of installation find it."""
        generate_stubs()
        # Modules of an earlier version would otherwise be installed along.
        shutil.rmtree(Path(self.build_lib) / "sitaf_bridge", ignore_errors=True)
        super().run()


def generate_stubs() -> None:
    """Run protoc on the wire of the simulator."""
    from importlib.resources import files  # noqa: PLC0415

    from grpc_tools import protoc  # noqa: PLC0415  # only the build environment has it

    for proto in PROTOS:
        if not (PROTO_ROOT / proto).is_file():
            raise SystemExit(f"{PROTO_ROOT / proto} is missing: build sitaf-bridge inside a checkout of the project")
    arguments = [
        "protoc",
        f"-I{PROTO_ROOT}",
        f"-I{files('grpc_tools') / '_proto'}",
        f"--python_out={WIRE}",
        f"--pyi_out={WIRE}",
        f"--grpc_python_out={WIRE}",
        *PROTOS,
    ]
    if protoc.main(arguments) != 0:
        raise SystemExit(f"protoc failed on {', '.join(PROTOS)}")
    # protoc mirrors the proto package as folders and imports from there. The stubs live inside this package
    # instead, so that another part of the project can bring its own copy into the same environment.
    generated = WIRE / "sitaf" / "sim" / "v1"
    for file in sorted(generated.iterdir()):
        text = re.sub(r"^from sitaf\.sim\.v1 import", "from . import", file.read_text("utf-8"), flags=re.M)
        (WIRE / file.name).write_text(text, "utf-8")
        file.unlink()
    for folder in (generated, *list(generated.parents)[:2]):
        folder.rmdir()


setup(cmdclass={"build_py": BuildWithStubs})
