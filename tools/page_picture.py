#!/usr/bin/env python3
"""A picture of a report page, as it looks on a laptop or a phone.

Usage: page_picture.py PAGE PICTURE [--phone] [--dark] [--height PIXELS] [--at SELECTOR] [--frame SHARE]
                       [--own-range] [--colour FIELD]
--at: scrolls to this element first. --frame: moves the player to this share of its frames, 0 to 1.
--own-range: colours span the values of that frame instead of those of all frames.
--colour: colours the particles by this field.
Needs the group "browser" of tools/packages.txt.
"""
import argparse
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests" / "report"))
import browser  # noqa: E402


def move_player(driver, share):
    driver.execute_script(
        "const slider = document.querySelector('#particles input[type=range]');"
        "slider.value = Math.round(arguments[0] * slider.max);"
        "slider.dispatchEvent(new Event('input', {bubbles: true}));",
        share,
    )


def use_own_range(driver):
    driver.execute_script(
        "const list = document.querySelector('#particles select[aria-label=Range]');"
        "list.value = 'frame';"
        "list.dispatchEvent(new Event('change', {bubbles: true}));"
    )


def colour_by(driver, field):
    driver.execute_script(
        "const list = document.querySelector('#particles select[aria-label=\"Colour by\"]');"
        "list.value = [...list.options].find(o => o.text.startsWith(arguments[0])).value;"
        "list.dispatchEvent(new Event('change', {bubbles: true}));",
        field,
    )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--phone", action="store_true")
    parser.add_argument("--dark", action="store_true")
    parser.add_argument("--height", type=int)
    parser.add_argument("--at")
    parser.add_argument("--frame", type=float)
    parser.add_argument("--own-range", action="store_true")
    parser.add_argument("--colour")
    arguments = parser.parse_args()
    width, height = browser.PHONE if arguments.phone else browser.LAPTOP
    driver = browser.start()
    try:
        size = (width, arguments.height or height)
        browser.set_size(driver, size, arguments.phone, "dark" if arguments.dark else "light")
        driver.get(arguments.page.resolve().as_uri())
        time.sleep(1.5)
        if arguments.frame is not None:
            move_player(driver, arguments.frame)
        if arguments.colour:
            colour_by(driver, arguments.colour)
        if arguments.own_range:
            time.sleep(0.5)
            use_own_range(driver)
        if arguments.at:
            driver.execute_script(
                "document.querySelector(arguments[0]).scrollIntoView({behavior: 'instant'})",
                arguments.at,
            )
        time.sleep(1.5)
        driver.save_screenshot(str(arguments.picture))
    finally:
        driver.quit()


if __name__ == "__main__":
    main()
