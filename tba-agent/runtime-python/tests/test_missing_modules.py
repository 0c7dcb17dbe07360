"""A module that cannot be imported is attributed to the component or to the runtime."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SOURCES = Path(__file__).parents[1] / "src" / "sitaf_runtime"
DRIVER = """
from sitaf_runtime.{part} import anything
from sensors import Sensor
"""


@pytest.mark.parametrize(
    ("part", "missing", "reported"),
    [
        ("built", "sensors", "there is no module sensors: component.class"),
        (
            "not_built",
            "sitaf_runtime.not_built",
            "the runtime of Python tests is incomplete: it has no module sitaf_runtime.not_built",
        ),
        ("uses", "not_generated", "the runtime of Python tests is incomplete: it has no module not_generated"),
    ],
)
def test_a_missing_module_is_attributed_to_component_or_runtime(tmp_path, part, missing, reported):
    runtime = tmp_path / "sitaf_runtime"
    shutil.copytree(SOURCES, runtime, ignore=shutil.ignore_patterns("__pycache__"))
    (runtime / "uses.py").write_text("import not_generated\n")
    (runtime / "built.py").write_text("anything = None\n")
    harness = tmp_path / "sitaf_harness"
    harness.mkdir()
    (harness / "driver.py").write_text(DRIVER.format(part=part))
    ended = subprocess.run(
        [sys.executable, "-m", "sitaf_runtime", "sitaf_harness.driver", "--results", tmp_path / "results"],
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert ended.returncode == 3, ended.stderr
    assert reported in ended.stderr
    assert ("component.class" in ended.stderr) == (missing == "sensors")
