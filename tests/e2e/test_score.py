"""`./sitaf score`."""

import json
import shutil
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_the_sensor_of_the_paper_notices_what_is_beyond_its_tolerance(sitaf, tmp_path):
    file = tmp_path / "score.json"
    run = sitaf("score", "examples/ir-sensor", "--json", file)
    assert run.returncode == 1, run.stdout + run.stderr
    score = json.loads(file.read_text())
    assert set(score) == {"injected", "noticed", "equivalent", "survivors", "by_output"}
    assert score["injected"] >= 200
    assert score["injected"] == score["noticed"] + score["equivalent"] + len(score["survivors"])
    for survivor in score["survivors"]:
        assert survivor["where"] in survivor["fault"]
        assert "the tolerance of return (absolute 1.0E-9" in survivor["suggestion"]
    assert score["noticed"] >= 0.95 * (score["injected"] - score["equivalent"])


def test_an_unknown_model_is_an_error(sitaf):
    run = sitaf("score", "examples/ir-sensor", "--model", "Nothing")
    assert run.returncode == 2
    assert "--model Nothing" in run.stderr


def test_sequences_notice_steps_left_out_and_a_weaker_specification_fewer(sitaf, tmp_path):
    weaker = tmp_path / "gripper"
    shutil.copytree(EXAMPLES / "gripper", weaker)
    model = weaker / "Handling.xml"
    model.write_text(model.read_text().replace("<expected>present</expected>", ""))
    shares = []
    for folder in (EXAMPLES / "gripper", weaker):
        file = tmp_path / "score.json"
        run = sitaf("score", folder, "--budget", "150", "--json", file)
        assert run.returncode == 1, run.stdout + run.stderr
        score = json.loads(file.read_text())
        assert score["injected"] == score["noticed"] + score["equivalent"] + len(score["survivors"])
        shares.append(score["noticed"] / (score["injected"] - score["equivalent"]))
    assert shares[0] > 0.9
    assert shares[1] < shares[0] - 0.1
    assert "warning: nothing is expected of Look.return" in run.stdout
    faults = [survivor["fault"] for survivor in score["survivors"]]
    assert "Look.return: inverted" in faults
    assert "TakenAway: left out" in faults


@pytest.mark.long  # Compiles and runs each of twelve mutations; the others test the command.
def test_weaker_specifications_are_ordered_as_by_mutations_of_the_source(sitaf):
    run = sitaf("bench", "score", "12", "--no-time")
    assert "Kendall's tau of 11 specifications, 12 mutations" in run.stdout, run.stdout + run.stderr
    assert run.returncode == 0, run.stdout
