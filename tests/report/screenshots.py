"""Pictures of all samples at the sizes of a laptop and a phone, light and dark."""
import pathlib
import time

import browser


def whole_page(driver, size, is_phone, theme, path):
    browser.set_size(driver, size, is_phone, theme)
    time.sleep(0.4)
    height = driver.execute_script("return document.documentElement.scrollHeight")
    browser.set_size(driver, (size[0], min(height, 9000)), is_phone, theme)
    time.sleep(0.8)
    driver.save_screenshot(str(path))


def take(driver, pages, folder, names=()):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for page in sorted(pages.glob("*.html")):
        if names and page.stem not in names:
            continue
        browser.set_size(driver, browser.LAPTOP)
        driver.get(page.as_uri())
        time.sleep(0.6)
        for kind, size, is_phone in (
            ("laptop", browser.LAPTOP, False),
            ("phone", browser.PHONE, True),
        ):
            for theme in ("light", "dark"):
                whole_page(
                    driver, size, is_phone, theme, folder / f"{page.stem}-{kind}-{theme}.png"
                )
