"""One system for all tests of the portal, and a browser that is signed in to it; they end with this folder."""

import os
import re
import shutil
import signal
import subprocess
from contextlib import contextmanager

import pytest

PATIENCE_MS = 90_000
# WebGL without a graphics card. Pages are composed without it, which takes less processor time.
SOFTWARE_GL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing")


@pytest.fixture(scope="package")
def link(browser, sitaf, tmp_path_factory):
    """A running system; the link that opens its portal signed in, once."""
    data = tmp_path_factory.mktemp("portal")
    system = subprocess.Popen(
        [sitaf.root / "sitaf", "up", "--port", "0", "--grpc-port", "0", "--data", data],
        env=os.environ | {"SITAF_WEBHOOKS_ALLOWEDHOSTS": "localhost", "SITAF_WEBHOOKS_PRIVATEADDRESSES": "true"},
        stdout=subprocess.PIPE,
        stdin=subprocess.PIPE,
        text=True,
    )
    try:
        yield next(
            found.group(1)
            for line in system.stdout
            if (found := re.search(r"Sign in with this link, valid once: (http\S+)", line))
        )
    finally:
        system.send_signal(signal.SIGTERM)
        system.wait(timeout=60)


@pytest.fixture(scope="package")
def browser(driver):
    """Debian's Chromium; the tests of the portal are skipped where it is not there."""
    if shutil.which("chromium") is None:
        pytest.skip("Chromium is missing; './sitaf doctor' says how to get it")
    chromium = driver.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox", *SOFTWARE_GL])
    yield chromium
    chromium.close()


@pytest.fixture(scope="package")
def tab_of(browser):
    """Opens a page that collects what the browser complains of in `complaints`; closed after its block."""

    @contextmanager
    def opened(**how):
        context = browser.new_context(viewport={"width": 1280, "height": 900}, color_scheme="light", **how)
        context.set_default_timeout(PATIENCE_MS)
        tab = context.new_page()
        tab.complaints = []
        tab.on("dialog", lambda dialog: (tab.complaints.append(dialog.message), dialog.dismiss()))
        tab.on("pageerror", lambda error: tab.complaints.append(str(error)))
        tab.on(
            "console",
            lambda message: tab.complaints.append(message.text) if "Content Security Policy" in message.text else None,
        )
        try:
            yield tab
        finally:
            context.close()

    return opened


@pytest.fixture(scope="package")
def page(tab_of, link):
    """A signed-in page, the same in all tests; what the browser complains of fails the test that ends them."""
    with tab_of() as tab:
        tab.goto(link)
        yield tab
