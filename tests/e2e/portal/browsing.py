"""Steps of users in the portal, for the browser tests."""

import base64
import io
import os
import re
import socket
import threading
import zipfile
from contextlib import suppress
from pathlib import Path

import pytest

expect = pytest.importorskip(
    "playwright.sync_api", reason="the browser's driver is missing: pip install playwright"
).expect
# For slow machines; a passing test does not wait this long.
expect.set_options(timeout=30_000)

ROOT = Path(__file__).resolve().parents[3]
AXE = ROOT / "webapp" / "node_modules" / "axe-core" / "axe.min.js"
PICTURES = os.environ.get("SITAF_PICTURES")


def shot(page, name, **size):
    """Takes a screenshot, of a window with another size, if SITAF_PICTURES names a folder, such as docs/portal."""
    if PICTURES:
        before = page.viewport_size
        page.set_viewport_size({**before, **size})
        page.evaluate("scrollTo(0, 0)")
        page.screenshot(path=Path(PICTURES) / f"{name}.png", animations="disabled")
        page.set_viewport_size(before)


def next_step(page):
    """Uses the keyboard, because the button moves when problems are shown above it."""
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
    page.get_by_role("radio", name="Files that I have").check()
    page.get_by_label("Name of the activity").fill(name)
    page.get_by_label("Properties").fill("Size: 7")
    page.get_by_label("Calls before the method under test").fill("Enable()")
    page.get_by_label("Files: Component profile").set_input_files(folder / "InfraredSensorComp.xml")
    page.get_by_role("list", name=re.compile("^Component profile")).wait_for()
    shot(page, "wizard")
    next_step(page)
    page.get_by_label("Files: Sources of the component").set_input_files(
        zip_of(folder / "component", tmp_path / "component.zip")
    )
    expect(page.get_by_label("Component class")).to_have_value("org.sitaf.examples.ir.InfraredSensor")
    next_step(page)
    page.get_by_label("Files: Provided interfaces").set_input_files(folder / "InfraredSensorService.xml")
    page.get_by_role("list", name=re.compile("^Provided interfaces")).wait_for()
    next_step(page)
    page.get_by_label("Files: Simulation world").set_input_files(
        [folder / "world" / "ir.world.yaml", folder / "world" / "ir.xml"]
    )
    page.get_by_text("No problems.").wait_for()
    page.get_by_role("button", name="Create activity").click()
    page.get_by_role("navigation", name="Files of the activity").wait_for()
    page.locator(".cm-content").wait_for()
    shot(page, "files")


def write_model(page):
    """The four steps of Fig. 14, to the 55 cases of Fig. 15."""
    page.get_by_role("tab", name="Tests").click()
    page.get_by_role("link", name="New test model").click()
    page.get_by_label(re.compile(r"double GetInfraredData\(int32 IndexOfSensor")).check()
    next_step(page)
    page.get_by_label("Distance").check()
    next_step(page)
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
    shot(page, "model-editor", height=1800)
    next_step(page)
    page.get_by_text("55 cases: 25 valid, 30 with an invalid value").wait_for()
    shot(page, "combination")
    page.get_by_role("button", name="Generate test cases").click()
    page.get_by_role("table", name="Test cases").wait_for()


def fill_expected(page):
    page.get_by_role("button", name="Fill with formula").click()
    page.get_by_role("textbox", name="Expected value").fill("valid && IndexOfSensor <= NumOfSensor ? Distance : -1.0")
    page.get_by_role("button", name="Fill", exact=True).click()
    page.get_by_role("textbox", name="Expected value").wait_for(state="hidden")
    first = page.get_by_label("Expected return of case 1", exact=True)
    expect(first).not_to_have_value("")


def build(page):
    page.get_by_role("button", name="Build now").click()
    page.get_by_role("tab", name="Log").wait_for()
    page.get_by_role("tab", name="Table").wait_for()


def actual_of(page, output):
    """The actual value of an output on the page of a case."""
    values = page.get_by_role("table", name=re.compile("^Values of case"))
    return values.get_by_role("row", name=re.compile(f"^{output}")).get_by_role("cell").nth(1).inner_text()


def drop(zone, files):
    """Drops files on a zone. `files` maps names to bytes."""
    given = [{"name": name, "base64": base64.b64encode(content).decode()} for name, content in files.items()]
    transfer = zone.page.evaluate_handle(
        """files => {
          const transfer = new DataTransfer();
          for (const { name, base64 } of files) {
            const bytes = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
            transfer.items.add(new File([bytes], name));
          }
          return transfer;
        }""",
        given,
    )
    for event in ("dragenter", "dragover", "drop"):
        zone.dispatch_event(event, {"dataTransfer": transfer})


def zipped(files):
    """The bytes of a zip file with these texts by path."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        for path, text in files.items():
            archive.writestr(path, text)
    return content.getvalue()


def home_of(page):
    """The address of the portal."""
    return re.match(r"https?://[^/]+", page.url).group(0)


class Proxy:
    """A proxy between a browser and the server that can be disconnected."""

    def __init__(self, address):
        host, port = re.match(r"https?://([^:/]+):(\d+)", address).groups()
        self._server = (host, int(port))
        self._listener = None
        self._open = []
        self._port = 0
        self.connect()

    @property
    def address(self):
        # The host name of the session; cookies do not depend on the port.
        return f"http://localhost:{self._port}"

    def connect(self):
        self._listener = socket.create_server(("127.0.0.1", self._port), reuse_port=False)
        self._port = self._listener.getsockname()[1]
        threading.Thread(target=self._accept, args=(self._listener,), daemon=True).start()

    def disconnect(self):
        # Closing a listener does not wake the thread that accepts on it.
        with suppress(OSError):
            self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        for end in self._open:
            with suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
            end.close()
        self._open.clear()

    def _accept(self, listener):
        with suppress(OSError):
            while True:
                near, _ = listener.accept()
                far = socket.create_connection(self._server)
                self._open += [near, far]
                for source, target in ((near, far), (far, near)):
                    threading.Thread(target=self._forward, args=(source, target), daemon=True).start()

    @staticmethod
    def _forward(source, target):
        with suppress(OSError):
            while data := source.recv(65536):
                target.sendall(data)
            target.shutdown(socket.SHUT_WR)


# Done when two frames in a row show no transition or animation that still runs: a drawer that fades in is mounted a frame
# before its transition starts. Those without an end, of a loader, are not waited for.
STILL = """async () => {
  const moves = () => document.getAnimations().filter((a) =>
    a.playState === "running" && Number.isFinite(a.effect?.getComputedTiming().endTime));
  for (let still = 0; still < 2;) {
    await new Promise(requestAnimationFrame);
    const moving = moves();
    still = moving.length ? 0 : still + 1;
    await Promise.allSettled(moving.map((a) => a.finished));
  }
}"""


def serious(page):
    """The serious and critical violations that axe finds on the page once its transitions have ended."""
    page.evaluate(AXE.read_text())
    page.evaluate(STILL)
    found = page.evaluate("async () => (await axe.run(document)).violations")
    return [(v["id"], [n["html"][:200] for n in v["nodes"]]) for v in found if v["impact"] in ("serious", "critical")]
