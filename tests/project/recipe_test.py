#!/usr/bin/env python3
"""The recipes for other packagers: each can be read, and names a counterpart of every Debian package that the build takes.
Usage: recipe_test.py SOURCE_DIR

A line of a recipe that names a dependency ends with a comment: the Debian packages that it stands for. What has no
counterpart is named in the comment that begins with "Nothing stands for:"."""
import ast, re, subprocess, sys
from pathlib import Path

import yaml

root = Path(sys.argv[1])
install = root / ".ci/install-packages"


def debian(kind):
    """The packages that .ci/install-packages wants for a kind of work."""
    lists = "\n".join(re.findall(r"^\w+=\(.*?^\)$|^\w+=\([^)\n]*\)$", install.read_text(), re.M | re.S))
    words = {"build": '"${wanted[@]}"', "python": '"${wanted[@]}" "${python[@]}"'}[kind]
    said = subprocess.run(["bash", "-euc", f"{lists}\nprintf '%s\\n' {words}"], capture_output=True, text=True, check=True)
    return set(said.stdout.split())


def compare(name, text, wanted, dependencies):
    """dependencies: [(the dependency, the comment behind it)]."""
    excused = set(re.findall(r"[\w+.-]+", re.search(r"# Nothing stands for: (.*(?:\n# .*)*)", text)[1])) & wanted
    met = {package for _, comment in dependencies for package in comment.split()}
    nameless = [dependency for dependency, comment in dependencies if not comment]
    assert not nameless, f"{name}: no Debian package is named behind {nameless}"
    assert wanted - excused == met, (f"{name}: has nothing for {sorted(wanted - excused - met)}, and "
                                     f"{sorted(met - wanted | met & excused)} is not wanted")
    assert len(excused) < 5 and len(met) > 15, f"{name}: {len(met)} packages have a counterpart, {len(excused)} have none"
    print(f"{name}: counterparts of {len(met)} Debian packages; none for {' '.join(sorted(excused))}")


def conda():
    text = (root / ".packaging/conda/meta.yaml").read_text()
    values = dict(re.findall(r'{% set (\w+) = "(.*?)" %}', text))
    plain = re.sub(r"{%.*?%}\n", "", text)
    plain = re.sub(r'{{ (\w+)\("(\w+)"\) }}', r"\1_\2", plain)
    plain = re.sub(r"{{ (\w+) }}", lambda found: values[found[1]], plain)
    recipe = yaml.safe_load(plain)
    listed = [dependency for part in recipe["requirements"].values() for dependency in part]
    section = plain.split("requirements:")[1].split("\ntest:")[0]
    lines = re.findall(r"^    - (.*?) *(?:# (.*))?$", section, re.M)
    assert [name for name, _ in lines] == listed, f"the lines are not those that YAML has: {lines}, {listed}"
    compare(".packaging/conda/meta.yaml", text, debian("python"), lines)
    assert (root / ".packaging/conda" / recipe["source"]["path"]).resolve() == root.resolve(), recipe["source"]
    assert (root / recipe["about"]["license_file"]).exists()


def spack():
    text = (root / ".packaging/spack/package.py").read_text()
    recipe = next(node for node in ast.parse(text).body if isinstance(node, ast.ClassDef))
    calls = [node.value for node in recipe.body if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call)]
    listed = [call.args[0].value for call in calls if call.func.id == "depends_on"]
    lines = re.findall(r'^    depends_on\("(.*?)".*?\) *(?:# (.*))?$', text, re.M)
    assert [name for name, _ in lines] == listed, f"the lines are not those that Python has: {lines}, {listed}"
    compare(".packaging/spack/package.py", text, debian("build"), lines)


conda()
spack()
