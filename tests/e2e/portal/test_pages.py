"""The wizard with C++, uploads, schedules, agents and settings."""

import re

from portal.browsing import ROOT, drop, expect, home_of, next_step, shot, zipped

EXAMPLES = ROOT / "examples"


def files_of(folder, *paths):
    return {path.rsplit("/", 1)[-1]: (folder / path).read_bytes() for path in paths}


def test_a_component_in_cpp_goes_through_the_wizard_by_drag_and_drop(page):
    folder = EXAMPLES / "ir-sensor-cpp"
    page.goto(home_of(page) + "/activities/new")
    page.get_by_role("radio", name="Files that I have").check()
    page.get_by_label("Name of the activity").fill("ir-sensor-cpp")
    page.get_by_label("Language of the component").select_option("cpp")
    page.get_by_label("Properties").fill("Size: 7")
    page.get_by_label("Calls before the method under test").fill("Enable()")
    drop(page.get_by_role("group", name="Component profile"), files_of(folder, "InfraredSensorComp.xml"))
    page.get_by_role("list", name=re.compile("^Component profile: 1 file")).wait_for()
    next_step(page)
    drop(
        page.get_by_role("group", name="Sources of the component"),
        files_of(folder, "component/infrared_sensor.cpp", "component/infrared_sensor.hpp"),
    )
    page.get_by_role("list", name=re.compile("^Sources of the component: 2 files")).wait_for()
    page.get_by_label("Component class").fill("sitaf::examples::InfraredSensor")
    next_step(page)
    drop(
        page.get_by_role("group", name="Provided interfaces"),
        files_of(folder, "InfraredSensorService.xml"),
    )
    page.get_by_role("list", name=re.compile("^Provided interfaces")).wait_for()
    next_step(page)
    expect(page.get_by_label("Language of the test application")).to_have_value("cpp")
    drop(
        page.get_by_role("group", name="Simulation world"),
        files_of(folder, "world/ir.world.yaml", "world/ir.xml"),
    )
    page.get_by_text("No problems.").wait_for()
    page.get_by_role("button", name="Create activity").click()
    files = page.get_by_role("navigation", name="Files of the activity")
    files.get_by_text("infrared_sensor.hpp").wait_for()
    page.get_by_role("tab", name="Interface").click()
    page.get_by_text("GetInfraredData").first.wait_for()
    shot(page, "interface")


def test_a_zip_file_is_uploaded_and_a_bad_one_is_refused(page):
    page.goto(home_of(page) + "/activities")
    zone = page.get_by_role("group", name="Upload an activity")
    profile = (EXAMPLES / "ir-sensor" / "activity.yaml").read_text()
    drop(zone, {"bad.zip": zipped({"activity.yaml": profile.replace("language: java", "language: cobol")})})
    problem = page.get_by_role("alert", name="bad.zip was not uploaded")
    expect(problem).to_contain_text("activity.yaml:")
    expect(problem).to_contain_text("cobol")
    folder = EXAMPLES / "ir-sensor"
    good = {str(f.relative_to(folder)): f.read_text() for f in folder.rglob("*") if f.is_file()}
    good["activity.yaml"] = profile.replace("name: ir-sensor", "name: dropped")
    drop(zone, {"good.zip": zipped(good)})
    page.get_by_role("status").get_by_role("link", name="dropped").click()
    page.get_by_role("heading", name="dropped", level=1).wait_for()


def test_an_activity_gets_tags_and_is_found_by_them(page):
    page.goto(home_of(page) + "/activities")
    folder = EXAMPLES / "gripper"
    files = {str(f.relative_to(folder)): f.read_text() for f in folder.rglob("*") if f.is_file()}
    drop(page.get_by_role("group", name="Upload an activity"), {"gripper.zip": zipped(files)})
    page.get_by_role("status").get_by_role("link", name="gripper").click()
    page.get_by_role("button", name="Add tags").click()
    tags = page.get_by_role("combobox", name="Tags")
    for tag in ("arm/hand", "nightly"):
        tags.fill(tag)
        tags.press("Enter")
    page.get_by_role("button", name="Save tags").click()
    page.get_by_role("link", name="#nightly").click()
    page.wait_for_url("**/activities?tag=nightly")
    rows = page.get_by_role("table", name="Activities").locator("tbody tr")
    expect(rows).to_have_count(1)
    expect(rows).to_contain_text("gripper")
    page.get_by_role("combobox", name="Tag").select_option("arm/hand")
    page.wait_for_url("**/activities?tag=arm%2Fhand")
    expect(rows).to_contain_text("gripper")


