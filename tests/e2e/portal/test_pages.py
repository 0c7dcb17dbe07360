"""The pages around the paper's way: wizard in C++, uploads, schedules, agents, settings."""

import re

from portal.browsing import ROOT, drop, expect, go_on, home_of, shot, zipped

EXAMPLES = ROOT / "examples"


def files_of(folder, *paths):
    return {path.rsplit("/", 1)[-1]: (folder / path).read_bytes() for path in paths}


def test_a_component_in_cpp_goes_through_the_wizard_by_drag_and_drop(page):
    folder = EXAMPLES / "ir-sensor-cpp"
    page.goto(home_of(page) + "/activities/new")
    page.get_by_label("Name of the activity").fill("ir-sensor-cpp")
    page.get_by_label("Language of the component").select_option("cpp")
    page.get_by_label("Properties").fill("Size: 7")
    page.get_by_label("Calls before the one under test").fill("Enable()")
    drop(page.get_by_role("group", name="Component profile"), files_of(folder, "InfraredSensorComp.xml"))
    page.get_by_role("list", name=re.compile("^Component profile: 1 file")).wait_for()
    go_on(page)
    drop(
        page.get_by_role("group", name="Sources of the component"),
        files_of(folder, "component/infrared_sensor.cpp", "component/infrared_sensor.hpp"),
    )
    page.get_by_role("list", name=re.compile("^Sources of the component: 2 files")).wait_for()
    page.get_by_label("Class of the component").fill("sitaf::examples::InfraredSensor")
    go_on(page)
    drop(
        page.get_by_role("group", name="Interfaces that the component provides"),
        files_of(folder, "InfraredSensorService.xml"),
    )
    page.get_by_role("list", name=re.compile("^Interfaces that the component provides")).wait_for()
    go_on(page)
    expect(page.get_by_label("Type of the skeleton code")).to_have_value("cpp")
    drop(
        page.get_by_role("group", name="World of the simulation"),
        files_of(folder, "world/ir.world.yaml", "world/ir.xml"),
    )
    page.get_by_text("Nothing is wrong with it.").wait_for()
    page.get_by_role("button", name="Create the activity").click()
    files = page.get_by_role("navigation", name="Files of the activity")
    files.get_by_text("infrared_sensor.hpp").wait_for()
    page.get_by_role("tab", name="Interface").click()
    page.get_by_text("GetInfraredData").first.wait_for()
    shot(page, "interface")


def test_a_zip_is_dropped_and_a_bad_one_says_where_it_is_bad(page):
    page.goto(home_of(page) + "/activities")
    zone = page.get_by_role("group", name="Upload an activity")
    profile = (EXAMPLES / "ir-sensor" / "activity.yaml").read_text()
    drop(zone, {"bad.zip": zipped({"activity.yaml": profile.replace("language: java", "language: cobol")})})
    problem = page.get_by_role("alert", name="bad.zip was not taken")
    expect(problem).to_contain_text("activity.yaml:")
    expect(problem).to_contain_text("cobol")
    folder = EXAMPLES / "ir-sensor"
    good = {str(f.relative_to(folder)): f.read_text() for f in folder.rglob("*") if f.is_file()}
    good["activity.yaml"] = profile.replace("name: ir-sensor", "name: dropped")
    drop(zone, {"good.zip": zipped(good)})
    page.get_by_role("status").get_by_role("link", name="dropped").click()
    page.get_by_role("heading", name="dropped", level=1).wait_for()


