# SPDX-License-Identifier: Apache-2.0
"""A headless Chromium for tests: opens pages of files, and tells what they asked the network for."""
import json
import shutil
import sys
import tempfile

SKIPPED = 77  # CTest's SKIP_RETURN_CODE
READY_S = 30  # longest wait for a page's program: a hundred times what it takes on a busy machine
CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    webdriver = None


def require_browser():
    """Ends the program as skipped where there is no browser to test with."""
    if webdriver is None or CHROMIUM is None or DRIVER is None:
        print("skipped: needs chromium, chromium-driver and python3-selenium; scripts/install.sh test")
        sys.exit(SKIPPED)


class Browser:
    """One Chromium with a profile of its own. `webgl`: whether pages can draw in three dimensions."""

    def __init__(self, webgl=True, size="1366,900"):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        options = webdriver.ChromeOptions()
        options.binary_location = CHROMIUM
        drawing = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
        for argument in ["--headless", "--no-sandbox", "--disable-quic", "--no-first-run",
                         "--disable-background-networking", "--disable-component-update",
                         "--disable-sync", f"--window-size={size}",
                         f"--user-data-dir={self.profile.name}",
                         *(drawing if webgl else ["--disable-gpu", "--disable-3d-apis"])]:
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.driver.set_script_timeout(60)

    def close(self):
        self.driver.quit()
        self.profile.cleanup()

    def open(self, page):
        """Loads a file and waits until its program says that it is done."""
        self.driver.get_log("browser"), self.driver.get_log("performance")  # of the page before
        self.driver.get(page.resolve().as_uri())
        ready = "return document.documentElement.dataset.ready === 'true'"
        WebDriverWait(self.driver, READY_S).until(lambda _: self.run(ready), "not ready")

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def errors(self):
        """What the console reports as an error since the page was opened."""
        return [entry["message"] for entry in self.driver.get_log("browser")
                if entry["level"] == "SEVERE"]

    def outside_requests(self):
        """Addresses that the page asked for and that are neither files nor inside the page."""
        addresses = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                addresses.append(message["params"]["request"]["url"])
        assert addresses, "the log of requests is empty: it would not show any"
        return [a for a in addresses if not a.startswith(("file:", "data:", "blob:"))]
