"""Headless Chromium for the tests."""
import pathlib
import tempfile

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

LAPTOP = (1280, 800)
PHONE = (390, 844)


def start(downloads=None):
    options = Options()
    options.binary_location = "/usr/bin/chromium"
    for argument in (
        "--headless=new",
        "--no-sandbox",
        "--use-gl=angle",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        "--disable-dev-shm-usage",
        "--hide-scrollbars",
        "--window-size=1280,800",
        "--no-first-run",
        # Only particles need the software renderer; drawing all else with it takes twice the time.
        "--disable-gpu-compositing",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-extensions",
    ):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    if downloads:
        options.add_experimental_option(
            "prefs",
            {"download.default_directory": str(downloads), "download.prompt_for_download": False},
        )
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def set_size(driver, size, is_phone=False, theme="light", is_calm=True):
    driver.execute_cdp_cmd(
        "Emulation.setDeviceMetricsOverride",
        {"width": size[0], "height": size[1], "deviceScaleFactor": 1, "mobile": is_phone},
    )
    features = [
        {"name": "prefers-color-scheme", "value": theme},
        {"name": "prefers-reduced-motion", "value": "reduce" if is_calm else "no-preference"},
    ]
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})


def write_samples(samples, names=None):
    """Folder with the pages of the samples; generated once for all tests."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="moraine-report-"))
    for name, make in samples.items():
        if names is None or name in names:
            (folder / f"{name}.html").write_text(make())
    return folder
