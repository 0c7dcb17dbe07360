"""The signals of a case under its replay, with a real agent, a real simulation and a real browser."""

import json
import re
from pathlib import Path

import pytest
from snippets import snippet

from portal.browsing import PICTURES, ROOT, actual_of, expect, home_of, serious, shot, zip_of


@pytest.fixture(scope="module")
def page(page, tab_of):
    """A page in the same session whose user prefers reduced motion."""
    with tab_of(reduced_motion="reduce", storage_state=page.context.storage_state()) as tab:
        tab.goto(home_of(page))
        yield tab


@pytest.fixture(scope="module")
def build(page, tmp_path_factory):
    """The address of a finished build in which the base touches the wall."""
    folder = tmp_path_factory.mktemp("activity")
    archive = zip_of(ROOT / "examples" / "touchless-approach-faulty", folder / "touchless.zip")
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_label("Zip file of an activity").set_input_files(archive)
    page.get_by_role("button", name="Build now: touchless-approach-faulty Approach").click()
    page.get_by_role("tab", name="Log").wait_for()
    page.get_by_role("table", name="Cases").get_by_role("button", name="Case 1", exact=True).wait_for()
    page.get_by_role("heading", name="Result", exact=True).wait_for()
    return page.url.split("?")[0]


def seconds(page):
    return float(page.get_by_test_id("clock").inner_text().split()[0])


def plot_of(page):
    plot = page.get_by_role("group", name="Signals over time")
    plot.locator("canvas").first.wait_for()
    page.locator('[data-loaded="true"]').wait_for()
    return plot


def close_up(plot, name):
    if PICTURES:
        plot.screenshot(path=Path(PICTURES) / f"{name}.png", animations="disabled")


def signals(page):
    text = page.get_by_label("Signals at this time").inner_text()
    return dict(re.findall(r"(\S+)\s*\n\s*(\S+)", text))


def test_a_violated_condition_links_to_its_moment(page, build):
    page.get_by_role("table", name="Cases").get_by_role("button", name="Case 1", exact=True).click()
    page.get_by_role("link", name="Show the violation of never touches").click()
    plot = plot_of(page)
    shown = plot.get_by_text(re.compile("is violated at")).inner_text()
    at = float(re.search(r"violated at ([0-9.]+) s, margin -1", shown)[1])
    assert signals(page) == {"bumped": "1"}
    time = page.get_by_role("slider", name="Time in the plot")
    assert float(time.get_attribute("aria-valuenow")) == pytest.approx(at, abs=1e-5)
    # The call begins after 0.2 s of settling.
    assert seconds(page) == pytest.approx(at + 0.2, abs=0.01)
    assert page.get_by_test_id("playhead").bounding_box()["x"] == pytest.approx(
        page.get_by_test_id("moment").bounding_box()["x"], abs=1.5
    )
    # One step before, the bumper is free.
    time.press("ArrowLeft")
    assert signals(page) == {"bumped": "0"}
    close_up(plot, "signals")
    shot(page, "replay", width=1440)


def form_of(value):
    """What of a JSON value does not depend on the case: the keys, and the type of each leaf."""
    if isinstance(value, dict):
        return {key: form_of(child) for key, child in value.items()}
    if isinstance(value, list):
        return [form_of(value[0])]
    return float if isinstance(value, int | float) else type(value)


def test_the_signals_have_the_form_that_is_documented(page, build):
    path = build.replace("/builds/", "/api/v1/builds/")
    found = page.request.get(f"{path}/cases/1/signals").json()
    assert form_of(found) == form_of(json.loads(snippet("trajectory-conditions-3-json")))


def test_a_click_in_the_plot_moves_the_replay(page, build):
    page.goto(f"{build}/cases/1")
    plot_of(page)
    assert seconds(page) == 0
    box = page.get_by_role("slider", name="Time in the plot").bounding_box()
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    whole = float(re.search(r"of ([0-9.]+) s", page.get_by_test_id("clock").inner_text())[1])
    assert seconds(page) == pytest.approx(whole / 2, abs=0.02)
    # The replay moves the playhead.
    page.get_by_role("group", name="Replay").press("End")
    head = page.get_by_test_id("playhead").bounding_box()
    assert head["x"] == pytest.approx(box["x"] + box["width"], abs=3)


def test_readings_of_the_recording_can_be_added(page, build):
    page.goto(f"{build}/cases/1")
    plot = plot_of(page)
    page.get_by_role("combobox", name="Signals").click()
    page.get_by_role("option", name="robot_x", exact=True).click()
    page.keyboard.press("Escape")
    expect(plot.get_by_role("img", name="bumped, robot_x over time")).to_be_visible()
    page.get_by_role("group", name="Replay").press("End")
    actual = actual_of(page, "robot_x")
    assert float(signals(page)["robot_x"]) == pytest.approx(float(actual), abs=1e-4)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_plot_is_accessible_and_fits_a_phone(page, build, scheme):
    page.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    page.set_viewport_size({"width": 360, "height": 740})
    try:
        page.goto(f"{build}/cases/1?condition=stops")
        plot = plot_of(page)
        assert page.evaluate("document.documentElement.scrollWidth") <= 360
        assert serious(page) == []
        close_up(plot, f"signals-phone-{scheme}")
    finally:
        page.set_viewport_size({"width": 1280, "height": 900})
        page.emulate_media(color_scheme="light")


def test_the_browser_reported_no_errors(page):
    assert page.complaints == []
