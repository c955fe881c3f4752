#!/usr/bin/env python3
"""Runs the commands of README.md in an empty folder that has only data/ and the program.
Usage: readme_test.py SOURCE_DIR BIN_DIR WORK_DIR

All ```sh blocks are run, in their order and in one shell, but for those under the line <!-- not run as a test: WHY -->;
of these, each command must at least be there."""
import os, re, shutil, subprocess, sys
from pathlib import Path

source, programs, work = map(Path, sys.argv[1:])
text = (source / "README.md").read_text()
blocks = re.findall(r"(<!-- not run as a test: .+ -->\n)?```sh\n(.*?)```", text, re.S)
run = "".join(commands for excuse, commands in blocks if not excuse)
excused = "".join(commands for excuse, commands in blocks if excuse)

for line in filter(None, (re.sub("#.*", "", line).strip() for line in excused.splitlines())):
    command = source / line.split()[0]
    assert os.access(command, os.X_OK), f"README.md: {command} cannot be run"

assert "mesopix" in run, "README.md shows no command of the program"
shutil.rmtree(work, ignore_errors=True)
(work / "build/release").mkdir(parents=True)
(work / "build/release/bin").symlink_to(programs)
if (source / "data").exists():
    shutil.copytree(source / "data", work / "data")
sys.exit(subprocess.run(["bash", "-eux", "-c", run], cwd=work).returncode)
