"""`./sitaf explain` and `./sitaf replay`."""

import json


def test_a_relation_explains_the_faulty_sensor_and_its_bundle_replays(sitaf, tmp_path):
    causes = tmp_path / "causes.json"
    run = sitaf("explain", "examples/ir-sensor-faulty", "--json", causes, "--bundles", tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "fails where IndexOfSensor == NumOfSensor, whatever the rest" in run.stdout
    explained = json.loads(causes.read_text())
    (cause,) = explained["causes"]
    assert cause["relation"] == "IndexOfSensor == NumOfSensor"
    assert cause["parameters"] == {}
    assert len(cause["cases"]) == 5
    assert explained["executions"] <= 20
    assert explained["unexplained"] == []

    (bundle,) = tmp_path.glob("*.zip")
    replay = sitaf("replay", bundle)
    assert replay.returncode == 0, replay.stdout + replay.stderr
    assert "the verdict and the outputs are the same as in the bundle" in replay.stdout


def test_nothing_is_explained_if_no_case_failed(sitaf, tmp_path):
    run = sitaf("explain", "examples/heading", "--json", tmp_path / "causes.json")
    assert run.returncode == 0, run.stdout + run.stderr
    assert json.loads((tmp_path / "causes.json").read_text()) == {"causes": [], "executions": 0, "unexplained": []}
