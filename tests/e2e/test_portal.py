"""Section 4 of the paper by mouse and keyboard, in a real browser on the whole system."""

import os
import re
import shutil
import signal
import subprocess
import zipfile
from pathlib import Path

import pytest

playwright = pytest.importorskip("playwright.sync_api", reason="the browser's driver is missing: pip install playwright")

CHROMIUM = shutil.which("chromium")
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="Chromium is missing; './sitaf doctor' says how to get it")

ROOT = Path(__file__).resolve().parents[2]
AXE = ROOT / "webapp" / "node_modules" / "axe-core" / "axe.min.js"
PATIENCE_MS = 120_000
PICTURES = os.environ.get("SITAF_PICTURES")


@pytest.fixture(scope="module")
def link(sitaf, tmp_path_factory):
    """A running system; the link that opens its portal signed in."""
    data = tmp_path_factory.mktemp("portal")
    system = subprocess.Popen(
        [sitaf.root / "sitaf", "up", "--port", "0", "--grpc-port", "0", "--data", data],
        stdout=subprocess.PIPE,
        stdin=subprocess.PIPE,
        text=True,
    )
    try:
        yield next(
            found.group(1)
            for line in system.stdout
            if (found := re.search(r"Open it signed in, once: (http\S+)", line))
        )
    finally:
        system.send_signal(signal.SIGTERM)
        system.wait(timeout=60)


@pytest.fixture(scope="module")
def browser():
    with playwright.sync_playwright() as driver:
        chromium = driver.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield chromium
        chromium.close()


@pytest.fixture(scope="module")
def page(browser, link):
    """A signed-in page; whatever the browser complains of fails the test that ends the module."""
    context = browser.new_context(viewport={"width": 1280, "height": 900}, color_scheme="light")
    context.set_default_timeout(PATIENCE_MS)
    tab = context.new_page()
    tab.complaints = []
    tab.on("pageerror", lambda error: tab.complaints.append(str(error)))
    tab.on(
        "console",
        lambda message: tab.complaints.append(message.text) if "Content Security Policy" in message.text else None,
    )
    tab.goto(link)
    yield tab
    context.close()


def shot(page, name):
    """A picture of the page, where SITAF_PICTURES names a folder for them, such as docs/portal."""
    if PICTURES:
        page.evaluate("scrollTo(0, 0)")
        page.screenshot(path=Path(PICTURES) / f"{name}.png")


def go_on(page):
    """By key: where the button is moves with the findings that come in above it, and a mouse may miss it."""
    page.get_by_role("button", name="Next").press("Enter")


def zip_of(folder, to):
    with zipfile.ZipFile(to, "w") as archive:
        for file in sorted(folder.rglob("*")):
            if file.is_file():
                archive.write(file, file.relative_to(folder))
    return to


def create_activity(page, example, name, tmp_path):
    """The wizard of Fig. 13, to the file tree of Fig. 13(e)."""
    folder = ROOT / "examples" / example
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_role("link", name="New activity").click()
    page.get_by_label("Name of the activity").fill(name)
    page.get_by_label("Properties").fill("Size: 7")
    page.get_by_label("Calls before the one under test").fill("Enable()")
    page.get_by_label("Files: Component profile").set_input_files(folder / "InfraredSensorComp.xml")
    page.get_by_role("list", name=re.compile("^Component profile")).wait_for()
    shot(page, "wizard")
    go_on(page)
    page.get_by_label("Files: Sources of the component").set_input_files(
        zip_of(folder / "component", tmp_path / "component.zip")
    )
    playwright.expect(page.get_by_label("Class of the component")).to_have_value(
        "org.sitaf.examples.ir.InfraredSensor"
    )
    go_on(page)
    page.get_by_label("Files: Interfaces that the component provides").set_input_files(
        folder / "InfraredSensorService.xml"
    )
    page.get_by_role("list", name=re.compile("^Interfaces that the component provides")).wait_for()
    go_on(page)
    page.get_by_label("Files: World of the simulation").set_input_files(
        [folder / "world" / "ir.world.yaml", folder / "world" / "ir.xml"]
    )
    page.get_by_text("Nothing is wrong with it.").wait_for()
    page.get_by_role("button", name="Create the activity").click()
    page.get_by_role("navigation", name="Files of the activity").wait_for()
    page.locator(".cm-content").wait_for()
    shot(page, "files")


def write_model(page):
    """The four steps of Fig. 14, to the 55 cases of Fig. 15."""
    page.get_by_role("tab", name="Tests").click()
    page.get_by_role("link", name="New test model").click()
    page.get_by_label(re.compile(r"double GetInfraredData\(int32 IndexOfSensor")).check()
    go_on(page)
    page.get_by_label("Distance").check()
    go_on(page)
    for parameter, low, high, offset in (
        ("IndexOfSensor", "1", "7", "1"),
        ("NumOfSensor", "1", "7", "1"),
        ("Distance", "0.0", "10.0", "0.5"),
    ):
        part = page.get_by_role("region", name=f"Specification of {parameter}")
        part.get_by_label("From", exact=True).fill(low)
        part.get_by_label("To", exact=True).fill(high)
        part.get_by_label("Offset").fill(offset)
    page.get_by_role("img", name="7 values from -0.5 to 10.5 on a number line").wait_for()
    shot(page, "specification")
    go_on(page)
    page.get_by_text("55 cases: 25 valid, 30 with an invalid value").wait_for()
    shot(page, "combination")
    page.get_by_role("button", name="Generate test cases").click()
    page.get_by_role("table", name="Test cases").wait_for()


