#!/usr/bin/env python3
"""Builds the documentation as a site that needs no network: neither to be built nor to be read.
Usage: docs/site/build.py REFERENCE_DIR OUT_DIR

OUT_DIR/pages   what it is made of: the pages and pictures of docs/, every page of REFERENCE_DIR, KaTeX
OUT_DIR/site    the site; open site/index.html"""
import shutil, subprocess, sys
from pathlib import Path

import yaml

docs = Path(__file__).resolve().parent.parent
config = docs.parent / ".mkdocs.yml"
katex = Path("/usr/share/javascript/katex")  # where Debian's libjs-katex has it


def copy(files, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for file in files:
        shutil.copy(file, folder)


def assemble(reference, pages):
    """@return the pages of the reference, by their place among the pages."""
    shutil.rmtree(pages, ignore_errors=True)
    copy([*docs.glob("*.md"), *docs.glob("*.png")], pages)
    copy([*docs.glob("site/*.js"), *docs.glob("site/*.css")], pages / "site")
    copy([katex / "katex.min.js", katex / "katex.min.css"], pages / "katex")
    copy(katex.glob("fonts/*.woff2"), pages / "katex/fonts")
    found = sorted(reference.glob("*.md"))
    copy(found, pages / "reference")
    return [f"reference/{page.name}" for page in found]


def write_config(out, reference):
    """That of the project, with the pages that only the assembled folder has."""
    nav = yaml.safe_load(config.read_text())["nav"]
    if reference:
        nav.append({"Reference": reference})
    here = {"INHERIT": str(config), "docs_dir": "pages", "site_dir": "site", "nav": nav}
    (out / "mkdocs.yml").write_text(yaml.safe_dump(here, sort_keys=False))


def main():
    reference, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    if not (katex / "katex.min.js").exists():
        sys.exit(f"{katex}: is not there; install libjs-katex (.ci/install-packages check)")
    pages = assemble(reference, out / "pages")
    write_config(out, pages)
    sys.exit(subprocess.run([sys.executable, "-m", "mkdocs", "build", "--strict", "--clean", "--quiet",
                             "--config-file", out / "mkdocs.yml"]).returncode)


main()
