"""Headless Chromium for the tests and the screenshot of `trunk report`: Debian's, driven by Debian's Selenium.

Not by playwright-core: it speaks to the builds of Chromium it was made for, while chromium-driver is of the version of the
Chromium it is installed with, and neither Node nor npm is needed to run the tests."""

import base64
import json
import shutil
import time
import unittest

try:
    from selenium import webdriver
    from selenium.common.exceptions import WebDriverException
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
except ImportError:
    webdriver = None

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
MISSING = None if webdriver and CHROMIUM and DRIVER else "apt install chromium chromium-driver python3-selenium"
READY_S = 60


class Browser:
    """A window of so many CSS pixels. WebGL is drawn in software, as there may be no graphics card."""

    def __init__(self, width=1280, height=900, dark=False):
        if MISSING:
            raise unittest.SkipTest(f"no browser: {MISSING}")
        options = Options()
        options.binary_location = CHROMIUM
        for argument in ("--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                         "--hide-scrollbars", f"--window-size={width},{height}"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.command("Emulation.setDeviceMetricsOverride",
                     {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        if dark:
            self.command("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})

    def command(self, name, arguments):
        return self.driver.execute_cdp_cmd(name, arguments)

    def open(self, path):
        """Until the page says that it is drawn."""
        self.driver.get(path.resolve().as_uri())
        self.until("return document.documentElement.dataset.ready === 'yes'")

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def until(self, script, limit_s=READY_S):
        deadline = time.monotonic() + limit_s
        while not self.run(script):
            if time.monotonic() > deadline:
                raise AssertionError(f"not within {limit_s} s: {script}; console: {self.console()}")
            time.sleep(0.05)

    def keys(self, *keys):
        for key in keys:
            self.driver.switch_to.active_element.send_keys(key)

    def console(self):
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self):
        """Addresses of everything that was asked for."""
        events = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        return [e["params"]["request"]["url"] for e in events if e["method"] == "Network.requestWillBeSent"]

    def screenshot(self, path, whole=False):
        """Of the window, or of the whole page, whose player then stands at its end."""
        options = {"format": "png"}
        if whole:
            self.run("document.querySelector('.player')?.style.setProperty('position', 'static')")
            width, height = self.run("const {clientWidth, scrollHeight} = document.documentElement; return [clientWidth, scrollHeight]")
            options |= {"captureBeyondViewport": True, "clip": {"x": 0, "y": 0, "width": width, "height": height, "scale": 1}}
        path.write_bytes(base64.b64decode(self.command("Page.captureScreenshot", options)["data"]))

    def close(self):
        try:
            self.driver.quit()
        except WebDriverException:
            pass