def fill_expected(page):
    page.get_by_role("button", name="Fill by formula").click()
    page.get_by_role("textbox", name="Expected value").fill(
        "valid && IndexOfSensor <= NumOfSensor ? Distance : -1.0"
    )
    page.get_by_role("button", name="Fill", exact=True).click()
    page.get_by_role("textbox", name="Expected value").wait_for(state="hidden")
    first = page.get_by_label("Expected return of case 1", exact=True)
    playwright.expect(first).not_to_have_value("")


def build(page):
    page.get_by_role("button", name="Build now").click()
    page.get_by_role("tab", name="Log").wait_for()
    page.get_by_role("tab", name="Table").wait_for()


def test_the_evaluation_of_the_paper_by_mouse_and_keyboard(page, tmp_path):
    create_activity(page, "ir-sensor", "ir-sensor", tmp_path)
    write_model(page)
    fill_expected(page)
    shot(page, "cases")
    build(page)
    page.get_by_role("table", name="Cases").wait_for()
    page.get_by_text("All passed").wait_for()
    playwright.expect(page.get_by_role("table", name="Cases")).to_have_attribute("aria-rowcount", "57")
    playwright.expect(page.get_by_text("without being judged")).to_have_count(0)
    shot(page, "result-table")
    page.get_by_role("tab", name="Graphs").click()
    page.get_by_role("img", name=re.compile("Of 55 cases 55 pass")).locator("canvas").wait_for()
    shot(page, "result-graphs")
    page.get_by_role("tab", name="Log").click()
    playwright.expect(page.get_by_role("log", name="Log")).not_to_have_text("The log is empty.")


def test_a_faulty_component_shows_in_which_values_it_fails(page, tmp_path):
    create_activity(page, "ir-sensor-faulty", "ir-sensor-faulty", tmp_path)
    write_model(page)
    fill_expected(page)
    build(page)
    page.get_by_text("Cases failed").wait_for()
    page.get_by_role("radiogroup", name="Cases shown").get_by_text(re.compile("^Fail")).click()
    page.get_by_role("table", name="Cases").get_by_text("Fail").first.wait_for()
    shot(page, "result-faulty-table")
    page.get_by_role("tab", name="Graphs").click()
    page.get_by_text(re.compile("IndexOfSensor: cases fail in")).wait_for()
    page.get_by_role("img", name=re.compile("Of 55 cases")).locator("canvas").wait_for()
    shot(page, "result-faulty-graphs")


def test_an_expected_value_is_edited_in_place_and_undone(page):
    page.get_by_role("link", name="Test cases").first.click()
    cell = page.get_by_label("Expected return of case 2", exact=True)
    before = cell.input_value()
    cell.fill("42")
    cell.press("Enter")
    playwright.expect(cell).to_have_value("42.0")
    playwright.expect(page.get_by_label("Expected return of case 3", exact=True)).to_be_focused()
    page.get_by_role("button", name="Undo").click()
    playwright.expect(cell).to_have_value(before)
    page.get_by_role("tab", name="Combinations").click()
    page.get_by_role("img", name=re.compile("pairs of values of")).locator("canvas").first.wait_for()
    shot(page, "combinations")
    page.get_by_role("tab", name="Test application").click()
    page.get_by_role("textbox", name=re.compile("ConcreteTestDriver")).wait_for()
    shot(page, "test-application")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious_on_any_page(page, scheme):
    page.emulate_media(color_scheme=scheme)
    page.get_by_role("link", name="SITAF").click()
    page.get_by_role("heading", name="Interface tests").wait_for()
    home = page.url.rstrip("/")
    build_link = page.get_by_role("table", name="Builds").get_by_role("link").first
    build_page = home + build_link.get_attribute("href")
    page.get_by_role("table", name="Agents").wait_for()
    shot(page, f"home-{scheme}")
    places = {
        home: "Interface tests",
        home + "/activities": "Activities",
        home + "/activities/new": "New test activity",
        home + "/builds": "Builds",
        home + "/schedules": "Schedules",
        home + "/agents": "Agents",
        build_page: "GetInfraredData",
        build_page + "?tab=graphs": "GetInfraredData",
        build_page + "?tab=log": "GetInfraredData",
        build_page + "?tab=history": "GetInfraredData",
    }
    for place, title in places.items():
        page.goto(place)
        page.get_by_role("heading", name=title, level=1).wait_for()
        page.wait_for_load_state("networkidle") if "log" in place else page.wait_for_timeout(500)
        page.evaluate(AXE.read_text())
        found = page.evaluate("async () => (await axe.run(document)).violations")
        serious = [
            (v["id"], [n["html"][:200] for n in v["nodes"]]) for v in found if v["impact"] in ("serious", "critical")
        ]
        assert serious == [], place


def test_the_browser_complained_of_nothing(page):
    assert page.complaints == []