def test_a_schedule_is_made_with_its_next_ten_times_paused_resumed_and_run(page):
    page.goto(home_of(page) + "/schedules")
    page.get_by_label("Name of a calendar").fill("weekend")
    page.get_by_label("Saturday").check()
    page.get_by_label("Sunday").check()
    page.get_by_role("button", name="Keep the calendar").click()
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
    told = " ".join(times.all_inner_texts())
    assert "Monday" in told
    assert "Sunday" not in told
    assert "Saturday" not in told
    page.get_by_role("button", name="Agent, priority, recordings").click()
    page.get_by_role("textbox", name="Priority").fill("7")
    page.get_by_label("Recordings to see in 3D").select_option(label="cases that fail or end in an error")
    page.keyboard.press("Escape")
    page.get_by_role("button", name="With priority 7, failing cases recorded").wait_for()
    shot(page, "new-schedule")
    page.get_by_role("textbox", name="Cron expression").fill("whenever")
    page.get_by_role("alert", name="No such times").get_by_text("is no cron expression").wait_for()
    page.get_by_role("textbox", name="Cron expression").fill("30 3 * * *")
    expect(times).to_have_count(10)
    page.get_by_role("button", name="Schedule", exact=True).click()
    page.get_by_role("heading", name="nightly", level=1).wait_for()
    expect(times).to_have_count(10)
    expect(page.get_by_role("table", name="Facts")).to_contain_text("cases that fail or end in an error")
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
    page.get_by_role("button", name="Give up: nightly").click()
    expect(page.get_by_role("link", name="nightly")).to_have_count(0)


def test_a_build_that_no_agent_can_do_says_why_it_waits(page):
    page.goto(home_of(page) + "/activities")
    page.get_by_role("link", name="dropped").click()
    page.get_by_role("button", name="Agent, priority, recordings").click()
    page.get_by_role("combobox", name="Labels that the agent must have").fill("real-hardware")
    page.keyboard.press("Enter")
    page.keyboard.press("Escape")
    page.get_by_role("button", name="Build now", exact=True).click()
    page.get_by_text("no agent offers the label real-hardware").wait_for()
    page.get_by_text("the label real-hardware", exact=False).first.wait_for()
    page.get_by_role("button", name="Cancel").click()
    page.get_by_text("Cancelled").wait_for()


def test_an_agent_is_drained_and_active_again_and_another_one_may_come(page):
    page.goto(home_of(page) + "/agents")
    agents = page.get_by_role("table", name="Agents")
    expect(agents).to_contain_text("java")
    expect(agents).to_contain_text("simulation")
    page.get_by_role("button", name=re.compile("^Drain ")).click()
    agents.get_by_text("draining: takes no new builds").wait_for()
    page.get_by_role("button", name=re.compile("^Activate ")).click()
    page.get_by_role("button", name=re.compile("^Drain ")).wait_for()
    page.get_by_label("Name of the agent").fill("bench-2")
    page.get_by_role("button", name="Make a token").click()
    page.get_by_text("SITAF_ENROLMENT_TOKEN=sitaf-enrol").wait_for()
    expect(page.get_by_role("table", name="Enrolments")).to_contain_text("bench-2")
    shot(page, "agents")
    page.get_by_role("button", name=re.compile("^Delete the token for bench-2")).click()
    expect(page.get_by_role("table", name="Enrolments").get_by_text("bench-2")).to_have_count(0)


def test_an_administrator_makes_a_token_and_a_user_who_can_only_look(page, browser):
    page.goto(home_of(page) + "/settings")
    page.get_by_label("Name of a new token").fill("ci")
    page.get_by_role("button", name="Make", exact=True).click()
    expect(page.get_by_role("status").filter(has_text="Token ci").locator("pre")).not_to_be_empty()
    page.get_by_role("button", name="Revoke ci").click()
    expect(page.get_by_role("button", name="Revoke ci")).to_have_count(0)
    page.get_by_label("Name of a new user").fill("visitor")
    page.get_by_role("region", name="Users").get_by_label("Role", exact=True).select_option("VIEWER")
    page.get_by_role("button", name="Add").click()
    password = page.get_by_role("status").filter(has_text="Password of visitor").locator("pre").inner_text()
    shot(page, "settings")
    other = browser.new_context()
    try:
        visitor = other.new_page()
        visitor.goto(home_of(page) + "/agents")
        visitor.get_by_role("textbox", name="Name").fill("visitor")
        visitor.get_by_role("textbox", name="Password").fill(password)
        visitor.get_by_role("button", name="Sign in").click()
        visitor.get_by_role("table", name="Agents").wait_for()
        expect(visitor.get_by_role("button", name=re.compile("^Drain "))).to_have_count(0)
        expect(visitor.get_by_text("Let an agent in")).to_have_count(0)
    finally:
        other.close()
