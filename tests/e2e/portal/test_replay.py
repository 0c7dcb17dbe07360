"""A case seen again in 3D, and a build watched while it runs: real agent, real simulation, real browser."""

import base64
import re
import shutil

import pytest

from portal.browsing import ROOT, expect, home_of, serious, shot, zip_of

# Simulated in a moment, but the cases are to end one by one.
SLOW = "java.util.concurrent.locks.LockSupport.parkNanos(2_000_000_000L);"

# The share of pixels that differ between two pictures.
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
    """A page of its own in the same session, of somebody who asked for calm."""
    with tab_of(reduced_motion="reduce", storage_state=page.context.storage_state()) as tab:
        tab.goto(home_of(page))
        yield tab


@pytest.fixture(scope="module")
def build(page, tmp_path_factory):
    """The address of a build whose cases take two seconds each, just begun."""
    folder = tmp_path_factory.mktemp("activity")
    shutil.copytree(ROOT / "examples" / "wall-approach", folder / "slow")
    source = next(folder.rglob("WallApproach.java"))
    text = source.read_text()
    begin = "  public boolean Approach(double distance) {\n"
    assert begin in text
    source.write_text(text.replace(begin, f"{begin}    {SLOW}\n"))
    # On a machine that is busy with other tests.
    profile = folder / "slow" / "activity.yaml"
    profile.write_text(profile.read_text().replace("case_wall_s: 30", "case_wall_s: 240"))
    archive = zip_of(folder / "slow", folder / "slow.zip")
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_label("Zip of an activity").set_input_files(archive)
    page.get_by_role("button", name="Build now: wall-approach Approach").click()
    page.get_by_role("tab", name="Log").wait_for()
    return page.url.split("?")[0]


def scene(page):
    view = page.get_by_role("application", name=re.compile("^What moved in case"))
    page.locator('[data-loaded="true"]').wait_for()
    return view


def picture(page):
    # Two frames: what was asked for is drawn with the next one.
    page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    return base64.b64encode(scene(page).locator("canvas").screenshot()).decode()


def seconds(page):
    return float(page.get_by_test_id("clock").inner_text().split()[0])


def test_a_running_build_is_watched_case_by_case(page, build):
    page.get_by_role("link", name="Watch it").click()
    page.get_by_role("heading", name="Live").wait_for()
    status = page.get_by_text(re.compile(r"recorded so far"))
    status.wait_for()
    assert "the build has ended" not in status.inner_text()
    scene(page)
    first = page.get_by_text(re.compile(r"^Case \d+; ")).inner_text().split(";")[0]
    # To its end, then comes the newest by then.
    page.get_by_role("group", name="Replay").press("End")
    expect(page.get_by_text(re.compile(r"^Case \d+; "))).not_to_contain_text(f"{first};", timeout=90_000)
    scene(page)
    shot(page, "live")


def test_a_case_is_played_and_the_scene_changes_with_the_time(page, build):
    page.goto(build)
    page.get_by_text("All passed").wait_for()
    page.get_by_role("table", name="Cases").get_by_role("button", name="Case 1", exact=True).click()
    page.get_by_role("link", name="See it in 3D").click()
    page.get_by_role("heading", name="Case 1").wait_for()
    assert page.url == f"{build}/cases/1"
    scene(page)
    page.get_by_text("Result: Pass").wait_for()
    # Whoever asked for calm is not played anything to.
    assert seconds(page) == 0
    player = page.get_by_role("group", name="Replay")
    readings = page.get_by_label("Readings at the time shown")
    at_begin, read_at_begin = picture(page), readings.inner_text()
    assert "robot_x" in read_at_begin
    assert page.evaluate(DIFFERENCE, [at_begin, picture(page)]) == 0
    player.press("End")
    at_end, read_at_end = picture(page), readings.inner_text()
    assert page.evaluate(DIFFERENCE, [at_begin, at_end]) > 0.002
    assert read_at_end != read_at_begin
    # What is read at the end is what was measured.
    measured = page.get_by_text("Measured robot_x").locator("xpath=../..").locator("dd").inner_text()
    read = dict(re.findall(r"(\S+)\s*\n\s*(\S+)", read_at_end))["robot_x"]
    assert float(read) == pytest.approx(float(measured), abs=1e-4)

    player.press("Home")
    assert page.evaluate(DIFFERENCE, [at_begin, picture(page)]) < 0.0005
    player.press(".")
    player.press(".")
    assert seconds(page) == pytest.approx(0.04)
    player.press(",")
    assert seconds(page) == pytest.approx(0.02)
    page.get_by_label("Speed").select_option("4")
    player.press("Space")
    page.wait_for_function("() => parseFloat(document.querySelector('[data-testid=clock]').innerText) > 0.3")
    player.press("Space")
    stopped = seconds(page)
    page.wait_for_timeout(300)
    assert seconds(page) == stopped


def test_the_camera_turns_by_key_and_follows_what_moves(page, build):
    page.goto(f"{build}/cases/1")
    view = scene(page)
    before = picture(page)
    view.press("ArrowLeft")
    view.press("ArrowLeft")
    turned = picture(page)
    assert page.evaluate(DIFFERENCE, [before, turned]) > 0.01
    view.press("r")
    assert page.evaluate(DIFFERENCE, [before, picture(page)]) < 0.0005
    page.get_by_label("Camera follows robot").check()
    page.get_by_role("group", name="Replay").press("End")
    followed = picture(page)
    shot(page, "replay")
    # The walls move past, as the robot stands still before the camera.
    assert page.evaluate(DIFFERENCE, [before, followed]) > 0.01


def test_the_recording_is_a_file_that_any_viewer_reads(page, build):
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
            page.get_by_role("button", name="Build again and record all cases").wait_for()
        else:
            scene(page)
        assert serious(page) == [], place
    if scheme == "dark":
        page.goto(f"{build}/cases/1")
        scene(page)
        shot(page, "replay-dark")


def test_a_browser_without_webgl_shows_the_readings(page, build):
    page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null;")
    page.goto(f"{build}/cases/1")
    page.get_by_text("This browser shows no 3D").wait_for()
    page.get_by_label("Readings at the time shown").wait_for()
    page.get_by_text(re.compile("^Readings over time as a table")).click()
    table = page.get_by_role("table", name="Readings over time")
    expect(table.get_by_role("columnheader", name="robot_x")).to_be_visible()


def test_the_browser_complained_of_nothing(page):
    assert page.complaints == []
