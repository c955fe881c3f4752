#!/usr/bin/env python3
"""Builds the site of the documentation and reads it as a browser does, without a network: no link is dead, every page is in
the navigation, nothing is fetched from elsewhere, every equation renders, and no page is wider than a phone.
Usage: site_test.py SOURCE_DIR REFERENCE_DIR WORK_DIR"""
import re, subprocess, sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from selenium import webdriver

source, reference, work = (Path(argument).resolve() for argument in sys.argv[1:])
subprocess.run([sys.executable, source / "docs/site/build.py", reference, work], check=True)
site = work / "site"


class Page(HTMLParser):
    """What a page links to, fetches, and can be linked to."""

    def __init__(self, path):
        super().__init__()
        self.links, self.fetched, self.anchors = [], [], set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors.update(given[key] for key in ("id", "name") if given.get(key))
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        if tag == "link" and given.get("rel") != "canonical":
            self.fetched.append(given["href"])
        self.fetched += [given["src"]] if given.get("src") else []


pages = {path: Page(path) for path in site.rglob("*.html") if path.name != "404.html"}
faults = []
for path, page in pages.items():
    for link in page.links + page.fetched:
        parts = urlsplit(link)
        if parts.scheme in ("http", "https", "mailto"):
            if link in page.fetched:
                faults.append(f"{path.name}: fetches {link}")
            continue
        target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
        if not target.is_file():
            faults.append(f"{path.name}: {link} is not there")
        elif parts.fragment and parts.fragment not in pages[target].anchors and not parts.fragment.startswith("__"):
            faults.append(f"{path.name}: {link}: there is no such heading")

told = {path.relative_to(work / "pages").with_suffix(".html") for path in (work / "pages").rglob("*.md")}
linked = {(site / unquote(urlsplit(link).path)).resolve() for link in pages[site / "index.html"].links if not urlsplit(link).scheme}
faults += [f"{page}: is not in the navigation" for page in told if (site / page).resolve() not in linked]
assert told >= {path.relative_to(source / "docs").with_suffix(".html") for path in (source / "docs").glob("*.md")}

# What GitHub takes for markup before it takes it for an equation.
dangers = {"a backslash before punctuation": r"\\[^a-zA-Z\s]", "an underscore that may begin emphasis": r"[^a-zA-Z0-9\s\\]_[a-zA-Z0-9]",
           "a < that may begin a tag": r"<", "an asterisk": r"\*(?!\})"}
equations = 0
for path in (source / "docs").glob("*.md"):
    text = re.sub(r"```.*?```|`[^`\n]+`", "", path.read_text(), flags=re.S)
    blocks = re.findall(r"^\$\$\n(.*?)\n\$\$$", text, re.S | re.M)
    inline = re.findall(r"\$([^$\n]+)\$", re.sub(r"^\$\$\n.*?\n\$\$$", "", text, flags=re.S | re.M))
    equations += len(blocks) + len(inline)
    faults += [f"{path.name}: ${one}$: blanks at an end" for one in inline if one != one.strip()]
    faults += [f"{path.name}: ${one}$: {what}" for one in inline for what, danger in dangers.items() if re.search(danger, one)]
    faults += [f"{path.name}: {one}: two backslashes" for one in blocks if "\\\\" in one]

# Files and functions of the sources that pages name; those of the examples in contributing.md are none.
sources = {str(path.relative_to(source)): path for folder in ("specimen", "libmpm", "apps", "tests", "docs", "data")
           for path in (source / folder).rglob("*") if path.is_file() and path.suffix != ".pyc"}
code = "".join(path.read_text() for name, path in sources.items() if name.endswith((".cpp", ".hpp")))
named = 0
for page in ("contributing", "theory"):
    for one in re.findall(r"`([^`\n]+)`", (source / "docs" / f"{page}.md").read_text()):
        if re.search("farbfeld|point_table", one):
            continue
        if re.fullmatch(r"[\w/*]+\.(cpp|hpp|py)", one):
            pattern = re.compile("(.*/)?" + re.escape(one).replace(r"\*", "[^/]*"))
            faults += [] if any(pattern.fullmatch(name) for name in sources) else [f"{page}.md: {one}: there is no such file"]
            named += 1
        elif call := re.fullmatch(r"(?:\w+::)?(\w+)\(\)", one):
            faults += [] if re.search(rf"\b{call[1]}\(", code) else [f"{page}.md: {one}: there is no such function"]
            named += 1
assert named > 80, f"{named} names of the sources"
assert not faults, "\n".join(faults)

options = webdriver.ChromeOptions()
options.binary_location = "/usr/bin/chromium"
for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
    options.add_argument(argument)
options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
driver = webdriver.Chrome(service=webdriver.chrome.service.Service("/usr/bin/chromedriver"), options=options)
rendered = 0
try:
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": 390, "height": 900, "deviceScaleFactor": 1, "mobile": True})
    for path in pages:
        driver.get(path.as_uri())
        there, made, wrong, wide, broken, asked = driver.execute_script("""
            const all = [...document.querySelectorAll(".arithmatex")];
            return [all.length, all.filter(one => one.querySelector(".katex-html")).length,
                    [...document.querySelectorAll(".katex-error")].map(one => one.title),
                    document.documentElement.scrollWidth,
                    [...document.images].filter(one => !one.complete || !one.naturalWidth).map(one => one.src),
                    performance.getEntriesByType("resource").map(one => one.name).filter(one => !one.startsWith("file:") && !one.startsWith("data:"))]""")
        assert there == made and not wrong, f"{path.name}: {made} of {there} equations render: {wrong}"
        assert wide <= 390, f"{path.name}: {wide} pixels wide on a phone of 390"
        assert not broken and not asked, f"{path.name}: does not show {broken}, asks for {asked}"
        rendered += made
        said = driver.get_log("browser")
        assert not said, f"{path.name}: the console says: {said}"
finally:
    driver.quit()
assert rendered == equations > 100, f"{rendered} of {equations} equations"
print(f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links, {rendered} equations")
