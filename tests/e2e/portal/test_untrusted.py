"""Untrusted text is shown as text, a lost connection is restored, and no change is overwritten."""

import re

from portal.browsing import Proxy, drop, expect, home_of, zipped

MARKUP = "<img src=x onerror=alert(1)>"
COMPONENT = """
package demo;

public class Adder {
  public int Add(int a, int b) {
    System.out.println("<script>alert(2)</script> \\u001b[31mred \\u202Eevil " + "x".repeat(20000));
    if (a == 2) {
      throw new IllegalStateException("<img src=x onerror=alert(3)> \\u001b[2J\\u202Eevil" + "y".repeat(20000));
    }
    return a + b;
  }
}
"""
SERVICE = """<service_port_type_profile><service_port_type><type_name>AdderService</type_name>
<method name="Add" return_type="int" call_type="blocking">
<param index="1"><type>int</type><name>a</name></param><param index="2"><type>int</type><name>b</name></param>
</method></service_port_type></service_port_type_profile>
"""
MODEL = """<test_model><name>Add</name><target interface="AdderService" method="Add"/><input_spec_list>
<test_element abstract_type="NUMERIC" real_type="int"><name>a</name><type>TDI</type>
<user_value_list><value>1</value><value>2</value></user_value_list></test_element>
<test_element abstract_type="NUMERIC" real_type="int"><name>b</name><type>TDI</type>
<user_value_list><value>3</value></user_value_list></test_element>
</input_spec_list><output_spec_list><test_element abstract_type="NUMERIC" real_type="int"><name>return</name>
<type>RETURN</type><expected>a + b</expected></test_element></output_spec_list>
<order_of_combinations>all</order_of_combinations></test_model>
"""

SCHEDULE = """async ([activityId, name]) => {
  const token = /XSRF-TOKEN=([^;]+)/.exec(document.cookie)[1];
  const answer = await fetch("/api/v1/schedules", {
    method: "POST",
    headers: { "Content-Type": "application/json", "X-XSRF-TOKEN": token },
    body: JSON.stringify({ activityId, model: "Add", name, cron: "0 3 * * *" }),
  });
  if (!answer.ok) throw new Error(await answer.text());
}"""


def test_hostile_text_is_shown_as_text(page):
    profile = (
        f"name: hostile\ndescription: '{MARKUP}'\n"
        "component: {language: java, sources: component/, class: demo.Adder}\n"
        "provided: [AdderService.xml]\nmodels: [Add.xml]\n"
    )
    files = {
        "activity.yaml": profile,
        "AdderService.xml": SERVICE,
        "Add.xml": MODEL,
        "component/demo/Adder.java": COMPONENT,
    }
    page.goto(home_of(page) + "/activities")
    drop(page.get_by_role("group", name="Upload an activity"), {"hostile.zip": zipped(files)})
    page.get_by_role("status").get_by_role("link", name="hostile").click()
    page.get_by_text(MARKUP).wait_for()
    # The name of a schedule may be any text.
    page.evaluate(SCHEDULE, [re.search(r"/activities/([^/?]+)", page.url).group(1), MARKUP])
    page.get_by_role("button", name="Build now", exact=True).click()
    page.get_by_text("Cases failed").wait_for()
    table = page.get_by_role("table", name="Cases")
    # The test application escapes what XML cannot represent.
    expect(table).to_contain_text(re.compile(r"<img src=x onerror=alert\(3\)> \\u001[bB]\[2J⟨U\+202E⟩evil"))
    table.get_by_role("button", name="Case 2").click()
    drawer = page.get_by_role("dialog")
    expect(drawer.get_by_role("note")).to_contain_text("<img src=x onerror=alert(3)>")
    log = drawer.get_by_role("region", name="Log of case 2")
    expect(log).to_contain_text("<script>alert(2)</script> ␛[31mred ⟨U+202E⟩evil xxx")
    page.keyboard.press("Escape")
    page.get_by_role("tab", name="Log").click()
    expect(page.get_by_role("log")).to_contain_text("<script>alert(2)</script> ␛[31mred ⟨U+202E⟩evil xxx")
    for place in ("", "/activities", "/schedules"):
        page.goto(home_of(page) + place)
        page.get_by_text(MARKUP).first.wait_for()
        assert page.locator("[onerror]").count() == 0
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), place


def test_a_lost_connection_is_reported_and_restored(page, browser):
    proxy = Proxy(home_of(page))
    context = browser.new_context(storage_state=page.context.storage_state())
    try:
        other = context.new_page()
        other.goto(proxy.address + "/agents")
        agents = other.get_by_role("table", name="Agents")
        expect(agents).to_contain_text("Online")
        proxy.disconnect()
        lost = other.get_by_text("No connection to the server.")
        lost.wait_for()
        expect(agents).to_contain_text("Online")
        proxy.connect()
        lost.wait_for(state="detached")
        other.get_by_role("link", name="Builds", exact=True).click()
        other.get_by_role("table", name="Builds").wait_for()
    finally:
        context.close()
        proxy.disconnect()


def test_two_users_who_edit_one_suite_overwrite_nothing(page):
    page.goto(home_of(page) + "/activities")
    page.get_by_role("link", name="hostile", exact=True).first.click()
    page.get_by_role("table", name="Suites").get_by_role("link").first.click()
    mine = page.get_by_label("Expected return of case 1", exact=True)
    mine.wait_for()
    other = page.context.new_page()
    try:
        other.goto(page.url)
        theirs = other.get_by_label("Expected return of case 1", exact=True)
        theirs.fill("31")
        theirs.press("Enter")
        other.get_by_text("· saved").wait_for()
        mine.fill("32")
        mine.press("Enter")
        page.get_by_role("alert", name="Another user changed this suite").wait_for()
        other.reload()
        expect(theirs).to_have_value("31")
        page.get_by_role("button", name="Apply my changes").click()
        page.get_by_role("alert", name="Another user changed this suite").wait_for(state="detached")
        page.get_by_text("· saved").wait_for()
        expect(mine).to_have_value("32")
        other.reload()
        expect(theirs).to_have_value("32")
    finally:
        other.close()
