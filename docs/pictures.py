#!/usr/bin/python3
"""Takes the pictures of README.md and of the pages in docs/, from runs made on the spot.

    docs/pictures.py build/release/bin/mesopix [NAME...]     all of them, or docs/NAME.png

Needs Debian's chromium-driver, python3-selenium, python3-pil, paraview, imagej and xvfb.
"""
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from PIL import Image
from selenium import webdriver

docs = pathlib.Path(__file__).resolve().parent
data = docs.parent / "data"
mesopix = pathlib.Path(sys.argv[1]).resolve()


def run(*command):
    subprocess.run([str(word) for word in command], check=True)


def keep(picture, name, colours=256):
    """In as few bytes as a picture for a page needs."""
    picture = picture.convert("RGB")
    picture.quantize(colours).save(docs / f"{name}.png", optimize=True)
    print(f"wrote docs/{name}.png, {picture.width} x {picture.height}")


class Browser:
    def __init__(self, address, width, height, dark=False, alive=True):
        options = webdriver.ChromeOptions()
        options.binary_location = "/usr/bin/chromium"
        for argument in ("--headless=new", "--no-sandbox", "--hide-scrollbars", f"--window-size={width},{height}"):
            options.add_argument(argument)
        service = webdriver.chrome.service.Service("/usr/bin/chromedriver")
        self.driver = webdriver.Chrome(service=service, options=options)
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})
        if dark:
            self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                        {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})
        self.driver.get(address)
        if alive:  # the page has a script
            self.wait("document.documentElement.dataset.alive")

    def wait(self, condition):
        while not self.driver.execute_script("return " + condition):
            time.sleep(0.05)

    def do(self, script):
        self.driver.execute_script(script)
        time.sleep(0.5)

    def picture(self):
        return Image.open(io.BytesIO(self.driver.get_screenshot_as_png()))


switch_references_on = "for (const box of document.querySelectorAll('#chart-stress input')) box.click();"
go_to_peak = ("const slider = document.getElementById('film-strain'); slider.value = 400;"
              "slider.dispatchEvent(new Event('input'));")


def report(here):
    browser = Browser((here / "run/report.html").as_uri(), 1100, 1400)
    browser.do(switch_references_on + go_to_peak + "document.querySelector('.setting').scrollIntoView()")
    keep(browser.picture(), "report")
    browser.driver.quit()


def phone(here):
    browser = Browser((here / "run/report.html").as_uri(), 390, 1000, dark=True)
    browser.do(switch_references_on + go_to_peak + "document.querySelector('.setting').scrollIntoView()")
    left = browser.picture()
    browser.do("document.getElementById('film').scrollIntoView()")
    both = Image.new("RGB", (2 * left.width + 20, left.height), "white")
    both.paste(left, (0, 0))
    both.paste(browser.picture(), (left.width + 20, 0))
    browser.driver.quit()
    keep(both, "phone")


def live(here):
    process = subprocess.Popen([mesopix, "simulate", data / "concrete_tension.toml", "--velocity", "0.002 m/s", "--serve",
                                "-o", here / "live"], stderr=subprocess.PIPE, text=True)
    browser = Browser(re.search(r"http://\S+", process.stderr.readline()).group(0), 1100, 760)
    browser.wait("document.getElementById('watch-done').value > 0.33")
    keep(browser.picture(), "live")
    browser.driver.find_element("id", "watch-stop").click()
    process.communicate()
    browser.driver.quit()


def comparison(here):
    second = here / "second"
    run(mesopix, "simulate", data / "concrete_tension.toml", "--seed", "2", "-q", "-o", second)
    run(mesopix, "report", here / "run", second, "-o", here / "comparison.html")
    browser = Browser((here / "comparison.html").as_uri(), 1100, 1150)
    keep(browser.picture(), "comparison", 64)
    browser.driver.quit()


def study(here):
    run(mesopix, "study", data / "tension_study.toml", "--until-ci", "1 %", "-q", "-o", here / "study")
    browser = Browser((here / "study/report.html").as_uri(), 1100, 1330, alive=False)
    keep(browser.picture(), "study", 64)
    browser.driver.quit()


def damage(here):
    run(mesopix, "plot", here / "run", "--at", "110%peak", "-o", here / "damage.png")
    keep(Image.open(here / "damage.png").reduce(2), "damage", 32)


def stress(here):
    run(mesopix, "plot", here / "run", "--what", "stress", "--at", "100%peak", "-o", here / "stress.png")
    keep(Image.open(here / "stress.png").reduce(2), "stress")


