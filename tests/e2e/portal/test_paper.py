"""The evaluation of the paper (section 4) in a real browser with the whole system."""

import re

from portal.browsing import ROOT, build, create_activity, expect, fill_expected, shot, write_model


def test_the_evaluation_of_the_paper_by_mouse_and_keyboard(page, tmp_path):
    create_activity(page, "ir-sensor", "ir-sensor", tmp_path)
    write_model(page)
    fill_expected(page)
    shot(page, "test-cases")
    build(page)
    page.get_by_text("All passed").wait_for()
    expect(page.get_by_role("table", name="Cases")).to_have_attribute("aria-rowcount", "57")
    expect(page.get_by_text("without a check")).to_have_count(0)
    shot(page, "result-table")
    page.get_by_role("tab", name="Graphs").click()
    page.get_by_role("img", name=re.compile("Of 55 cases 55 passed")).locator("canvas").wait_for()
    shot(page, "result-graphs")
    page.get_by_role("tab", name="Coverage").click()
    page.get_by_role("table", name="Files of the component").get_by_text("InfraredSensor.java").wait_for()
    expect(page.get_by_role("textbox", name=re.compile("^Text of component"))).to_contain_text("class InfraredSensor")
    expect(page.locator(".cm-sign-reached").first).to_be_visible()
    shot(page, "coverage", height=1500)
    page.get_by_role("tab", name="Log").click()
    expect(page.get_by_role("log", name="Log")).not_to_have_text("The log is empty.")


def test_a_faulty_component_shows_in_which_values_it_fails(page, tmp_path):
    create_activity(page, "ir-sensor-faulty", "ir-sensor-faulty", tmp_path)
    write_model(page)
    fill_expected(page)
    build(page)
    page.get_by_text("Cases failed").wait_for()
    page.get_by_role("radiogroup", name="Filter by verdict").get_by_text(re.compile("^Fail")).click()
    page.get_by_role("table", name="Cases").get_by_text("Fail").first.wait_for()
    page.get_by_label("Parameter to filter by").select_option("NumOfSensor")
    page.get_by_label("Value of the parameter").fill("4")
    page.get_by_role("button", name="Filter").press("Enter")
    expect(page.get_by_role("table", name="Cases")).to_have_attribute("aria-rowcount", "3")
    row = page.get_by_role("table", name="Cases").get_by_role("row").last
    expect(row).to_contain_text("Fail")
    page.get_by_role("button", name="Clear").click()
    expect(page.get_by_role("table", name="Cases")).to_have_attribute("aria-rowcount", "7")
    shot(page, "result-faulty-table")
    page.get_by_role("tab", name="Graphs").click()
    page.get_by_text(re.compile("IndexOfSensor: cases fail for")).wait_for()
    page.get_by_role("img", name=re.compile("Of 55 cases")).locator("canvas").wait_for()
    shot(page, "result-faulty-graphs")


def test_an_expected_value_is_edited_in_place_and_undone(page):
    page.get_by_role("link", name="Test cases").first.click()
    cell = page.get_by_label("Expected return of case 2", exact=True)
    before = cell.input_value()
    cell.fill("42")
    cell.press("Enter")
    expect(cell).to_have_value("42.0")
    expect(page.get_by_label("Expected return of case 3", exact=True)).to_be_focused()
    page.get_by_role("button", name="Undo").click()
    expect(cell).to_have_value(before)
    page.get_by_role("tab", name="Combinations").click()
    page.get_by_role("img", name=re.compile("pairs of values of")).locator("canvas").first.wait_for()
    shot(page, "combinations")
    page.get_by_role("tab", name="Test application").click()
    page.get_by_role("textbox", name=re.compile("ConcreteTestDriver")).wait_for()
    shot(page, "test-application")


def test_a_fixed_component_is_compared_with_the_faulty_one(page):
    """The file is fixed in the portal, built again and compared with the previous build."""
    suite = page.url
    page.get_by_role("link", name="ir-sensor-faulty").click()
    page.get_by_role("tab", name="Files").click()
    page.get_by_role("button", name=re.compile(r"InfraredSensor\.java")).click()
    text = page.get_by_role("textbox", name=re.compile(r"^Text of component.*InfraredSensor"))
    text.wait_for()
    source = (ROOT / "examples/ir-sensor/component/org/sitaf/examples/ir/InfraredSensor.java").read_text()
    text.fill(source)
    page.get_by_role("button", name="Save").click()
    expect(page.get_by_text("(unsaved changes)")).to_have_count(0)
    page.goto(suite)
    build(page)
    page.get_by_text("All passed").wait_for()
    page.get_by_role("tab", name="History").click()
    results = page.get_by_role("table", name="Results")
    expect(results.get_by_role("checkbox")).to_have_count(2)
    for box in results.get_by_role("checkbox").all():
        box.check()
    shot(page, "history")
    page.get_by_role("link", name="Compare selected results").click()
    page.get_by_role("heading", name="Fixed: 5").wait_for()
    page.get_by_role("heading", name="Newly failing: 0").wait_for()
    expect(page.get_by_role("table", name="Fixed").get_by_role("row")).to_have_count(6)
    page.get_by_role("heading", name="Differences: 5").wait_for()
    page.get_by_role("button", name=re.compile("^Show cases")).last.click()
    cases = page.get_by_role("table", name="Cases of the group")
    cases.wait_for()
    shot(page, "comparison")
    cases.get_by_role("button", name=re.compile("^Replays of case")).first.click()
    both = page.get_by_role("group", name="Both replays")
    both.get_by_role("status").filter(has_text="diverge").wait_for()
    expect(both.get_by_role("application", name=re.compile("^3D replay of case"))).to_have_count(2)


def test_a_result_is_downloaded_in_four_formats(page):
    page.get_by_role("link", name=re.compile("^GetInfraredData, ")).first.click()
    for name, beginning in (
        ("Result XML", b"<?xml"),
        ("JUnit XML", b"<?xml"),
        ("CSV", b"no,"),
        ("HTML report", b"<!doctype html>"),
    ):
        with page.expect_download() as download:
            page.get_by_role("link", name=name).click()
        content = download.value.path().read_bytes()
        assert content.lower().startswith(beginning), name
        assert content.count(b"\n") > 0


def test_the_home_page_shows_builds_agents_and_failures(page):
    page.get_by_role("link", name="SITAF").click()
    builds = page.get_by_role("table", name="Builds")
    expect(builds).to_contain_text("50 of 55 passed, 5 failed")
    # Only the latest build counts.
    expect(page.get_by_role("region", name="Failing activities")).to_contain_text("None")
    expect(page.get_by_role("table", name="Agents")).to_contain_text("Online")
    shot(page, "home")


def test_failed_cases_and_a_single_one_are_run_again(page):
    """The component is fixed by now."""
    builds = page.get_by_role("table", name="Builds")
    builds.get_by_role("row").filter(has_text="50 of 55 passed, 5 failed").get_by_role("link").first.click()
    page.get_by_role("button", name="Run failed cases again").click()
    page.get_by_text(re.compile(r"^Only cases \d+(, \d+){4}\.")).wait_for()
    page.get_by_text("All passed").wait_for()
    expect(page.get_by_role("button", name="Run failed cases again")).to_have_count(0)
    shot(page, "failed-again")
    page.get_by_role("table", name="Cases").get_by_role("button", name=re.compile(r"^Case \d+$")).first.click()
    page.get_by_role("button", name=re.compile(r"^Run case \d+ again$")).click()
    page.get_by_text(re.compile(r"^Only case \d+\.")).wait_for()
    page.get_by_text("All passed").wait_for()
