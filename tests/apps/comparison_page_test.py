"""Lays two runs over each other with the program, and reads the page in headless Chromium.

    comparison_page_test.py MESOPIX FOLDER FOLDER
"""
import io
import json
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image
from selenium.webdriver.common.by import By

from report_page_test import Browser


def main():
    mesopix, *folders = sys.argv[1:]
    peaks = [json.loads((pathlib.Path(folder) / "summary.json").read_text())["peak_stress_Pa"] for folder in folders]
    with tempfile.TemporaryDirectory() as scratch:
        page = pathlib.Path(scratch) / "comparison.html"
        subprocess.run([mesopix, "report", *folders, "-o", str(page)], check=True)
        browser = Browser(page.as_uri(), pathlib.Path(scratch))
        try:
            rows = browser.driver.find_elements(By.CSS_SELECTOR, "table.numbers tr")
            first = next(row.text for row in rows if row.text.startswith("Peak stress"))
            for peak in peaks:
                assert f"{peak / 1e6:.3g}" in first, first
            data = browser.run("JSON.parse(document.getElementById('data').textContent)")
            series = data["charts"]["stress"]["series"]
            for one, peak in zip(series, peaks, strict=True):
                assert abs(max(one["y"]) / (peak / 1e6) - 1) < 1e-3, (max(one["y"]), peak)
            legend = browser.driver.find_element(By.CSS_SELECTOR, "#chart-stress .u-legend").text
            assert all(one["name"] in legend for one in series), legend
            picture = browser.saved("curve.png", browser.button("Save as PNG").click)
            assert Image.open(io.BytesIO(picture)).width > 300
            assert len(browser.driver.find_elements(By.TAG_NAME, "button")) == 1  # no table to save, and no film
            said = browser.driver.get_log("browser")
            assert not said, f"the console says: {said}"
        finally:
            browser.driver.quit()


main()
