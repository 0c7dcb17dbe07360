"""Analyses of a build in the portal: causes of failures and flaky cases, on a real agent."""

import re
import shutil

import pytest

from portal.browsing import ROOT, expect, home_of, serious, shot, zip_of

FLAKY = """        distance = self._sensors[index_of_sensor - 1].range()
        if index_of_sensor == 4:
            import time

            return distance + time.monotonic_ns() % 1_000_003
"""


# The home page would show them as failing activities to the tests that follow.
DELETE = """async (names) => {
  const token = /XSRF-TOKEN=([^;]+)/.exec(document.cookie)[1];
  const { items } = await (await fetch("/api/v1/activities?size=200")).json();
  for (const { id } of items.filter(({ name }) => names.includes(name))) {
    const answer = await fetch(`/api/v1/activities/${id}`, { method: "DELETE", headers: { "X-XSRF-TOKEN": token } });
    if (!answer.ok) throw new Error(await answer.text());
  }
}"""


@pytest.fixture(scope="module")
def page(page, tab_of):
    """A page in the same session whose user prefers reduced motion; the activities are deleted after the tests."""
    with tab_of(reduced_motion="reduce", storage_state=page.context.storage_state()) as tab:
        tab.goto(home_of(page))
        yield tab
        tab.evaluate(DELETE, ["explained-sensor", "flaky-sensor"])


def copied(example, name, tmp_path):
    """An example under a name that no other test uses."""
    folder = shutil.copytree(ROOT / "examples" / example, tmp_path / name)
    profile = folder / "activity.yaml"
    profile.write_text(re.sub(r"(?m)^name: .*", f"name: {name}", profile.read_text()))
    return folder


def built(page, folder, tmp_path):
    """Uploads an activity, builds it, and waits for its result."""
    name = folder.name
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_label("Zip file of an activity").set_input_files(zip_of(folder, tmp_path / f"{name}.zip"))
    page.get_by_role("button", name=f"Build now: {name} GetInfraredData").click()
    page.get_by_role("tab", name="Log").wait_for()
    page.get_by_role("heading", name="Result", exact=True).wait_for()


def test_a_failure_is_explained_and_its_simplest_case_runs_again_here_and_elsewhere(page, sitaf, tmp_path):
    built(page, copied("ir-sensor-faulty", "explained-sensor", tmp_path), tmp_path)
    page.get_by_role("button", name="Explain", exact=True).click()
    causes = page.get_by_role("region", name="Causes", exact=True)
    # An analysis is about ten builds. If it takes longer, the failure shows its state.
    expect(causes).to_contain_text("further cases were executed", timeout=300_000)
    cause = page.get_by_role("group", name="Cause 1")
    expect(cause).to_contain_text("Fails where IndexOfSensor == NumOfSensor, whatever the rest")
    expect(cause).to_contain_text("FAIL in 5 cases: 1, 7, 13, 19, 25")
    # A relation is drawn over its two inputs.
    cause.get_by_role("img", name="Failing cases over IndexOfSensor and NumOfSensor").wait_for()
    expect(page.get_by_role("group", name="Cause 2")).to_have_count(0)
    further = page.get_by_text(re.compile(r"^\d+ further cases were executed"))
    assert int(further.inner_text().split()[0]) <= 20
    shot(page, "causes")
    assert serious(page) == []

    with page.expect_download() as download:
        cause.get_by_role("link", name="Download bundle").click()
    bundle = tmp_path / "cause.zip"
    download.value.save_as(bundle)
    replay = sitaf("replay", bundle)
    assert replay.returncode == 0, replay.stdout + replay.stderr

    explained = page.url
    cause.get_by_role("button", name="Run again").click()
    page.wait_for_url(lambda url: url != explained)
    page.get_by_role("heading", name="Result", exact=True).wait_for()
    page.get_by_text("Cases failed").wait_for()
    # The title and one case, which is not one of the suite.
    row = page.get_by_role("table", name="Cases").get_by_role("row").last
    expect(row).to_contain_text("56")
    expect(row).to_contain_text("Fail")


def test_flaky_cases_are_found_by_further_runs(page, tmp_path):
    folder = copied("ir-sensor-python", "flaky-sensor", tmp_path)
    (component,) = (folder / "component").glob("*.py")
    source = component.read_text()
    (measured,) = (line for line in source.splitlines(keepends=True) if ".range()" in line)
    component.write_text(source.replace(measured, FLAKY))
    built(page, folder, tmp_path)
    page.get_by_role("tab", name="Flaky cases").click()
    runs = page.get_by_label("Further runs")
    runs.fill("0")
    # A number below the least is corrected when the field is left.
    runs.blur()
    expect(runs).to_have_value("1")
    runs.fill("3")
    page.get_by_role("button", name="Run repeatedly").click()
    table = page.get_by_role("table", name="Flaky cases")
    table.wait_for()
    rows = table.get_by_role("row").filter(has=page.get_by_role("rowheader"))
    assert rows.count() > 0
    for row in rows.all():
        expect(row.get_by_role("img")).to_have_attribute("aria-label", re.compile(r"^(FAIL, ){3}FAIL$"))
        expect(row).to_contain_text("Component")
        expect(row).to_contain_text("its readings are equal, and what it returns differs")
    shot(page, "flaky-cases")
    assert serious(page) == []
    no = rows.first.get_by_role("link").inner_text()
    rows.first.get_by_role("link").click()
    details = page.get_by_role("dialog")
    expect(details).to_contain_text(f"Case {no}")
    # All cases that differ read the fourth sensor.
    expect(details.get_by_role("row", name=re.compile("^IndexOfSensor"))).to_contain_text("4")
