"""The programs of this folder in their short forms: each says itself whether all was held."""

import subprocess

import pytest

LIMIT_S = 400


@pytest.fixture(scope="module")
def outage(installed, tmp_path_factory):
    """Begins the outage, most of which is waiting, so that the others run meanwhile."""
    said = tmp_path_factory.mktemp("outage") / "said"
    with said.open("wb") as out:
        process = subprocess.Popen(
            # A few agents: the twenty of the whole program compile at once, and leave nothing to what runs beside them.
            [installed.root / "sitaf", "bench", "outage", "--away-s", "60", "--agents", "8"],
            cwd=installed.root, stdin=subprocess.DEVNULL, stdout=out, stderr=out,
        )
    yield process, said
    if process.poll() is None:
        # As an interrupt of a person: the program ends what it has started.
        process.terminate()
        process.wait(60)


@pytest.mark.parametrize(
    ("program", "arguments"),
    [("lease", ()), ("cluster", ("--kills", "3")), ("kill", ("--kills", "20"))],
    ids=["lease", "cluster", "kill"],
)
def test_what_dies_or_falls_silent_costs_no_result(installed, outage, program, arguments):
    ran = installed("bench", program, *arguments)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.splitlines()[-1] == f"{program}: held"


def test_results_wait_for_a_server_that_is_away(outage):
    process, said = outage
    process.wait(LIMIT_S)
    output = said.read_text()
    assert process.returncode == 0, output
    assert "outage: held" in output.splitlines(), output
