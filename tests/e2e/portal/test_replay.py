"""The 3D replay and the live view, with a real agent, a real simulation and a real browser."""

import base64
import re
import shutil

import pytest

from portal.browsing import ROOT, actual_of, expect, home_of, serious, shot, zip_of

# The cases should end one by one.
SLOW = "java.util.concurrent.locks.LockSupport.parkNanos(2_000_000_000L);"

# The second run of each case begins at another place.
RELATION = """<relation_list>
    <relation name="ends at the same place">
      <change name="StartX">0.5</change><holds>near(after.robot_x, before.robot_x, 0.1)</holds>
    </relation>
  </relation_list>"""

# The share of different pixels in two screenshots.
DIFFERENCE = """async ([one, other]) => {
  const pixels = async (picture) => {
    const bytes = Uint8Array.from(atob(picture), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(image.width, image.height).getContext('2d');
    canvas.drawImage(image, 0, 0);
    return canvas.getImageData(0, 0, image.width, image.height).data;
  };
  const [a, b] = [await pixels(one), await pixels(other)];
  let different = 0;
  for (let i = 0; i < a.length; i += 4) {
    different += Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2]) > 30;
  }
  return different / (a.length / 4);
}"""


@pytest.fixture(scope="module")
def page(page, tab_of):
    """A page in the same session whose user prefers reduced motion."""
    with tab_of(reduced_motion="reduce", storage_state=page.context.storage_state()) as tab:
        tab.goto(home_of(page))
        yield tab


@pytest.fixture(scope="module")
def build(page, tmp_path_factory):
    """The address of a running build whose cases take two seconds each."""
    folder = tmp_path_factory.mktemp("activity")
    shutil.copytree(ROOT / "examples" / "wall-approach", folder / "slow")
    source = next(folder.rglob("WallApproach.java"))
    text = source.read_text()
    begin = "  public boolean Approach(double distance) {\n"
    assert begin in text
    source.write_text(text.replace(begin, f"{begin}    {SLOW}\n"))
    # For slow machines.
    profile = folder / "slow" / "activity.yaml"
    profile.write_text(profile.read_text().replace("case_wall_s: 30", "case_wall_s: 240"))
    archive = zip_of(folder / "slow", folder / "slow.zip")
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_label("Zip file of an activity").set_input_files(archive)
    page.get_by_role("button", name="Build now: wall-approach Approach").click()
    page.get_by_role("tab", name="Log").wait_for()
    return page.url.split("?")[0]


def scene(page):
    view = page.get_by_role("application", name=re.compile("^3D replay of case"))
    page.locator('[data-loaded="true"]').wait_for()
    return view


def picture(page):
    # Two frames, because a change is rendered with the next frame.
    page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    return base64.b64encode(scene(page).locator("canvas").screenshot()).decode()


def seconds(page):
    return float(page.get_by_test_id("clock").inner_text().split()[0])


def test_the_live_view_plays_the_cases_of_a_running_build(page, build):
    page.get_by_role("link", name="Live view").click()
    page.get_by_role("heading", name="Live view").wait_for()
    status = page.get_by_text(re.compile(r"recorded case"))
    status.wait_for()
    assert "The build has ended" not in status.inner_text()
    scene(page)
    first = page.get_by_text(re.compile(r"^Case \d+; ")).inner_text().split(";")[0]
    # At the end of a case, the newest case is played.
    page.get_by_role("group", name="Replay").press("End")
    expect(page.get_by_text(re.compile(r"^Case \d+; "))).not_to_contain_text(f"{first};", timeout=90_000)
    scene(page)
    shot(page, "live")


def test_a_case_is_played(page, build):
    page.goto(build)
    page.get_by_text("All passed").wait_for()
    page.get_by_role("table", name="Cases").get_by_role("button", name="Case 1", exact=True).click()
    page.get_by_role("link", name="3D replay").click()
    page.get_by_role("heading", name="Case 1").wait_for()
    assert page.url == f"{build}/cases/1"
    scene(page)
    page.get_by_text("Result: Pass").wait_for()
    # There is no autoplay with reduced motion.
    assert seconds(page) == 0
    player = page.get_by_role("group", name="Replay")
    readings = page.get_by_label("Current readings")
    at_begin, read_at_begin = picture(page), readings.inner_text()
    assert "robot_x" in read_at_begin
    assert page.evaluate(DIFFERENCE, [at_begin, picture(page)]) == 0
    player.press("End")
    at_end, read_at_end = picture(page), readings.inner_text()
    assert page.evaluate(DIFFERENCE, [at_begin, at_end]) > 0.002
    assert read_at_end != read_at_begin
    # The last reading is the actual value.
    actual = actual_of(page, "robot_x")
    reading = dict(re.findall(r"(\S+)\s*\n\s*(\S+)", read_at_end))["robot_x"]
    assert float(reading) == pytest.approx(float(actual), abs=1e-4)

    player.press("Home")
    assert page.evaluate(DIFFERENCE, [at_begin, picture(page)]) < 0.0005
    player.press(".")
    player.press(".")
    assert seconds(page) == pytest.approx(0.04)
    player.press(",")
    assert seconds(page) == pytest.approx(0.02)
    # Slowly, so that a slow machine is not at the end, where Space begins again.
    page.get_by_label("Speed").select_option("0.25")
    player.press("Space")
    page.wait_for_function("() => parseFloat(document.querySelector('[data-testid=clock]').innerText) > 0.3")
    player.press("Space")
    stopped = seconds(page)
    page.wait_for_timeout(300)
    assert seconds(page) == stopped


