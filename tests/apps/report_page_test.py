"""Drives the report of a run in headless Chromium, as a reader would, and compares what it shows with the run.

    report_page_test.py FOLDER [--hostile]
"""
import base64
import io
import json
import pathlib
import sys
import tempfile
import time

import h5py
import numpy
from PIL import Image
from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys


class Browser:
    """Chromium with a page, at an address, that has come to life."""

    def __init__(self, address, downloads):
        options = webdriver.ChromeOptions()
        options.binary_location = "/usr/bin/chromium"
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--lang=en"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=webdriver.chrome.service.Service("/usr/bin/chromedriver"),
                                       options=options)
        self.downloads = downloads
        self.driver.execute_cdp_cmd("Page.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(downloads)})
        self.resize(1100)
        self.driver.get(address)
        self.wait("document.documentElement.dataset.alive === 'yes'")

    def resize(self, width):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 1400, "deviceScaleFactor": 1, "mobile": width < 600})

    def run(self, script, *arguments):
        return self.driver.execute_script("return " + script, *arguments)

    def wait(self, condition):
        until = time.monotonic() + 180  # on a machine that does other things too
        while not self.run(condition):
            assert time.monotonic() < until, f"never came true: {condition}"
            time.sleep(0.02)

    def element(self, name):
        return self.driver.find_element(By.ID, name)

    def text(self, name):
        return self.element(name).text

    def press(self, name):
        self.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", self.element(name))
        self.element(name).click()

    def button(self, words):
        return next(button for button in self.driver.find_elements(By.TAG_NAME, "button") if button.text == words)

    def go_to(self, share):
        """Moves the slider of the film to a share of the end strain."""
        self.driver.execute_script(
            "const slider = arguments[0]; slider.step = 'any'; slider.value = arguments[1] * slider.max;"
            "slider.dispatchEvent(new Event('input'))", self.element("film-strain"), share)

    def canvas(self, name):
        """Pixels of a canvas, shape (height, width, 3)."""
        address = self.run("document.getElementById(arguments[0]).toDataURL()", name)
        return numpy.asarray(Image.open(io.BytesIO(base64.b64decode(address.split(",", 1)[1]))).convert("RGB"))

    def saved(self, name, act):
        path = self.downloads / name
        path.unlink(missing_ok=True)  # or the second of a name would come as another
        act()
        until = time.monotonic() + 60
        while not path.exists() or path.stat().st_size == 0:  # the browser reserves the name, and puts the file there later
            assert time.monotonic() < until, f"{name} never came"
            time.sleep(0.05)
        return path.read_bytes()


def film_pixels(browser, rows, cols):
    """Colours of the film's pixels, from what the reader sees; below the scale bar is left out."""
    seen = browser.canvas("film-screen")
    y = ((numpy.arange(rows) + 0.5) * seen.shape[0] / rows).astype(int)
    x = ((numpy.arange(cols) + 0.5) * seen.shape[1] / cols).astype(int)
    return seen[y][:, x][: int(0.9 * rows)]


