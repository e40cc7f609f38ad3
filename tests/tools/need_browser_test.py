"""A machine without a browser skips the tests of the page, or fails where one must be there."""
import os
import pathlib
import shutil
import sys
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "report"))
import run_tests  # noqa: E402


class NeedBrowserTest(unittest.TestCase):
    def status(self, needed):
        environment = {"MORAINE_NEED_BROWSER": needed}
        with (
            mock.patch.dict(os.environ, environment),
            mock.patch.object(shutil, "which", return_value=None),
            mock.patch.object(os, "execv"),
            mock.patch.object(sys, "stderr"),
            self.assertRaises(SystemExit) as ended,
        ):
            run_tests.require_browser()
        return ended.exception.code

    def test_it_is_skipped_unless_needed(self):
        self.assertEqual(self.status(""), run_tests.SKIPPED)
        self.assertEqual(self.status("0"), run_tests.SKIPPED)
        self.assertEqual(self.status("1"), 1)


if __name__ == "__main__":
    unittest.main()