def test_the_camera_is_rotated_by_keys_and_follows_the_robot(page, build):
    page.goto(f"{build}/cases/1")
    view = scene(page)
    before = picture(page)
    view.press("ArrowLeft")
    view.press("ArrowLeft")
    turned = picture(page)
    assert page.evaluate(DIFFERENCE, [before, turned]) > 0.01
    view.press("r")
    assert page.evaluate(DIFFERENCE, [before, picture(page)]) < 0.0005
    page.get_by_label("Follow robot").check()
    page.get_by_role("group", name="Replay").press("End")
    followed = picture(page)
    # The camera keeps the robot in the middle while the walls move.
    assert page.evaluate(DIFFERENCE, [before, followed]) > 0.01


def test_a_recording_is_a_binary_gltf_file(page, build):
    address = f"/api/v1/builds/{build.rsplit('/', 1)[1]}/recordings"
    recorded = page.evaluate("async (address) => (await fetch(address)).json()", address)
    numbers = [item["caseNo"] for item in recorded["items"]]
    assert numbers == list(range(1, len(numbers) + 1))
    kind, head, size = page.evaluate(
        """async (address) => {
          const answer = await fetch(address);
          const bytes = new Uint8Array(await answer.arrayBuffer());
          return [answer.headers.get('content-type'), String.fromCharCode(...bytes.slice(0, 4)), bytes.length];
        }""",
        f"{address}/1",
    )
    assert (kind, head, size) == (
        "model/gltf-binary",
        "glTF",
        recorded["items"][0]["size"],
    )


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious(page, build, scheme):
    page.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    for place in (f"{build}/cases/1", f"{build}/live", f"{build}/cases/4711"):
        page.goto(place)
        if "4711" in place:
            page.get_by_role("button", name="Build again, record all cases").wait_for()
        else:
            scene(page)
        assert serious(page) == [], place
    if scheme == "dark":
        page.goto(f"{build}/cases/1")
        scene(page)
        shot(page, "replay-dark")


def test_a_browser_without_webgl_shows_the_readings(page, build, tab_of):
    # A tab of its own, since a script for each page cannot be removed.
    with tab_of(storage_state=page.context.storage_state()) as tab:
        # The plot below the replay needs the other contexts.
        tab.add_init_script("""
            const getContext = HTMLCanvasElement.prototype.getContext;
            HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
              return kind.startsWith('webgl') ? null : getContext.call(this, kind, ...options);
            };""")
        tab.goto(f"{build}/cases/1")
        tab.get_by_text("WebGL is not available").wait_for()
        tab.get_by_label("Current readings").wait_for()
        tab.get_by_text(re.compile("^Table of readings")).click()
        table = tab.get_by_role("table", name="Readings over time")
        expect(table.get_by_role("columnheader", name="robot_x")).to_be_visible()
        assert tab.complaints == []


def test_both_runs_of_a_relation_replay_side_by_side(page, tmp_path):
    shutil.copytree(ROOT / "examples" / "touchless-approach", tmp_path / "related")
    model = tmp_path / "related" / "Approach.xml"
    end = "</trajectory_condition_spec_list>"
    model.write_text(model.read_text().replace(end, f"{end}\n  {RELATION}"))
    page.goto(home_of(page))
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_label("Zip file of an activity").set_input_files(zip_of(tmp_path / "related", tmp_path / "related.zip"))
    page.get_by_role("button", name="Build now: touchless-approach Approach").click()
    page.get_by_role("tab", name="Log").wait_for()
    # The build executes each case twice.
    page.get_by_role("heading", name="Result", exact=True).wait_for(timeout=300_000)
    page.goto(f"{page.url.split('?')[0]}/cases/1")
    page.get_by_role("button", name="Show both runs of “ends at the same place”").click()
    both = page.get_by_role("group", name="Both replays")
    for run in ("First run", "Second run"):
        both.get_by_role("application", name=f"3D replay of case 1, {run}").wait_for()
    # The second run starts at another place.
    expect(both.get_by_role("status").first).to_contain_text("They diverge at 0.000 s")
    shot(page, "relation-replays")
    page.get_by_role("button", name="Hide both runs of “ends at the same place”").click()
    expect(both).to_have_count(0)


def test_the_browser_reported_no_errors(page):
    assert page.complaints == []
