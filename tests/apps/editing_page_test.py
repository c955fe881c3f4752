"""Teaches a picture on the page of `mesopix convert --edit` in headless Chromium, as a person would.

    editing_page_test.py MESOPIX
"""
import hashlib
import json
import pathlib
import re
import shlex
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

import numpy
from PIL import Image
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from report_page_test import Browser

SIZE = 240
STONES = [(60, 70, 34), (124, 70, 34), (70, 180, 40), (180, 170, 36)]  # the first two touch: x, y, radius


def write_picture(path):
    """Bright stones in mortar that is rough and of nearly the same colour."""
    random = numpy.random.default_rng(1)
    y, x = numpy.mgrid[0:SIZE, 0:SIZE] + 0.5
    stone = numpy.any([(x - a) ** 2 + (y - b) ** 2 < r * r for a, b, r in STONES], axis=0)
    noise = random.uniform(-1, 1, (SIZE, SIZE))
    tones = numpy.where(stone[..., None], [140, 148, 160], [158, 146, 128]) + noise[..., None] * numpy.where(stone, 6, 24)[..., None]
    Image.fromarray(tones.clip(0, 255).astype("uint8")).save(path)


class Page:
    """The program, and its page in a browser."""

    def __init__(self, mesopix, folder, *options, browser=None):
        self.process = subprocess.Popen([mesopix, "convert", "photo.png", "--edit", *options], cwd=folder, stdin=subprocess.DEVNULL,
                                        stderr=subprocess.PIPE, text=True)
        line = self.process.stderr.readline()
        self.address = re.fullmatch(r"edit the picture at (http://127\.0\.0\.1:\d+/[0-9a-f]{32}/)\n", line).group(1)
        self.browser = browser or Browser(self.address, folder)
        if browser:
            browser.driver.get(self.address)
            browser.wait("document.documentElement.dataset.alive === 'yes'")

    def run(self, script, *arguments):
        return self.browser.run(script, *arguments)

    def settle(self):
        """Until all that was ordered is seen."""
        self.browser.wait("editor.orders.then(() => true)")
        self.browser.wait("editor.desk.passing.length === 0 && !editor.state.is_sorting && !editor.state.is_making")

    def press(self, key):
        ActionChains(self.browser.driver).send_keys(key).perform()

    def screen(self, x, y):
        left, top, x0, y0, scale = self.run(
            "(() => { const box = editor.desk.canvas.getBoundingClientRect();"
            "return [box.left, box.top, editor.desk.left, editor.desk.top, editor.desk.scale]; })()")
        return round(left + (x - x0) * scale), round(top + (y - y0) * scale)

    def draw(self, *points):
        """With the mouse, through points of the picture."""
        actions = ActionChains(self.browser.driver, duration=20).w3c_actions
        for number, point in enumerate(points):
            actions.pointer_action.move_to_location(*self.screen(*point))
            if number == 0:
                actions.pointer_action.pointer_down()
        actions.pointer_action.pointer_up()
        actions.perform()
        self.settle()

    def type(self, field, text):
        field = self.browser.element(field) if "." not in field else self.browser.driver.find_element(
            "css selector", f'[data-key="{field}"]')
        field.clear()
        field.send_keys(text + Keys.ENTER)
        self.settle()

    def strokes(self):
        return self.run("editor.desk.strokes.length")

    def count(self):
        return self.run("editor.state.found.figures.aggregates.count")

    def labels(self):
        """What the mask shows at the middles of the stones, and between them."""
        return self.run("(() => { const { phases } = editor.desk.mask; const pen = phases.getContext('2d');"
                        "return arguments[0].map(([x, y]) => pen.getImageData(x, y, 1, 1).data[0]); })()",
                        [[x, y] for x, y, _ in STONES] + [[20, 130], [120, 225]])

    def pixels(self):
        """Of the canvas, once it is drawn in the size that it has."""
        self.browser.wait("(() => { const { canvas, ratio, is_due } = editor.desk; return !is_due &&"
                          "canvas.width === Math.round(canvas.getBoundingClientRect().width * ratio); })()")
        return self.browser.canvas("canvas").astype(int)

    def wait_for(self, what, condition):
        until = time.monotonic() + 60
        while not condition():
            assert time.monotonic() < until, what

    def end(self, how):
        self.process.send_signal(how)
        said = self.process.communicate(timeout=60)[1]
        return self.process.returncode, said


