"""Checks of every page; they run last, when all pages have content."""

import re

import pytest

from portal.browsing import serious, shot


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious_on_any_page(page, scheme):
    page.emulate_media(color_scheme=scheme)
    page.get_by_role("link", name="SITAF").click()
    page.get_by_role("heading", name="Interface tests").wait_for()
    home = page.url.rstrip("/")
    page.get_by_role("table", name="Agents").wait_for()
    shot(page, f"home-{scheme}")
    # The home page shows the newest builds only.
    page.goto(home + "/builds")
    build_link = page.get_by_role("link", name=re.compile("^ir-sensor .*GetInfraredData$")).first
    build_page = home + build_link.get_attribute("href")
    places = {
        home: "Interface tests",
        home + "/activities": "Activities",
        home + "/activities/new": "New test activity",
        home + "/builds": "Builds",
        home + "/schedules": "Schedules",
        home + "/schedules/new": "New schedule",
        home + "/agents": "Agents",
        home + "/settings": "Settings",
        build_page: "GetInfraredData",
        build_page + "?tab=graphs": "GetInfraredData",
        build_page + "?tab=coverage": "GetInfraredData",
        build_page + "?case=2": "GetInfraredData",
        build_page + "?tab=log": "GetInfraredData",
        build_page + "?tab=history": "GetInfraredData",
    }
    for place, title in places.items():
        page.goto(place)
        page.get_by_role("heading", name=title, level=1).wait_for()
        page.wait_for_load_state("networkidle") if "log" in place else page.wait_for_timeout(500)
        assert serious(page) == [], place


def test_the_browser_reported_no_errors(page):
    assert page.complaints == []