def test_files_are_added_to_an_activity_and_deleted(page):
    page.goto(home_of(page) + "/activities")
    folder = EXAMPLES / "gripper"
    files = {str(f.relative_to(folder)): f.read_text() for f in folder.rglob("*") if f.is_file()}
    files["activity.yaml"] = files["activity.yaml"].replace("name: gripper", "name: extended")
    drop(page.get_by_role("group", name="Upload an activity"), {"extended.zip": zipped(files)})
    page.get_by_role("status").get_by_role("link", name="extended").click()
    page.get_by_role("tab", name="Files").click()
    page.get_by_label("Folder of added files").fill("notes/2026")
    page.get_by_label("Files to add").set_input_files(
        [
            {"name": "limits.md", "mimeType": "text/markdown", "buffer": b"# Limits of the gripper"},
            {"name": "photo.png", "mimeType": "image/png", "buffer": bytes(range(256))},
        ]
    )
    listed = page.get_by_role("navigation", name="Files of the activity")
    listed.get_by_text("notes/2026/photo.png").wait_for()
    page.get_by_text("# Limits of the gripper").wait_for()
    page.get_by_role("button", name="Delete notes/2026/limits.md").click()
    page.get_by_role("button", name="Confirm: Delete notes/2026/limits.md").click()
    expect(listed.get_by_text("notes/2026/limits.md")).to_have_count(0)
    expect(listed.get_by_text("notes/2026/photo.png")).to_have_count(1)


def test_a_schedule_is_created_paused_resumed_and_run(page):
    page.goto(home_of(page) + "/schedules")
    page.get_by_label("Calendar name").fill("weekend")
    page.get_by_label("Saturday").check()
    page.get_by_label("Sunday").check()
    page.get_by_role("button", name="Save calendar").click()
    page.get_by_role("table", name="Calendars").get_by_text("Saturday, Sunday").wait_for()
    shot(page, "schedules")
    page.get_by_role("link", name="New schedule").click()
    page.get_by_label("Activity").select_option(label="dropped")
    page.get_by_label("Name", exact=True).fill("nightly")
    page.get_by_role("textbox", name="Cron expression").fill("30 3 * * *")
    page.get_by_label("Time zone").select_option("Asia/Seoul")
    page.get_by_label("weekend").check()
    times = page.get_by_role("list", name="Next times").get_by_role("listitem")
    expect(times).to_have_count(10)
    expect(times.first).to_contain_text("at 03:30")
    # The times of the cron expression alone stay until those without the calendar have come.
    listed = page.get_by_role("list", name="Next times")
    expect(listed).not_to_contain_text("Sunday")
    expect(listed).to_contain_text("Monday")
    expect(listed).not_to_contain_text("Saturday")
    page.get_by_role("button", name="Build options").click()
    page.get_by_role("textbox", name="Priority").fill("7")
    page.get_by_label("3D recordings").select_option(label="failed cases and errors")
    page.keyboard.press("Escape")
    page.get_by_role("button", name="Options: priority 7, failing cases recorded").wait_for()
    shot(page, "new-schedule")
    page.get_by_role("textbox", name="Cron expression").fill("whenever")
    page.get_by_role("alert", name="Invalid time").get_by_text("is not a cron expression").wait_for()
    page.get_by_role("textbox", name="Cron expression").fill("30 3 * * *")
    expect(times).to_have_count(10)
    page.get_by_role("button", name="Create schedule", exact=True).click()
    page.get_by_role("heading", name="nightly", level=1).wait_for()
    expect(times).to_have_count(10)
    expect(page.get_by_role("table", name="Details")).to_contain_text("failed cases and errors")
    page.get_by_role("button", name="Pause: nightly").click()
    page.get_by_role("heading", name="Paused").wait_for()
    page.get_by_role("button", name="Resume: nightly").click()
    page.get_by_role("heading", name="Waiting").wait_for()
    page.get_by_role("button", name="Run now: nightly").click()
    build = page.get_by_role("table", name="History").get_by_role("link")
    build.wait_for()
    shot(page, "schedule")
    build.click()
    page.get_by_role("heading", name="GetInfraredData", level=1).wait_for()
    page.get_by_text("Cases failed").or_(page.get_by_text("All passed")).wait_for()
    page.get_by_role("link", name="Schedules").click()
    page.get_by_role("button", name="Delete: nightly").click()
    expect(page.get_by_role("link", name="nightly")).to_have_count(0)


