#!/usr/bin/env python3
"""Runs the commands of a page of the documentation in an empty folder that has only data/ and the program.
Usage: page_test.py SOURCE_DIR PAGE BIN_DIR WORK_DIR PYTHON_DIR

All ```sh blocks are run, in their order and in one shell, but for those under the line <!-- not run as a test: WHY -->;
of these, each command must at least be there: a script of ours, or the program and its options. After them all ```python
blocks are run, as one script. Every picture and page that is linked to must be there too."""
import itertools, os, re, shlex, shutil, subprocess, sys
from pathlib import Path

source, page = Path(sys.argv[1]), sys.argv[2]
programs, work, packages = (Path(argument).resolve() for argument in sys.argv[3:])
text = (source / page).read_text()
blocks = re.findall(r"(<!-- not run as a test: [^\n]+ -->\n)?```sh\n(.*?)```", text, re.S)
run = "".join(commands for excuse, commands in blocks if not excuse)
excused = "".join(commands for excuse, commands in blocks if excuse)
script = "".join(re.findall(r"```python\n(.*?)```", text, re.S))

for line in filter(None, (re.sub("#.*", "", line).strip() for line in excused.splitlines())):
    command, *words = shlex.split(line)
    if command == "mesopix":
        names = list(itertools.takewhile(lambda word: not word.startswith("-"), words))[:2]  # the second may be an argument
        known = subprocess.run([programs / "mesopix", *names, "--help"], capture_output=True, text=True, check=True).stdout
        for word in words:
            assert not word.startswith("--") or word.split("=")[0] in known, f"{page}: mesopix {words[0]} knows no {word}"
    elif command.startswith("./"):
        assert os.access(source / command, os.X_OK), f"{page}: {command} cannot be run"

for link in re.findall(r"\]\(([^)#]+)\)", text):
    assert link.startswith("http") or ((source / page).parent / link).exists(), f"{page}: {link} is not there"

assert "mesopix" in run + script, f"{page} shows no command of the program"
shutil.rmtree(work, ignore_errors=True)
(work / "build/release").mkdir(parents=True)
(work / "build/release/bin").symlink_to(programs)
if (source / "data").exists():
    shutil.copytree(source / "data", work / "data")
places = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", PYTHONPATH=str(packages), MPLBACKEND="Agg")
for command in (["bash", "-eux", "-c", run], [sys.executable, "-c", script]):
    if status := subprocess.run(command, cwd=work, env=places).returncode:
        sys.exit(status)
