"""Live mode against a small server in this process."""
import http.server
import json
import threading
import unittest
import urllib.parse

from report_test import ReportTest, time
from sample_sweep import live_data, live_page


class Program:
    """Answers like a running program."""

    def __init__(self):
        self.data = live_data(1, 20, 2)
        self.unchanged = 0
        program = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def log_message(self, *_):
                pass

            def do_GET(self):
                address = urllib.parse.urlparse(self.path)
                if address.path == "/":
                    return self.answer("text/html; charset=utf-8", live_page())
                since = urllib.parse.parse_qs(address.query).get("since", [""])[0]
                if since == str(program.data["revision"]):
                    program.unchanged += 1
                    self.send_response(304)
                    return self.end_headers()
                return self.answer("application/json", json.dumps(program.data))

            def answer(self, kind, text):
                body = text.encode()
                self.send_response(200)
                self.send_header("Content-Type", kind)
                self.send_header("Content-Length", str(len(body)))
                self.end_headers()
                self.wfile.write(body)

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.thread = threading.Thread(target=self.server.serve_forever, daemon=True)
        self.thread.start()

    def stop(self):
        self.server.shutdown()
        self.server.server_close()
        self.thread.join()


class LiveTest(ReportTest):
    expected_errors = ("data.json?since=1 - Failed to load resource: net::ERR_",)

    def setUp(self):
        super().setUp()
        self.program = Program()
        self.is_serving = True

    def tearDown(self):
        if self.is_serving:
            self.program.stop()
        self.driver.get("about:blank")
        super().tearDown()

    def test_answers_that_are_none_change_nothing(self):
        self.program.data = {"revision": 0}  # nothing that the page could read
        self.driver.get(f"http://127.0.0.1:{self.program.server.server_address[1]}/")
        self.wait(lambda: "this page reads format 1" in self.text(".live-message"))
        shown = [section.get_attribute("id") for section in self.all("main section:not([hidden])")]
        self.assertEqual(shown, ["cite"])
        self.program.data = live_data(1, 20, 2)
        self.wait(lambda: self.all(".progress"))

    def test_a_run_from_start_to_end(self):
        self.driver.get(f"http://127.0.0.1:{self.program.server.server_address[1]}/")
        self.wait(lambda: self.all(".progress"))
        text = self.text(".live")
        for wanted in (
            "95 ms of 500 ms",
            "19.0 %",
            "75 s",
            "812 a second",
            "limited by sound speed",
        ):
            self.assertIn(wanted, text)
        chart = self.charts()[0]
        self.wait(lambda: self.program.unchanged > 4)
        self.assertIn("Live; last answer", self.text(".live-message"))

        plot = chart.find_element("css selector", ".plot")
        self.run_script("arguments[0].focus()", plot)
        plot.send_keys("+", "+")
        zoomed = self.hover_time(chart, 0.999)
        self.program.data = live_data(2, 60, 8)
        self.wait(lambda: "295 ms" in self.text(".live"))
        self.wait(lambda: "of 8" in self.text(".transport .time"))
        self.assertAlmostEqual(self.hover_time(chart, 0.999), zoomed, delta=0.006)
        plot.send_keys("0")
        self.assertGreater(self.hover_time(chart, 0.999), 0.28)

        self.program.data = live_data(3, 101, 12, "ended")
        self.wait(lambda: "has ended" in self.text(".live-message"))
        self.assertIn("end time reached", self.text(".live"))
        self.assertEqual(self.all(".progress"), [])

    def hover_time(self, chart, share):
        self.hover(chart, share)
        value, unit = (
            chart.find_element("css selector", ".at").text.replace("\u00a0", " ").split()[1:]
        )
        return float(value) * {"ms": 1e-3, "s": 1.0}[unit]

    def test_a_silent_program_is_told(self):
        self.driver.get(f"http://127.0.0.1:{self.program.server.server_address[1]}/")
        self.wait(lambda: self.all(".progress"))
        self.program.stop()
        self.is_serving = False
        self.wait(lambda: "no longer answers" in self.text(".live-message"))
        self.assertTrue(self.all("#curves .chart"))
        time.sleep(0.1)


if __name__ == "__main__":
    unittest.main()
