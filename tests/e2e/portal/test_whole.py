"""Checks of every page; they run last, when all pages have content."""

import re

import pytest

from portal.browsing import home_of, serious, shot

SIZES = [(1440, 900), (1024, 768), (390, 844)]
# Texts that do not fit into an element that shows no more; those for screen readers alone are one pixel wide.
CUT = """() => [...document.querySelectorAll("body *")].filter((element) => {
  const hides = ["hidden", "clip"].includes(getComputedStyle(element).overflowX);
  const text = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim());
  return hides && text && element.clientWidth > 1 && element.scrollWidth > element.clientWidth + 1;
}).map((element) => element.textContent.trim().slice(0, 100))"""


def places(page):
    """The address of every page with content, and its heading."""
    home = home_of(page)
    page.goto(home + "/builds")
    link = page.get_by_role("link", name=re.compile("^ir-sensor .*GetInfraredData$")).first
    build_page = home + link.get_attribute("href")
    build = page.request.get(build_page.replace("/builds/", "/api/v1/builds/")).json()
    activity = f"{home}/activities/{build['activityId']}"
    model = "GetInfraredData"
    return {
        home: "Interface tests",
        home + "/activities": "Activities",
        home + "/activities/new": "New test activity",
        activity: build["activityName"],
        activity + "?tab=tests": build["activityName"],
        f"{activity}/models/{model}": model,
        f"{home}/suites/{build['suiteId']}": None,
        home + "/builds": "Builds",
        home + "/schedules": "Schedules",
        home + "/schedules/new": "New schedule",
        home + "/agents": "Agents",
        home + "/settings": "Settings",
        build_page: model,
        build_page + "?tab=graphs": model,
        build_page + "?tab=coverage": model,
        build_page + "?case=2": model,
        build_page + "?tab=log": model,
        build_page + "?tab=history": model,
        build_page + "/cases/2": None,
    }


def open_page(page, place, title):
    page.goto(place)
    heading = {"name": title} if title else {}
    page.get_by_role("heading", level=1, **heading).first.wait_for()
    page.wait_for_load_state("networkidle") if "log" in place else page.wait_for_timeout(500)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_every_page_is_accessible_and_fits_each_size(page, scheme):
    page.emulate_media(color_scheme=scheme)
    try:
        for number, (place, title) in enumerate(places(page).items()):
            open_page(page, place, title)
            assert serious(page) == [], place
            for width, height in SIZES:
                page.set_viewport_size({"width": width, "height": height})
                page.wait_for_timeout(100)
                assert page.evaluate("document.documentElement.scrollWidth") <= width, f"{place} at {width}"
                assert page.evaluate(CUT) == [], f"{place} at {width}"
                shot(page, f"page-{number:02}-{width}-{scheme}")
            page.set_viewport_size({"width": 1280, "height": 900})
    finally:
        page.set_viewport_size({"width": 1280, "height": 900})


def test_the_browser_reported_no_errors(page):
    assert page.complaints == []
