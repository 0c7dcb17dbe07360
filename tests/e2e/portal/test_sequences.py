"""The steps of sequences in the portal, with a real agent, a real simulation and a real browser."""

import re

import pytest

from portal.browsing import ROOT, expect, home_of, serious, shot, zip_of


@pytest.fixture(scope="module")
def page(page, tab_of):
    """A page in the same session whose user prefers reduced motion."""
    with tab_of(reduced_motion="reduce", storage_state=page.context.storage_state()) as tab:
        tab.goto(home_of(page))
        yield tab


@pytest.fixture(scope="module")
def build(page, tmp_path_factory):
    """The address of a finished build of the sensor that keeps a reading."""
    folder = tmp_path_factory.mktemp("activity")
    archive = zip_of(ROOT / "examples" / "ir-sensor-states-faulty", folder / "states.zip")
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_label("Zip file of an activity").set_input_files(archive)
    page.get_by_role("button", name="Build now: ir-sensor-states-faulty LifeCycle").click()
    page.get_by_role("tab", name="Log").wait_for()
    page.get_by_role("heading", name="Result", exact=True).wait_for()
    return page.url.split("?")[0]


def result_of(page, build, path):
    """A part of the result in the REST interface."""
    answer = page.request.get(build.replace("/builds/", "/api/v1/builds/") + "/result" + path)
    assert answer.ok, answer.text()
    return answer


def failed_case(page, build):
    """The first case that failed, and the index of the step that decides."""
    cases = result_of(page, build, "/cases?size=200").json()["items"]
    case = next(case for case in cases if case["verdict"] == "FAIL")
    return case, next(i for i, step in enumerate(case["steps"]) if step["verdict"] != "PASS")


def test_a_case_opens_to_its_steps_and_marks_the_first_failure(page, build):
    case, first = failed_case(page, build)
    page.goto(f"{build}?case={case['no']}")
    steps = page.get_by_role("dialog").get_by_role("table", name="Steps")
    steps.wait_for()
    deciding = steps.locator("tr[data-verdict][data-decides]")
    expect(deciding).to_have_count(1)
    expect(deciding.locator("td").first).to_have_text(str(first + 1))
    expect(deciding).to_contain_text("IndexOfSensor = ")
    expect(deciding).to_contain_text("state before: enabled=true")
    expect(steps.locator("tr[data-verdict]")).to_have_count(len(case["steps"]))
    shot(page, "steps")
    assert serious(page) == []


def test_a_forbidden_call_is_marked(page, build):
    cases = result_of(page, build, "/cases?size=200").json()["items"]
    no = next(c["no"] for c in cases if any(s["kind"] == "FORBIDDEN" for s in c["steps"]))
    page.goto(f"{build}?case={no}")
    expect(page.get_by_role("table", name="Steps")).to_contain_text("forbidden")


def test_the_diagram_shows_states_that_failed_and_links_to_the_case(page, build):
    page.goto(f"{build}?tab=states")
    diagram = page.get_by_role("group", name="Diagram of the states")
    diagram.wait_for()
    # Three booleans.
    expect(diagram.get_by_role("button")).to_have_count(8)
    assert diagram.locator('path[data-coverage="failed"]').count() > 0
    shot(page, "states")
    assert serious(page) == []
    table = page.get_by_role("table", name=re.compile("^Steps from enabled=true"))
    expect(table.locator('tr[data-coverage="failed"]').first).to_contain_text("Read")
    initial = diagram.get_by_role("button", name=re.compile("enabled=false, *near=false, *dropped=false"))
    initial.click()
    page.get_by_role("table", name="Steps from enabled=false, near=false, dropped=false").wait_for()


def test_the_replay_has_marks_of_the_steps(page, build):
    case, first = failed_case(page, build)
    page.goto(f"{build}/cases/{case['no']}")
    marks = page.get_by_role("group", name="Steps on the time axis")
    marks.wait_for()
    page.locator('[data-loaded="true"]').wait_for()
    deciding = marks.locator("[data-decides]")
    expect(deciding).to_have_count(1)
    deciding.click()
    clock = page.get_by_test_id("clock").inner_text()
    assert float(clock.split()[0]) == pytest.approx(case["steps"][first]["at"], abs=0.011)
    shot(page, "replay-steps")


def test_the_exports_have_a_line_for_each_step(page, build):
    case, first = failed_case(page, build)
    csv = result_of(page, build, "/cases.csv").text().splitlines()
    assert "Read.IndexOfSensor" in csv[0].split(",")
    assert len([line for line in csv if line.startswith(f"{case['no']},")]) == len(case["steps"])
    report = result_of(page, build, "/report").text()
    assert f'{first + 1}</td><td class="FAIL">FAIL</td>' in report
    assert "forbidden" in report


def test_states_and_calls_are_edited_next_to_their_diagram(page, build):
    """The guard of a new call, the state that it needs, and the diagram that follows."""
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_role("link", name="ir-sensor-states-faulty").first.click()
    page.get_by_role("link", name="Edit LifeCycle").first.click()
    diagram = page.get_by_role("group", name="Diagram of the states", exact=True)
    expect(diagram.get_by_role("button")).to_have_count(8)
    steps = page.get_by_role("list", name="Steps from enabled=false, near=false, dropped=false")
    expect(steps).to_contain_text("Read is forbidden, and made in invalid cases")

    shot(page, "edit-sequence", width=1440, height=1700)
    page.get_by_role("button", name="Add a state").click()
    page.get_by_label("Name of state 4").fill("read")
    page.get_by_role("button", name="Change a state by Read").click()
    change = page.get_by_label("State 1 that Read changes")
    change.select_option("read")
    # The state is used, and doubles the diagram.
    guard = page.get_by_label("Guard of Disable", exact=True)
    guard.click()
    page.keyboard.type("enabled || read")
    expect(diagram.get_by_role("button").first).to_contain_text("read=false")
    # The diagram follows a moment after the last key.
    expect(diagram.get_by_role("button").nth(8)).to_be_attached()
    page.get_by_role("button", name="Remove call Read").scroll_into_view_if_needed()
    assert serious(page) == []

    guard.click()
    page.keyboard.type(" && nothing")
    table = page.get_by_role("table", name="Calls and events")
    expect(table).to_contain_text("nothing")
    expect(page.get_by_role("status").filter(has_text="problem")).to_be_visible()


def test_a_new_model_of_sequences_is_proposed_and_generated(page, build):
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_role("link", name="ir-sensor-states-faulty").first.click()
    page.get_by_role("link", name="New test model").click()
    page.get_by_text("A sequence of calls in a case").click()
    expect(page.get_by_label("Name of state 1")).to_have_value("enabled")
    page.get_by_role("button", name="Parameters").click()
    page.get_by_role("group", name="Inputs of GetInfraredData").wait_for()
    page.get_by_role("button", name="Values of each parameter").click()
    page.get_by_role("region", name="Specification of IndexOfSensor of GetInfraredData").wait_for()
    page.get_by_role("button", name="Combination and").click()
    expect(page.get_by_role("status").filter(has_text="cases:")).to_be_visible()
    shot(page, "edit-sequence-expected")
    assert serious(page) == []
    page.get_by_role("button", name="Generate test cases").click()
    page.get_by_role("heading", name=re.compile("Sequences")).first.wait_for()
    page.get_by_role("button", name=re.compile("GetInfraredData")).first.click()
    expect(page.get_by_role("dialog").get_by_role("table", name="Steps")).to_be_visible()
    assert serious(page) == []
