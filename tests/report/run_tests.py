#!/usr/bin/env python3
"""Opens sample reports in headless Chromium and tests what the page shows and does.

Usage: run_tests.py [--screenshot FOLDER] [NAME...]
NAME: only tests with this in their names. --screenshot: only pictures of all samples, to look at.
Needs the group "browser" of tools/packages.txt; exits with 77 where it is missing, or with 1 where
MORAINE_NEED_BROWSER says that it must be there.
"""
import argparse
import importlib.util
import os
import pathlib
import shutil
import sys
import time
import unittest

SKIPPED = 77
DEBIAN_PYTHON = "/usr/bin/python3"  # what Debian's packages install into
HERE = pathlib.Path(__file__).resolve().parent


def require_browser():
    missing = [
        program
        for program in ("/usr/bin/chromium", "/usr/bin/chromedriver")
        if not shutil.which(program)
    ]
    if importlib.util.find_spec("selenium") is None:
        if os.path.exists(DEBIAN_PYTHON) and os.path.realpath(sys.executable) != os.path.realpath(
            DEBIAN_PYTHON
        ):
            os.execv(DEBIAN_PYTHON, [DEBIAN_PYTHON, *sys.argv])
        missing.append("python3-selenium")
    if missing:
        is_needed = os.environ.get("MORAINE_NEED_BROWSER", "") not in ("", "0")
        word = "error" if is_needed else "skipped"
        print(
            f"{word}: {', '.join(missing)} missing: tools/install_packages.sh browser",
            file=sys.stderr,
        )
        sys.exit(1 if is_needed else SKIPPED)


class TimedResult(unittest.TextTestResult):
    """Says how long each test took."""

    def startTest(self, test):
        self.began = time.monotonic()
        super().startTest(test)

    def addSuccess(self, test):
        self.stream.write(f"{time.monotonic() - self.began:.1f} s ")
        super().addSuccess(test)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--screenshot", metavar="FOLDER")
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    require_browser()
    sys.path.insert(0, str(HERE))
    from report_test import Shared

    try:
        if arguments.screenshot:
            import screenshots

            Shared.start()
            screenshots.take(Shared.driver, Shared.pages, arguments.screenshot, arguments.names)
            return 0
        loader = unittest.TestLoader()
        loader.testNamePatterns = [f"*{name}*" for name in arguments.names] or None
        result = unittest.TextTestRunner(verbosity=2, resultclass=TimedResult).run(
            loader.discover(str(HERE), pattern="*_test.py")
        )
        # A name that no test has must not look like a success.
        return 0 if result.wasSuccessful() and result.testsRun > 0 else 1
    finally:
        Shared.stop()


if __name__ == "__main__":
    sys.exit(main())
