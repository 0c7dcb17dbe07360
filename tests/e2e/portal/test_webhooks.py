"""The webhooks that an administrator creates in the portal, received by a real HTTP server."""

import hashlib
import hmac
import json
import queue
import re
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pytest

from portal.browsing import ROOT, expect, home_of, serious, shot, zip_of


@pytest.fixture
def receiver():
    """The port of a server that confirms each message, and the messages: their headers and bodies."""
    messages = queue.Queue()

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self):
            body = self.rfile.read(int(self.headers["Content-Length"]))
            self.send_response(204)
            self.end_headers()
            messages.put((self.headers, body))

        def log_message(self, format, *args):
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield server.server_port, messages
        server.shutdown()
        thread.join()


def test_an_administrator_creates_a_webhook_and_sees_its_deliveries(page, receiver, tmp_path):
    port, messages = receiver
    url = f"http://localhost:{port}/builds"
    page.goto(home_of(page) + "/settings")
    section = page.get_by_role("region", name="Webhooks")
    section.get_by_label("URL").fill("http://example.org/")
    section.get_by_role("button", name="Create webhook").click()
    expect(section.get_by_role("alert")).to_contain_text("sitaf.webhooks.allowed-hosts")
    section.get_by_label("URL").fill(url)
    section.get_by_label("The tests of a commit have started").uncheck()
    section.get_by_role("button", name="Create webhook").click()
    created = section.get_by_role("status").filter(has_text="Secret of the webhook to")
    secret = created.locator("pre").inner_text()
    row = section.get_by_role("table", name="Webhooks").get_by_role("row").filter(has_text=url)
    expect(row).to_contain_text("build.finished, commit.finished")
    shot(page, "webhooks")

    archive = zip_of(ROOT / "examples" / "ir-sensor-python", tmp_path / "webhooks.zip")
    page.get_by_role("link", name="Activities", exact=True).click()
    page.get_by_label("Zip file of an activity").set_input_files(archive)
    page.get_by_role("button", name=re.compile("^Build now: ir-sensor-python.* GetInfraredData")).first.click()
    page.get_by_role("heading", name="Result", exact=True).wait_for()
    build = re.search(r"/builds/([^/?]+)", page.url).group(1)
    headers, body = messages.get(timeout=60)
    seconds, signature = re.fullmatch(r"t=(\d+),v1=([0-9a-f]{64})", headers["Sitaf-Signature"]).groups()
    signed = hmac.new(secret.encode(), seconds.encode() + b"." + body, hashlib.sha256).hexdigest()
    assert hmac.compare_digest(signed, signature)
    message = json.loads(body)
    assert (message["event"], message["build"], message["passed"]) == ("build.finished", build, True)

    page.goto(home_of(page) + "/settings")
    section.get_by_role("button", name=f"Deliveries to {url}").click()
    delivery = section.get_by_role("table", name="Deliveries").get_by_role("row").filter(has_text="build.finished")
    expect(delivery).to_contain_text("Delivered")
    expect(delivery).to_contain_text("HTTP 204")
    assert serious(page) == []
    page.set_viewport_size({"width": 390, "height": 844})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    page.set_viewport_size({"width": 1280, "height": 900})
    section.get_by_role("button", name=f"Delete the webhook to {url}").click()
    expect(section.get_by_text("No webhooks yet.")).to_be_visible()
    assert page.complaints == []
