"""Check a run folder: report.html and the charts in it are well-formed, self-contained and escaped.

    check_report.py FOLDER [--hostile]
"""
import base64
import hashlib
import html
import json
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser

VOID = {"meta", "img", "input", "br", "link", "hr"}
ALLOWED = {"html", "head", "meta", "title", "style", "body", "main", "header", "section", "aside", "h1", "h2", "h3", "p",
           "div", "span", "i", "b", "br", "ul", "li", "table", "thead", "tbody", "tr", "th", "td", "figure",
           "figcaption", "img", "input", "label", "details", "summary", "pre", "blockquote", "svg", "polyline",
           "circle", "text", "canvas", "button", "dl", "dt", "dd", "select", "option", "output", "script"}


class Page(HTMLParser):
    """Collects elements, and complains about tags that do not nest."""

    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.open, self.seen, self.words = [], [], []

    def handle_starttag(self, tag, attrs):
        self.seen.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.seen.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-1:]} at {self.getpos()}"
        self.open.pop()

    def handle_data(self, data):
        self.words.append(data)


def check_elements(seen):
    for tag, attributes in seen:
        assert tag in ALLOWED, f"<{tag}> has no place in the report"
        for name, value in attributes.items():
            assert not name.startswith("on"), f"{tag} has the handler {name}"
            assert not (value or "").lower().startswith("javascript:"), f"{tag} {name}"
        if tag == "img":
            kind, data = attributes["src"].split(",", 1)
            assert kind == "data:image/png;base64" and attributes["alt"], attributes["alt"]
            png = base64.b64decode(data, validate=True)
            assert png.startswith(b"\x89PNG\r\n\x1a\n") and png.endswith(b"IEND\xaeB`\x82")
        assert "href" not in attributes, f"{tag} points elsewhere"


def check_ids(seen):
    ids = [attributes["id"] for _, attributes in seen if "id" in attributes]
    assert len(ids) == len(set(ids)), f"ids come twice: {ids}"
    for tag, attributes in seen:
        if tag == "label":
            assert attributes["for"] in ids


def check_scripts(text, seen):
    """The data, which no browser runs, and one script, which is that of the policy."""
    scripts = [attributes for tag, attributes in seen if tag == "script"]
    assert scripts == [{"type": "application/json", "id": "data"}, {}], scripts
    policy = next(a["content"] for tag, a in seen if a.get("http-equiv") == "Content-Security-Policy")
    script = text.rsplit("<script>", 1)[1].split("</script>", 1)[0]
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    assert policy.endswith(f"; script-src 'sha256-{digest}'"), policy
    json.loads(text.split('id="data">', 1)[1].split("</script>", 1)[0])


def check_glossary(text):
    """Every term is one of docs/glossary.md, in the same words."""
    told = re.findall(r"<dt>(.*?)</dt>\n<dd>(.*?)</dd>", text)
    assert len(told) == 18, told  # as many as apps/report/glossary.cpp wants
    page = pathlib.Path(__file__).resolve().parents[2] / "docs/glossary.md"
    known = dict(re.findall(r"^\| (.+?) \| (.+?) \|$", page.read_text(encoding="utf-8").replace("`", ""), re.M))
    for term, meaning in told:
        assert known.get(html.unescape(term)) == html.unescape(meaning), f"docs/glossary.md says otherwise: {term}"


def check_charts(text):
    root = ElementTree.fromstring(text.split("\n", 1)[1])
    charts = list(root.iter("{http://www.w3.org/2000/svg}svg"))
    assert len(charts) in (8, 10), f"{len(charts)} charts"  # each twice; there may be no sieve curve
    for chart in charts:
        _, _, width, height = map(float, chart.get("viewBox").split())
        assert chart.get("aria-label")
        lines = chart.findall("{http://www.w3.org/2000/svg}polyline")
        assert lines
        for line in lines:
            for place in line.get("points").split():
                x, y = map(float, place.split(","))
                assert 0 <= x <= width and 0 <= y <= height, place


def main():
    folder = pathlib.Path(sys.argv[1])
    text = (folder / "report.html").read_text(encoding="utf-8")
    page = Page()
    page.feed(text)
    page.close()
    assert not page.open, f"never closed: {page.open}"
    check_elements(page.seen)
    check_ids(page.seen)
    check_charts(text)
    check_glossary(text)
    check_scripts(text, page.seen)
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    assert summary["title"] in "".join(page.words)
    if "--hostile" in sys.argv:
        assert summary["title"] == "</script><script>alert(1)</script>"
        assert "<img src=x onerror=alert(1)>" in "".join(page.words)


main()
