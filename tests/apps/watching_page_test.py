"""Watches runs in headless Chromium while they go on, stops one there, and compares what was seen with its files.

    watching_page_test.py MESOPIX
"""
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

import h5py
import numpy
from selenium.webdriver.common.by import By

from report_page_test import Browser, film_pixels, picture_pixels

TITLE = "</script><script>alert(1)</script>"


class Run:
    """A tension test that would take a minute, or the rest of one, and the address at which it can be watched."""

    def __init__(self, mesopix, folder):
        self.folder = folder
        rest = ["--resume", folder] if folder.exists() else [
            folder.parent / "specimen.h5", "-o", folder, "--title", TITLE, "--velocity", "0.0002 m/s", "--stop-strain", "4e-4"]
        self.process = subprocess.Popen([mesopix, "simulate", *rest, "--serve", "--threads", "1", "-q"],
                                        stderr=subprocess.PIPE, text=True)
        line = self.process.stderr.readline()
        self.address = re.fullmatch(r"watch the run at (http://127\.0\.0\.1:\d+/[0-9a-f]{32}/)\n", line).group(1)


def share(browser):
    return browser.run("document.getElementById('watch-done').value")


def rows_of_curve(browser):
    """Rows that the stress chart shows; its legend is of no use for that, its data are."""
    return browser.run("living.then((page) => page.charts.find((one) => one.id === 'stress').plot.data[0].length)")


def rows_of_file(run):
    return len((run.folder / "curve.csv").read_text(encoding="utf-8").splitlines()) - 1


def check_growth(browser):
    """The page follows the run; what the reader has set stays."""
    before = share(browser), rows_of_curve(browser)
    browser.wait(f"document.getElementById('watch-done').value > {before[0] + 0.02}")
    assert rows_of_curve(browser) > before[1]
    slider = browser.run("document.getElementById('film-strain').value")
    assert slider == "1000", f"the film was at its end and is left behind, at {slider}"
    browser.go_to(0.5)
    chosen = browser.text("film-at")
    now = share(browser)
    browser.wait(f"document.getElementById('watch-done').value > {now + 0.02}")
    assert browser.text("film-at") == chosen, "the film has left the strain that the reader chose"
    assert float(browser.run("document.getElementById('film-strain').value")) < 490
    browser.go_to(1)


def check_end(browser, run):
    """The button ends the run in order, and the page has all of it."""
    browser.press("watch-stop")
    assert run.process.wait(60) == 75, run.process.stderr.read()
    browser.wait("document.getElementById('watch-words').textContent.startsWith('The run has ended')")
    assert browser.text("watch-words") == (f"The run has ended: it was interrupted. Its report is {run.folder}/report.html")
    assert not browser.element("watch-stop").is_displayed()
    summary = json.loads((run.folder / "summary.json").read_text(encoding="utf-8"))
    assert summary["stop_reason"] == "interrupted"
    browser.go_to(1)
    said = [int(count) for count in re.findall(r"\d+", re.sub(r"(?<=\d)\D(?=\d{3})", "", browser.text("film-counts")))]
    assert said == [summary["tension_failures"], summary["shear_failures"]], (said, summary)
    assert said[0] > 0, "nothing failed, so that nothing was compared"
    assert browser.saved("curve.csv", browser.button("Save as CSV").click) == (run.folder / "curve.csv").read_bytes()
    solution = browser.text("part-solution")
    assert "it was interrupted" in solution, solution


def check_film_of_end(browser, run):
    with h5py.File(run.folder / "result.h5") as result:
        failed = result["failure_mode"][()]
    seen = film_pixels(browser, *failed.shape)
    colours = browser.run("JSON.parse(document.getElementById('data').textContent).film")
    cracked = [int(colours["tension"]["colour"][at:at + 2], 16) for at in (1, 3, 5)]
    assert ((seen == cracked).all(axis=2) == (failed == 1)[:len(seen)]).all(), "the cracks are drawn elsewhere"


def check_resumption(browser, mesopix, stopped, done):
    """A run that goes on is shown from its beginning; its bar is not before where it was."""
    shown, rows = rows_of_curve(browser), rows_of_file(stopped)
    run = Run(mesopix, stopped.folder)
    try:
        browser.driver.get(run.address)
        browser.wait("document.documentElement.dataset.alive === 'yes'")
        assert done <= share(browser) < 1, (done, share(browser))
        assert rows_of_curve(browser) >= shown, "the rows before the stop are missing"
        browser.wait("!document.getElementById('film-counts').textContent.startsWith('0 pixels')")
        check_end(browser, run)
        check_film_of_end(browser, run)
        assert rows_of_file(run) > rows
    finally:
        run.process.kill()


def main():
    mesopix = sys.argv[1]
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch).resolve()
        subprocess.run([mesopix, "generate", "--width", "60 mm", "--height", "60 mm", "--d-max", "16 mm", "-o",
                        scratch / "specimen.h5", "-q"], check=True)
        run = Run(mesopix, scratch / "stopped")
        browser = Browser(run.address, scratch)
        try:
            assert browser.run("document.title") == TITLE
            assert browser.run("document.scripts.length") == 2
            browser.wait("!document.getElementById('film-counts').textContent.startsWith('0 pixels')")
            check_growth(browser)
            done = share(browser)
            check_end(browser, run)
            check_film_of_end(browser, run)
            check_resumption(browser, mesopix, run, done)
            said = browser.driver.get_log("browser")
            assert not said, f"the console says: {said}"
            killed = Run(mesopix, scratch / "killed")
            browser.driver.get(killed.address)
            browser.wait("document.documentElement.dataset.alive === 'yes'")
            killed.process.send_signal(signal.SIGKILL)
            browser.wait("document.getElementById('watch-words').textContent.includes('no longer answers')")
        finally:
            browser.driver.quit()
            run.process.kill()


if __name__ == "__main__":
    main()
