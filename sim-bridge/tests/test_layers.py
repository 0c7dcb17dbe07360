"""The layers of the package: server → session → world; only world imports MuJoCo."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]


def test_the_layers_import_downwards_only() -> None:
    program = "import sys; from importlinter.cli import lint_imports_command; sys.exit(lint_imports_command())"
    ran = subprocess.run(
        [sys.executable, "-c", program, "--no-cache"], cwd=ROOT, capture_output=True, text=True, timeout=120
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert "3 kept, 0 broken" in ran.stdout


def test_no_file_grows_beyond_400_lines() -> None:
    files = [*ROOT.glob("src/**/*.py"), *ROOT.glob("tests/*.py"), ROOT / "setup.py"]
    long = [str(path) for path in files if "_pb2" not in path.name and len(path.read_text().splitlines()) > 400]
    assert len(files) > 30
    assert long == []