def teach(page, folder):
    """Two phases by strokes; the mask comes over the picture."""
    bare = page.pixels()
    page.press("1")
    page.draw((45, 60), (70, 85), (60, 60))
    assert page.strokes() == 1
    assert "two phases need a stroke" in page.browser.text("status"), page.browser.text("status")
    page.draw((165, 160), (195, 180))
    page.press("2")
    page.draw((20, 130), (110, 135), (150, 120))
    page.draw((120, 200), (120, 230))
    page.press("s")  # the strokes are hidden: what is seen now is the mask
    stone, mortar = 0x70, 0xe2
    assert page.labels() == [stone] * 4 + [mortar] * 2, page.labels()
    page.wait_for("the mask is not seen", lambda: abs(page.pixels() - bare).mean() > 5)
    page.press("m")
    page.press("u")
    page.wait_for("without mask, strokes and doubts the picture is not as it was",
                  lambda: abs(page.pixels() - bare).mean() < 0.5)
    page.press("m")
    page.press("s")
    lines = (folder / "photo.strokes.csv").read_text().splitlines()
    assert lines[0] == "stroke,phase,width_px,x_px,y_px" and {line.split(",")[0] for line in lines[1:]} == set("1234")


def change(page, folder):
    """Undo, redo, erase, cut, one grain; the count of grains follows."""
    assert page.count() == 3, page.count()
    page.press("c")
    page.draw((92, 30), (92, 110))
    assert page.count() == 4, "the cut parts two stones that touch"
    page.press("g")
    page.draw((70, 70), (114, 70))
    assert page.count() == 3, "one grain undoes the cut"
    for _ in range(2):
        ActionChains(page.browser.driver).key_down(Keys.CONTROL).send_keys("z").key_up(Keys.CONTROL).perform()
        page.settle()
    assert page.strokes() == 4 and page.count() == 3
    page.browser.press("redo")
    page.browser.wait("editor.desk.strokes.length === 5")
    page.settle()
    assert page.count() == 4
    page.press("e")
    page.draw((80, 40), (100, 40))
    assert page.strokes() == 4 and page.count() == 3, "the cut is erased"
    page.browser.press("undo")
    page.browser.wait("editor.desk.strokes.length === 5")
    page.settle()


def measure(page):
    """The ruler gives the width of the picture."""
    assert not page.browser.element("make").is_enabled(), "there is no scale yet"
    page.press("r")
    for point in ((20, 20), (140, 20)):
        page.draw(point, point)
    page.browser.wait("!document.getElementById('asked').hidden")
    page.type("answer", "12 mm")
    width = page.run("editor.state.settings['convert.width']")
    assert abs(float(width.split()[0]) - 24) < 0.3 and width.endswith(" mm"), width
    page.type("convert.drop_islands", "0.1 mm2")
    assert page.run("editor.state.settings['convert.drop_islands']") == "0.1 mm2"
    page.type("convert.smooth", "three")
    assert "--smooth" in page.browser.text("message") and page.run("editor.state.settings['convert.smooth']") == "auto"
    page.type("convert.smooth", "")