def picture_pixels(path, rows, cols):
    picture = numpy.asarray(Image.open(path).convert("RGB"))
    factor = picture.shape[0] // rows
    return picture[factor // 2::factor, factor // 2::factor][:rows, :cols][: int(0.9 * rows)]


def check_film(browser, folder, summary, film, end):
    """The film at 25 ... 150 % of the peak strain is the picture that the program wrote, in both looks."""
    rows, cols = film["failure_strain"].shape
    compared = 0
    for look, suffix in (("colour", "_colour"), ("grey", "")):
        browser.driver.execute_script(
            "arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('change'))",
            browser.element("film-look"), look)
        for percent in (25, 50, 75, 100, 125, 150):
            path = folder / f"damage_{percent:03}{suffix}.png"
            if not path.exists():
                continue
            strain = percent / 100 * summary["peak_strain"]
            browser.go_to(strain / end)
            differ = (film_pixels(browser, rows, cols) != picture_pixels(path, rows, cols)).any(axis=2).sum()
            assert differ == 0, f"{differ} pixels differ from {path.name}"
            compared += 1
    assert compared >= 4, compared


def check_readout(browser, film, strain_unit):
    """A pixel under the pointer tells when it failed."""
    failed = numpy.argwhere(film["failure_mode"] == 1)
    row, col = failed[len(failed) // 2]
    rows, cols = film["failure_strain"].shape
    box = browser.run("(() => { const c = document.getElementById('film-screen'); c.scrollIntoView({block: 'center'});"
                      " const b = c.getBoundingClientRect(); return [b.x + c.clientLeft, b.y + c.clientTop,"
                      " c.clientWidth, c.clientHeight]; })()")
    browser.driver.execute_cdp_cmd("Input.dispatchMouseEvent", {
        "type": "mouseMoved", "x": box[0] + (col + 0.5) * box[2] / cols, "y": box[1] + (row + 0.5) * box[3] / rows})
    words = browser.text("film-readout").replace("\u202f", "")
    assert "failed in tension at " in words, words
    said = float(words.split("failed in tension at ")[1].split()[0])
    expected = film["failure_strain"][row, col] * strain_unit["per_strain"]
    assert abs(said / expected - 1) < 1e-3, (said, expected)
    assert "tensile strength " in words, words


def check_controls(browser):
    slider = lambda: float(browser.element("film-strain").get_property("value"))
    browser.go_to(0)
    assert browser.text("film-counts").startswith("0 pixels failed"), browser.text("film-counts")
    browser.press("film-play")
    browser.wait("document.getElementById('film-strain').value > 30")
    browser.press("film-play")
    stopped = slider()
    time.sleep(0.2)
    assert slider() == stopped, "the film goes on"
    screen = browser.element("film-screen")
    before = browser.canvas("film-screen")
    screen.send_keys("+")
    zoomed = browser.canvas("film-screen")
    assert (zoomed != before).any()
    screen.send_keys(Keys.ARROW_RIGHT)
    assert (browser.canvas("film-screen") != zoomed).any()
    browser.press("film-whole")
    assert (browser.canvas("film-screen") == before).all()
    screen.send_keys(" ")
    assert browser.text("film-play") == "Pause"
    screen.send_keys(" ")
    assert browser.text("film-play") == "Play"


def check_charts(browser):
    for chart in ("stress", "energy", "failure"):
        place = f"document.querySelector('#chart-{chart} canvas')"
        drawn = browser.run(
            f"(() => {{ const c = {place}; const p = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
            " let n = 0; for (let i = 3; i < p.length; i += 4) n += p[i] > 0; return n / (c.width * c.height); })()")
        assert 0.01 < drawn < 0.9, f"{chart}: {drawn:.3f} of the chart is drawn on"
    # What falls upright keeps both its ends, beside a curve with other places too.
    columns = browser.run("aligned([{x: [1, 2, 2, 3], y: [1, 3, 0, 1]}, {x: [0, 4], y: [5, 6]}])")
    assert [y for y in columns[1] if y is not None] == [1, 3, 0, 1], columns
    assert columns[0] == sorted(set(columns[0])), columns
    boxes = browser.driver.find_elements(By.CSS_SELECTOR, "#chart-stress input")
    picture = "document.querySelector('#chart-stress canvas').toDataURL()"
    for box in boxes:
        before = browser.run(picture)
        box.click()
        browser.wait(f"{picture} !== {json.dumps(before)}")
    before = browser.run("document.getElementById('film-strain').value")
    over = browser.driver.find_element(By.CSS_SELECTOR, "#chart-stress .u-over")
    browser.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", over)
    ActionChains(browser.driver).move_to_element_with_offset(over, -over.size["width"] // 3, 0).click().perform()
    assert browser.run("document.getElementById('film-strain').value") != before, "a click on the curve does nothing"


def check_files(browser, folder, film):
    assert browser.saved("curve.csv", browser.button("Save as CSV").click) == (folder / "curve.csv").read_bytes()
    curve = Image.open(io.BytesIO(browser.saved("curve.png", browser.button("Save as PNG").click)))
    assert curve.width > 300
    rows, cols = film["failure_strain"].shape
    browser.go_to(1)
    name = f"damage_{browser.text('film-at')}.png".replace("\u202f", "_").replace(" ", "_").replace("%", "percent")
    picture = Image.open(io.BytesIO(browser.saved(name, lambda: browser.press("film-png"))))
    assert picture.width % cols == 0 and picture.height % rows == 0, picture.size
    animated = Image.open(io.BytesIO(browser.saved("damage.gif", lambda: browser.press("film-gif"))))
    assert animated.n_frames == 61 and animated.width % cols == 0, (animated.n_frames, animated.size)
    animated.seek(60)
    last = numpy.asarray(animated.convert("RGB"))
    factor = animated.width // cols
    still = numpy.asarray(picture.convert("RGB"))
    step = picture.width // cols
    assert (last[factor // 2: factor * rows: factor, factor // 2::factor] == still[step // 2::step, step // 2::step]).all()


def check_looks(browser):
    """Dark paper, and a phone on which nothing sticks out."""
    light = browser.run("document.querySelector('#chart-stress canvas').toDataURL()")
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                   {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})
    browser.wait(f"document.querySelector('#chart-stress canvas').toDataURL() !== {json.dumps(light)}")
    background = browser.run("getComputedStyle(document.body).backgroundColor")
    assert background == "rgb(20, 24, 28)", background
    browser.resize(360)
    browser.wait("document.querySelector('#chart-stress canvas').getBoundingClientRect().width <= 360")
    assert browser.run("document.documentElement.scrollWidth") <= 360
    label = "no peak: largest 9.01 MPa at 400 microstrain"  # on a phone it takes more than one line
    lines = browser.run("lines_within(document.createElement('canvas').getContext('2d'), arguments[0], 100)", label)
    assert len(lines) == 3 and " ".join(lines) == label, lines
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print", "features": []})
    assert browser.run("getComputedStyle(document.querySelector('.live')).display") == "none"
    assert browser.run("getComputedStyle(document.querySelector('.is-live .wide')).display") == "block"


def check_nothing_else_runs(browser):
    """The page's own script is the only one that its policy lets run."""
    browser.driver.execute_script(
        "const other = document.createElement('script'); other.textContent = 'window.intruder = 1';"
        "document.body.append(other)")
    assert browser.run("window.intruder === undefined"), "a script that is not the page's own ran"
    refused = browser.driver.get_log("browser")
    assert len(refused) == 1 and "Content Security Policy" in refused[0]["message"], refused


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    page = folder / "report.html"
    with h5py.File(folder / "result.h5") as result:
        film = {name: result[name][()] for name in ("failure_strain", "failure_mode")}
    with tempfile.TemporaryDirectory() as downloads:
        browser = Browser(page.as_uri(), pathlib.Path(downloads))
        try:
            data = browser.run("JSON.parse(document.getElementById('data').textContent)")
            print(f"{page.stat().st_size / 1e6:.2f} MB, alive after {browser.run('performance.now()') / 1e3:.2f} s")
            assert page.stat().st_size < 2e6
            if "--hostile" in sys.argv:
                assert browser.run("document.title") == "</script><script>alert(1)</script>"
                assert browser.run("document.scripts.length") == 2
                assert browser.run("document.querySelectorAll('[onload], [onerror]').length") == 0
            check_film(browser, folder, summary, film, data["film"]["end_strain"])
            check_readout(browser, film, data["strain"])
            check_controls(browser)
            check_charts(browser)
            check_files(browser, folder, film)
            check_looks(browser)
            said = browser.driver.get_log("browser")
            assert not said, f"the console says: {said}"
            check_nothing_else_runs(browser)
        finally:
            browser.driver.quit()


if __name__ == "__main__":
    main()