def test_a_build_without_a_suitable_agent_shows_why_it_waits(page):
    page.goto(home_of(page) + "/activities")
    page.get_by_role("link", name="dropped").click()
    page.get_by_role("button", name="Build options").click()
    page.get_by_role("combobox", name="Agent labels").fill("real-hardware")
    page.keyboard.press("Enter")
    page.keyboard.press("Escape")
    page.get_by_role("button", name="Build now", exact=True).click()
    page.get_by_text("no agent offers the label real-hardware").wait_for()
    page.get_by_text("the label real-hardware", exact=False).first.wait_for()
    page.get_by_role("button", name="Cancel").click()
    page.get_by_text("Cancelled").wait_for()


def test_an_agent_is_drained_and_activated_and_another_one_enrolled(page):
    page.goto(home_of(page) + "/agents")
    agents = page.get_by_role("table", name="Agents")
    expect(agents).to_contain_text("java")
    expect(agents).to_contain_text("simulation")
    page.get_by_role("button", name=re.compile("^Drain ")).click()
    agents.get_by_text("draining: accepts no new builds").wait_for()
    page.get_by_role("button", name=re.compile("^Activate ")).click()
    page.get_by_role("button", name=re.compile("^Drain ")).wait_for()
    page.get_by_label("Agent name").fill("bench-2")
    page.get_by_role("button", name="Create token").click()
    page.get_by_text("SITAF_ENROLMENT_TOKEN=sitaf-enrol").wait_for()
    expect(page.get_by_role("table", name="Enrolments")).to_contain_text("bench-2")
    shot(page, "agents")
    page.get_by_role("button", name=re.compile("^Delete the token for bench-2")).click()
    expect(page.get_by_role("table", name="Enrolments").get_by_text("bench-2")).to_have_count(0)


def test_an_administrator_creates_a_token_and_a_viewer(page, browser):
    page.goto(home_of(page) + "/settings")
    page.get_by_label("Token name").fill("ci")
    page.get_by_role("button", name="Create token", exact=True).click()
    expect(page.get_by_role("status").filter(has_text="Token ci").locator("pre")).not_to_be_empty()
    page.get_by_role("button", name="Revoke ci").click()
    expect(page.get_by_role("button", name="Revoke ci")).to_have_count(0)
    page.get_by_label("User name").fill("visitor")
    page.get_by_role("region", name="Users").get_by_label("Role", exact=True).select_option("VIEWER")
    page.get_by_role("button", name="Add user").click()
    password = page.get_by_role("status").filter(has_text="Password of visitor").locator("pre").inner_text()
    shot(page, "settings")
    other = browser.new_context()
    try:
        visitor = other.new_page()
        visitor.goto(home_of(page) + "/agents")
        visitor.get_by_role("textbox", name="User name").fill("visitor")
        visitor.get_by_role("textbox", name="Password").fill(password)
        visitor.get_by_role("button", name="Sign in").click()
        visitor.get_by_role("table", name="Agents").wait_for()
        expect(visitor.get_by_role("button", name=re.compile("^Drain "))).to_have_count(0)
        expect(visitor.get_by_text("Enroll an agent")).to_have_count(0)
    finally:
        other.close()


def test_scripts_are_sent_as_the_build_compressed_them(page):
    found = []
    page.on("response", lambda response: found.append(response))
    page.goto(home_of(page))
    page.get_by_role("heading", name="Interface tests").wait_for()
    scripts = [response for response in found if response.url.endswith(".js")]
    assert scripts
    assert {response.all_headers().get("content-encoding") for response in scripts} == {"br"}
    # Others get the same content.
    same = page.request.get(scripts[0].url, headers={"Accept-Encoding": "identity"})
    assert "content-encoding" not in same.headers
    assert same.body() == scripts[0].body()
