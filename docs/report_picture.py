#!/usr/bin/python3
"""Takes the picture of the report that the README shows: docs/report.png. Needs Debian's chromium-driver,
python3-selenium and python3-pil. Usage, in the project: docs/report_picture.py build/release/bin/mesopix"""
import io
import pathlib
import subprocess
import sys
import tempfile
import time

from PIL import Image
from selenium import webdriver

docs = pathlib.Path(__file__).resolve().parent
with tempfile.TemporaryDirectory() as scratch:
    run = pathlib.Path(scratch) / "run"
    subprocess.run([sys.argv[1], "simulate", docs.parent / "data/concrete_tension.toml", "-o", run], check=True)
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--hide-scrollbars", "--window-size=1100,1400"):
        options.add_argument(argument)
    browser = webdriver.Chrome(service=webdriver.chrome.service.Service("/usr/bin/chromedriver"), options=options)
    browser.get((run / "report.html").as_uri())
    while not browser.execute_script("return document.documentElement.dataset.alive"):
        time.sleep(0.05)
    browser.execute_script("for (const box of document.querySelectorAll('#chart-stress input')) box.click();"
                           "const slider = document.getElementById('film-strain'); slider.value = 400;"
                           "slider.dispatchEvent(new Event('input')); document.querySelector('.setting').scrollIntoView()")
    time.sleep(0.5)
    picture = Image.open(io.BytesIO(browser.get_screenshot_as_png())).convert("RGB")
    browser.quit()
picture.quantize(128).save(docs / "report.png", optimize=True)
