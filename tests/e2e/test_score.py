"""`./sitaf score`."""

import json
import re
import shutil
from pathlib import Path

import pytest
from needs import cpp

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


@pytest.mark.parametrize("language", ["", pytest.param("-cpp", marks=cpp), "-python"])
def test_mutations_of_the_sources_are_noticed_unless_nothing_looks(sitaf, tmp_path, language):
    activity = shutil.copytree(EXAMPLES / f"ir-sensor{language}", tmp_path / "activity")
    (component,) = (f for f in (activity / "component").rglob("*") if f.suffix in (".java", ".cpp", ".py"))
    before = component.read_bytes()
    file = tmp_path / "score.json"
    run = sitaf("score", activity, "--budget", "0", "--mutations", "8", "--json", file, "--all")
    mutations = json.loads(file.read_text())["mutations"]
    assert mutations["made"] == 8, run.stdout + run.stderr
    assert mutations["noticed"] >= 4
    assert mutations["noticed"] + mutations["equivalent"] + len(mutations["survivors"]) == 8
    assert len(mutations["without_effect"]) == mutations["equivalent"]
    assert f"{mutations['equivalent']} change no recorded value" in run.stdout
    for mutation in mutations["without_effect"]:
        assert re.match(rf"component/.*{component.name}:\d+: ", mutation), mutation
        assert mutation in run.stdout
    assert component.read_bytes() == before


def test_mutations_survive_a_specification_that_looks_at_nothing(sitaf, tmp_path):
    activity = shutil.copytree(EXAMPLES / "ir-sensor-python", tmp_path / "activity")
    (model,) = (f for f in activity.glob("*.xml") if "expected" in f.read_text())
    text = re.sub(r"<expected[^>]*>.*?</expected>", "", model.read_text(), flags=re.DOTALL)
    model.write_text(text)
    file = tmp_path / "score.json"
    run = sitaf("score", activity, "--budget", "0", "--mutations", "6", "--json", file)
    assert run.returncode == 1, run.stdout + run.stderr
    mutations = json.loads(file.read_text())["mutations"]
    assert mutations["survivors"], mutations
    for survivor in mutations["survivors"]:
        assert survivor["where"].startswith("component/infrared_sensor.py:")
        assert re.match(r"case \d+: return is .* instead of .*; expect its value", survivor["suggestion"])


def test_mutations_need_sources(sitaf):
    """They are asked for before anything is executed."""
    run = sitaf("score", "examples/orocos-kdl", "--mutations", "5")
    assert run.returncode == 2, run.stdout
    assert "--mutations: the component has no sources in C++, Java or Python" in run.stderr
    assert "score" not in run.stdout
    run = sitaf("score", "examples/ir-sensor", "--mutations", "0")
    assert run.returncode == 2
    assert "--mutations: error: must be at least 1, not 0" in run.stderr


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