def make(page, mesopix, folder):
    """The specimen, and the same one by the command that is shown."""
    page.browser.press("make")
    page.browser.wait("editor.state.made !== null")
    page.settle()
    command = page.browser.text("command")
    made = (folder / "cut.h5").read_bytes()
    words = shlex.split(command)
    assert words[0] == "mesopix" and "cut_strokes.csv" in words, words
    (folder / "cut.h5").rename(folder / "by_page.h5")
    subprocess.run([mesopix, *words[1:], "-q"], cwd=folder, check=True)
    again = (folder / "cut.h5").read_bytes()
    assert hashlib.sha256(again).digest() == hashlib.sha256(made).digest(), "the command makes another specimen"
    assert (folder / "cut_strokes.csv").read_bytes() == (folder / "photo.strokes.csv").read_bytes()
    assert page.count() == 4 and "1/" not in page.browser.text("status")


def post(address, name, body, **headers):
    request = urllib.request.Request(address + name, body, headers=headers, method="POST")
    try:
        return urllib.request.urlopen(request, timeout=20).status
    except urllib.error.HTTPError as error:
        return error.code


def attack(page):
    """Others, and orders that are none, change nothing."""
    before = page.run("editor.state.version")
    good = json.dumps({"phase": "mortar", "width": 3, "points": [[5, 5]]}).encode()
    wrong = page.address[:-3] + ("00/" if page.address[-3:-1] != "00" else "11/")
    assert post(wrong, "add", good) == 404
    assert post(page.address, "add", good, Host="evil.example") == 404
    assert post(page.address, "add", good, Origin="http://evil.example") == 404
    assert post(page.address, "add", b" " * 2_000_001) == 413
    for bad in (b"", b"{", b'{"phase": "mortar", "width": 3, "points": [[5, 999]]}', b'{"phase": "a b", "width": 3, "points": [[5, 5]]}'):
        assert post(page.address, "add", bad) == 400, bad
    guest = socket.create_connection(("127.0.0.1", int(page.address.split(":")[2].split("/")[0])))
    guest.sendall(b"POST /")  # and no more
    assert page.run("editor.ask().then(() => editor.state.version)") == before
    guest.close()


def look(page):
    """The page fits narrow and wide windows, light and dark."""
    for width in (700, 1280):
        page.browser.resize(width)
        page.browser.wait(f"window.innerWidth === {width}")
        assert page.run("document.documentElement.scrollWidth") <= width, f"wider than {width}"
        assert page.run("editor.desk.canvas.getBoundingClientRect().width") > 300
    light = page.run("getComputedStyle(document.body).backgroundColor")
    page.browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                        {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})
    assert page.run("getComputedStyle(document.body).backgroundColor") != light


def main():
    mesopix = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch).resolve()
        write_picture(folder / "photo.png")
        page = Page(mesopix, folder, "-o", "cut.h5", "--itz-mode", "none")
        browser = page.browser
        browser.resize(1280)
        try:
            teach(page, folder)
            change(page, folder)
            second = subprocess.run([mesopix, "convert", "photo.png", "--edit"], cwd=folder, capture_output=True, text=True)
            assert second.returncode == 75 and "is being edited by another mesopix" in second.stderr, second.stderr
            code, said = page.end(signal.SIGTERM)
            assert code == 75 and "the strokes are kept in photo.strokes.csv" in said, (code, said)
            kept = (folder / "photo.strokes.csv").read_bytes()
            browser.wait("document.getElementById('message').textContent.includes('strokes are kept in photo.strokes.csv')")

            page = Page(mesopix, folder, "-o", "cut.h5", "--itz-mode", "none", browser=browser)
            page.settle()
            assert page.strokes() == 5 and page.count() == 4, "the strokes are still there"
            attack(page)
            assert (folder / "photo.strokes.csv").read_bytes() == kept
            measure(page)
            make(page, mesopix, folder)
            look(page)
            log = [line for line in browser.driver.get_log("browser")
                   if not any(known in line["message"] for known in ("ERR_CONNECTION_REFUSED", "400", "getImageData"))]
            assert not log, f"the console says: {log}"
            browser.press("finish")
            assert page.process.wait(30) == 0, page.process.stderr.read()
            browser.wait("document.getElementById('message').textContent.startsWith('The program has ended')")
        finally:
            browser.driver.quit()
            page.process.kill()


if __name__ == "__main__":
    main()
