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


def test_a_ros_node_is_explained_and_its_bundle_replays(sitaf, tmp_path):
    """Its interface files are those of the installation, which are not part of the activity."""
    run = sitaf("explain", "examples/wall-stop-ros-faulty", "--cases", "5", "--bundles", tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "fails where `start.data` is 0.4, whatever the rest" in run.stdout
    replay = sitaf("replay", next(tmp_path.glob("*.zip")))
    assert replay.returncode == 0, replay.stdout + replay.stderr
    assert "the verdict and the outputs are the same as in the bundle" in replay.stdout


def test_nothing_is_explained_if_no_case_failed(sitaf, tmp_path):
    run = sitaf("explain", "examples/heading", "--json", tmp_path / "causes.json")
    assert run.returncode == 0, run.stdout + run.stderr
    assert json.loads((tmp_path / "causes.json").read_text()) == {"causes": [], "executions": 0, "unexplained": []}


def test_selected_cases_that_pass_are_named(sitaf):
    run = sitaf("explain", "examples/heading", "--cases", "1,2")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "cases 1, 2 pass; there is nothing to explain" in run.stdout
    assert "no case failed" not in run.stdout


def test_a_folder_is_no_bundle(sitaf, tmp_path):
    run = sitaf("replay", tmp_path)
    assert run.returncode == 2
    assert f"{tmp_path}: error: is a folder; name a zip that ./sitaf explain --bundles has written" in run.stderr

    (tmp_path / "case-1.zip").write_bytes(b"")
    run = sitaf("replay", tmp_path)
    assert run.returncode == 2
    assert f"is a folder; name one of its bundles, such as {tmp_path}/case-1.zip" in run.stderr
