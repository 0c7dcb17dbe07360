"""Fault campaigns: every fault of the devices of an example, alone."""

import json
import shutil


def test_a_campaign_finds_a_controller_that_drives_without_readings(sitaf, tmp_path):
    found = tmp_path / "campaign.json"
    faulty = shutil.copytree(
        sitaf.root / "examples" / "sensor-dropout-faulty", tmp_path / "activity"
    )
    # As many cases as there are faults: each fault alone, once.
    run = sitaf("campaign", faulty, "--max-cases", "26", "--json", found)
    assert run.returncode == 1, run.stdout + run.stderr
    assert "stops without readings: broken at" in run.stdout
    result = json.loads(found.read_text())
    assert result["cases"] == 26
    table = {
        (row["device"], row["fault"]): row["behaviour"] for row in result["table"]
    }
    assert table["lidar", "dropout"] == "broke a condition"
    # The controller does not look at what the base measures.
    assert table["base", "offset"] == "unchanged"
    assert ("bumper", "ignored") not in table
    assert {row["behaviour"] for row in result["results"]} <= {
        "unchanged",
        "degraded and recovered",
        "stopped safely",
        "broke a condition",
        "crashed",
    }


def test_a_campaign_needs_a_case_for_each_fault_and_a_world(sitaf):
    few = sitaf("campaign", "examples/sensor-dropout", "--max-cases", "3")
    assert few.returncode == 2
    assert (
        "must be at least 26, the number of faults of the devices"
        in few.stdout + few.stderr
    )
    no_world = sitaf("campaign", "examples/median-filter")
    assert no_world.returncode == 2
    assert "no devices that can fail" in no_world.stdout + no_world.stderr