def paraview(here):
    """Opens the frames as a user would, and colours one soon after the peak by its stress."""
    (here / "look.py").write_text(f"""
from paraview.simple import *
frames = OpenDataFile({str(here / "run/frames.hdf.series")!r})
view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [900, 700]
view.OrientationAxesVisibility = 0
times = frames.TimestepValues
view.ViewTime = times[int(0.4 * len(times))]
shown = Show(frames, view)
shown.SetRepresentationType("Points")
shown.PointSize = 3
ColorBy(shown, ("POINTS", "stress"))
colours = GetColorTransferFunction("stress")
colours.VectorMode, colours.VectorComponent = "Component", 4  # of xx, xy, xz, yx, yy ...
colours.ApplyPreset("Cool to Warm", True)
colours.RescaleTransferFunction(-1e6, 8e6)
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle = "stress yy [Pa]", ""
view.ResetCamera(True)
SaveScreenshot({str(here / "paraview.png")!r}, view, OverrideColorPalette="WhiteBackground")
""")
    run("xvfb-run", "-a", "pvpython", here / "look.py")
    keep(Image.open(here / "paraview.png"), "paraview")


def imagej(here):
    run(mesopix, "export", here / "run", "--to", "tif", "-o", here)
    (here / "look.ijm").write_text(f"""
open("{here / 'failure_strain.tif'}");
run("Macro...", "code=v=v*1e6");
setMinAndMax(0, 400); run("Fire");
run("Scale...", "x=2 y=2 interpolation=None create title=scaled");
run("Scale Bar...", "width=50 height=6 font=24 color=White background=Black location=[Lower Right] bold");
run("Calibration Bar...", "location=[Upper Right] fill=White label=Black number=5 decimal=0 font=12 zoom=1.5 bold overlay");
run("Flatten"); saveAs("PNG", "{here / 'imagej.png'}");
run("Quit");
""")
    run("xvfb-run", "-a", "java", "-jar", "/usr/share/java/ij.jar", "-batch", here / "look.ijm")
    keep(Image.open(here / "imagej.png"), "imagej")


def follow(page, here):
    """Runs the commands of a page, but for those that are not run as a test."""
    blocks = re.findall(r"(<!-- not run as a test: [^\n]+ -->\n)?```sh\n(.*?)```", (docs / page).read_text(), re.S)
    here.mkdir(exist_ok=True)
    (here / "data").symlink_to(data)
    subprocess.run(["bash", "-eu", "-c", "".join(commands for excuse, commands in blocks if not excuse)], cwd=here, check=True,
                   env=dict(os.environ, PATH=f"{mesopix.parent}:{os.environ['PATH']}"), stderr=subprocess.DEVNULL)


def tutorial_specimen(here):
    follow("tutorial.md", here / "tutorial")
    preview = Image.open(here / "tutorial/cut_preview.png").convert("RGB")
    keep(preview.resize((450, 450), Image.Resampling.NEAREST), "tutorial_specimen", 8)


def tutorial_damage(here):
    if not (here / "tutorial").exists():
        follow("tutorial.md", here / "tutorial")
    run(mesopix, "plot", here / "tutorial/runs/fine", "--at", "110%peak", "-o", here / "damage.png")
    keep(Image.open(here / "damage.png").reduce(3), "tutorial_damage", 32)


def segmentation(here):
    """The picture, and what comes of it: by itself, by Otsu's threshold on grey, and with a least area of islands."""
    follow("segmentation.md", here / "segmentation")
    names = ("difficult.ppm", "first_preview.png", "grey_preview.png", "pores_preview.png")
    panels = [Image.open(here / "segmentation" / name).convert("RGB").resize((240, 240)) for name in names]
    row = Image.new("RGB", (4 * 240 + 3 * 12, 240), "white")
    for i, panel in enumerate(panels):
        row.paste(panel, (252 * i, 0))
    keep(row, "segmentation", 64)


pictures = {one.__name__: one for one in (report, phone, live, comparison, study, damage, stress, paraview, imagej, tutorial_specimen,
                                           tutorial_damage, segmentation)}
wanted = sys.argv[2:] or list(pictures)
for name in wanted:
    if name not in pictures:
        sys.exit(f"{name} is no picture; there are {', '.join(pictures)}")
with tempfile.TemporaryDirectory() as scratch:
    folder = pathlib.Path(scratch)
    run(mesopix, "simulate", data / "concrete_tension.toml", "--frames", "40", "-q", "-o", folder / "run")
    for name in wanted:
        pictures[name](folder)
