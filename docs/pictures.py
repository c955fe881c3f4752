#!/usr/bin/python3
"""Takes the pictures of README.md and of the pages in docs/, from runs made on the spot.

    docs/pictures.py build/release/bin/mesopix [NAME...]     all of them, or docs/NAME.png

Needs Debian's chromium-driver, python3-selenium, python3-pil, paraview, imagej and xvfb.
"""
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from PIL import Image, ImageDraw, ImageFont
from selenium import webdriver

docs = pathlib.Path(__file__).resolve().parent
data = docs.parent / "data"
mesopix = pathlib.Path(sys.argv[1]).resolve()


def run(*command):
    subprocess.run([str(word) for word in command], check=True)


def keep(picture, name, colours=256, method=None):
    """In as few bytes as a picture for a page needs."""
    picture = picture.convert("RGB")
    picture.quantize(colours, method).save(docs / f"{name}.png", optimize=True)
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


def editing(here):
    """The page on which strokes teach the same picture."""
    if not (here / "segmentation").exists():
        follow("segmentation.md", here / "segmentation")
    process = subprocess.Popen([mesopix, "convert", "difficult.ppm", "--edit", "--strokes", "strokes.csv", "--width", "60 mm",
                                "-o", "edited.h5"], cwd=here / "segmentation", stderr=subprocess.PIPE, text=True)
    browser = Browser(re.search(r"http://\S+", process.stderr.readline()).group(0), 1280, 860)
    browser.wait("editor.desk.mask && !editor.state.is_sorting")
    browser.do("editor.set_opacity(40)")
    keep(browser.picture(), "editing", method=Image.Quantize.FASTOCTREE)  # which keeps the rare colours too
    browser.driver.quit()
    process.terminate()
    process.communicate()


def stiffness(here):
    """Young's modulus of generated specimens over their width, three each, and of a picture, between their bounds."""
    def told(*inputs):
        return json.loads(subprocess.run([str(mesopix), "stiffness", *map(str, inputs), "--cell", "pixel", "--json", "-q"], check=True,
                                         capture_output=True).stdout)

    names = {"uniform_stress": "#2166ac", "periodic": "#222222", "uniform_strain": "#b2182b"}
    groups = []
    for width in (20, 30, 50, 80, 120):
        files = [here / f"{width}-{seed}.h5" for seed in (1, 2, 3)]
        for seed, file in enumerate(files, 1):
            run(mesopix, "generate", "--width", f"{width} mm", "--height", f"{width} mm", "--d-max", "12 mm", "--seed", seed, "-q",
                "-o", file)
        groups.append((f"{width} mm", told(*files)["specimens"]))
    groups.append(("concrete.png", told(data / "concrete.png")["specimens"]))

    lowest, highest, left, bottom, step = 23, 29, 90, 400, 110
    scale = 2  # drawn large and made small, so that lines are smooth
    image = Image.new("RGB", (scale * (left + step * len(groups) + 20), scale * (bottom + 80)), "white")
    draw = ImageDraw.Draw(image)
    font = ImageFont.truetype("DejaVuSans.ttf", scale * 14)

    def place(x, gigapascal):
        return scale * x, scale * (bottom - (gigapascal - lowest) / (highest - lowest) * (bottom - 40))

    for tick in range(lowest, highest + 1):
        draw.line([place(left, tick), place(left + step * len(groups), tick)], fill="#dddddd", width=scale)
        draw.text(place(left - 10, tick), str(tick), fill="black", font=font, anchor="rm")
    draw.text((scale * 10, scale * 8), "Young's modulus (GPa); band: Hashin-Shtrikman, lines: Reuss and Voigt", fill="black", font=font)
    for i, (name, specimens) in enumerate(groups):
        middle = left + step * (i + 0.5)
        bounds = {key: sum(one["bounds"][key]["young_Pa"] for one in specimens) / len(specimens) / 1e9 for key in specimens[0]["bounds"]}
        draw.rectangle([place(middle - 35, bounds["hashin_shtrikman_upper"]), place(middle + 35, bounds["hashin_shtrikman_lower"])],
                       fill="#ececd8")
        for key in ("reuss", "voigt"):
            draw.line([place(middle - 35, bounds[key]), place(middle + 35, bounds[key])], fill="#888855", width=2 * scale)
        for shift, (key, colour) in zip((-18, 0, 18), names.items()):
            for one in specimens:
                x, y = place(middle + shift, one[key]["young_Pa"] / 1e9)
                draw.ellipse([x - 4 * scale, y - 4 * scale, x + 4 * scale, y + 4 * scale], fill=colour)
        draw.text((scale * middle, scale * (bottom + 12)), name, fill="black", font=font, anchor="mt")
    for i, (key, colour) in enumerate(names.items()):
        draw.text((scale * (left + 170 * i), scale * (bottom + 45)), key.replace("_", " "), fill=colour, font=font)
    keep(image.reduce(scale), "stiffness", 64)


pictures = {one.__name__: one for one in (report, phone, live, comparison, study, damage, stress, paraview, imagej, tutorial_specimen,
                                           tutorial_damage, segmentation, editing, stiffness)}
wanted = sys.argv[2:] or list(pictures)
for name in wanted:
    if name not in pictures:
        sys.exit(f"{name} is no picture; there are {', '.join(pictures)}")
with tempfile.TemporaryDirectory() as scratch:
    folder = pathlib.Path(scratch)
    run(mesopix, "simulate", data / "concrete_tension.toml", "--frames", "40", "-q", "-o", folder / "run")
    for name in wanted:
        pictures[name](folder)
