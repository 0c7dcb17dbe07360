"""`./sitaf run --debug --view`: the page shows the scene of the case while the debugger halts the component."""

import re

from portal.browsing import expect, serious, shot


def test_the_scene_follows_the_debugged_case(terminal, tab_of):
    jdb = terminal("run", "examples/wall-approach", "--case", "1", "--debug", "--view")
    address = jdb.expect(r"scene: (http\S+)")[1]
    with tab_of(reduced_motion="reduce") as page:
        page.goto(address)
        expect(page.get_by_role("heading", name="Case 1")).to_be_visible()
        jdb.expect(r"Breakpoint hit: .*WallApproach\.Approach\(\)")
        # Until its next request, the page may show the case as it was before the call.
        page.reload()
        scene = page.get_by_role("application")
        expect(scene).to_have_attribute("data-loaded", "true")
        status = page.get_by_role("status").first
        expect(status).to_contain_text("It stands still while the component is halted.")
        before = passed(status)
        jdb.send("stop in org.sitaf.examples.approach.WallApproach.ahead")
        jdb.expect("Set breakpoint")
        for _ in range(3):
            jdb.send("cont")
            jdb.expect(r"Breakpoint hit: .*WallApproach\.ahead\(\)")
        # The component slept twice for 20 ms.
        expect(status).to_contain_text(f"{before + 0.04:.3f} s")
        shot(page, "debugged-case")
        assert serious(page) == []
        jdb.send("clear org.sitaf.examples.approach.WallApproach.ahead")
        jdb.send("cont")
        jdb.end()
        assert "1 PASS" in jdb.output, jdb.output
        expect(status).to_have_text(re.compile("^The (case|command) has ended"))
        # The page asks until it knows that the command has ended.
        assert [c for c in page.complaints if "ERR_CONNECTION_REFUSED" not in c] == []


def passed(status):
    """The simulation time that the page shows, in seconds."""
    return float(re.search(r"([0-9.]+) s of simulation time", status.inner_text())[1])
