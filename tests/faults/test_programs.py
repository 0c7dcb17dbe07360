"""Runs the programs of this folder in their short forms; each checks its own targets."""

import subprocess

import pytest

LIMIT_S = 400


@pytest.fixture(scope="module")
def outage(installed, tmp_path_factory):
    """Start the outage, which mostly waits, so that the others run at the same time."""
    log = tmp_path_factory.mktemp("outage") / "log"
    with log.open("wb") as out:
        process = subprocess.Popen(
            # Few agents: the twenty of the full program compile at the same time and would slow down the others.
            [installed.root / "sitaf", "bench", "outage", "--away-s", "60", "--agents", "4"],
            cwd=installed.root, stdin=subprocess.DEVNULL, stdout=out, stderr=out,
        )
    yield process, log
    if process.poll() is None:
        # Like Ctrl-C: the program ends the processes that it started.
        process.terminate()
        process.wait(60)


@pytest.mark.parametrize(
    ("program", "arguments"),
    [
        pytest.param("lease", (), id="lease"),
        pytest.param("hardware", ("--kills", "3", "--deaths", "1", "--grace-s", "2"), id="hardware"),
        pytest.param("cluster", ("--kills", "1"), id="cluster"),
        pytest.param("cluster", ("--kills", "3"), id="cluster-longer", marks=pytest.mark.long),
        pytest.param("kill", ("--kills", "5", "--seed", "5", "--within-s", "240"), id="kill"),
        pytest.param("kill", ("--kills", "20", "--within-s", "240"), id="kill-longer", marks=pytest.mark.long),
    ],
)
def test_no_result_is_lost_after_kills_and_pauses(installed, outage, program, arguments):
    ran = installed("bench", program, *arguments)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.splitlines()[-1] == f"{program}: held"


def test_results_wait_until_the_server_is_back(outage):
    process, log = outage
    process.wait(LIMIT_S)
    output = log.read_text()
    assert process.returncode == 0, output
    assert "outage: held" in output.splitlines(), output
