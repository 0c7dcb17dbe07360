"""The PostgreSQL server of the programs is unpacked into `.sitaf` atomically."""

import os
import subprocess
from pathlib import Path

FAULTS = Path(__file__).parent
TOOL = """#!/bin/sh
for last; do :; done
case $0 in
  */mvn) for word; do case $word in -DoutputDirectory=*) touch "${word#*=}/driver.jar" ;; esac; done ;;
  */java) mkdir "$last/PG-1"; [ -z "$UNPACKING_FAILS" ] || { echo 'OutOfMemoryError: Java heap space' >&2; exit 1; } ;;
esac
"""


def set_up(home, tools, **environment):
    return subprocess.run(
        ["bash", "-euo", "pipefail", "-c", f"home={home}; source {FAULTS}/postgres.sh; set_up_postgres; echo $SITAF_POSTGRES_FOLDER"],
        env={**os.environ, "PATH": f"{tools}:{os.environ['PATH']}", "UNPACKING_FAILS": "", **environment},
        capture_output=True, text=True, check=False,
    )


def test_an_interrupted_unpacking_is_reported_and_leaves_nothing_behind(tmp_path):
    home, tools = tmp_path / "home", tmp_path / "tools"
    home.mkdir()
    tools.mkdir()
    (home / "pom.xml").write_text("<embedded-postgres.version>1.2.3</embedded-postgres.version>\n")
    for name in ("mvn", "javac", "java"):
        (tools / name).write_text(TOOL)
        (tools / name).chmod(0o755)

    failed = set_up(home, tools, UNPACKING_FAILS="yes")
    assert failed.returncode != 0
    assert "OutOfMemoryError" in failed.stderr
    assert not (home / ".sitaf" / "postgres-1.2.3").exists()

    again = set_up(home, tools)
    assert again.returncode == 0, again.stderr
    unpacked = home / ".sitaf" / "postgres-1.2.3" / "unpacked"
    assert again.stdout.strip() == str(unpacked)
    assert (unpacked / "PG-1").is_dir()

    # The second use needs neither Maven nor the network.
    assert set_up(home, tools, UNPACKING_FAILS="yes").returncode == 0
