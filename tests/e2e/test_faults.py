"""The programs that harm running systems, in their short forms."""

import subprocess

import pytest

SHORT = {
    "kill": ["--kills", "20", "--pause-ms", "10"],
    "outage": ["--away-s", "60", "--agents", "8", "--pause-ms", "250"],
    "lease": ["--lease-s", "6"],
    "cluster": ["--kills", "2"],
    "load": ["--seconds", "8", "--agents", "100", "--database", "h2"],
}


@pytest.mark.parametrize("name", SHORT)
def test_a_system_that_is_harmed_loses_nothing(sitaf, name):
    run = subprocess.run(
        [str(sitaf.root / "sitaf"), "bench", name, *SHORT[name]],
        capture_output=True, text=True, timeout=600, check=False,
    )
    last = run.stdout.strip().splitlines()[-1] if run.stdout.strip() else ""
    if name == "load":
        # The speed of a machine that runs all other tests says nothing; what may be lost says all.
        short = [row for row in run.stdout.splitlines() if row.endswith("SHORT")]
        assert last.startswith("load: "), run.stdout + run.stderr[-4000:]
        assert not [row for row in short if "lost" in row or "without a result" in row or "connected" in row], short
        return
    assert last == f"{name}: held", run.stdout + run.stderr[-4000:]
