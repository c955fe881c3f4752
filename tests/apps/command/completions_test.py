#!/usr/bin/env python3
"""What the shells themselves complete. Usage: completions_test.py bash|zsh|fish MESOPIX

Exits with 77, which skips, where the shell is not installed."""
import os, re, select, shlex, shutil, subprocess, sys, tempfile, time
from pathlib import Path

shell, program = sys.argv[1], Path(sys.argv[2]).resolve()
completions = Path(__file__).resolve().parents[3] / "apps/command/completions"
os.environ["PATH"] = f"{program.parent}:{os.environ['PATH']}"
if shutil.which(shell) is None:
    print(f"{shell} is not installed")
    sys.exit(77)

# A line with the cursor at its end, what must be among the completions, and what must not.
cases = [
    ("mesopix ", {"generate", "simulate", "study", "help"}, {"submit", "specimen.h5"}),
    ("mesopix sim", {"simulate"}, {"generate"}),
    ("mesopix study ", {"submit", "status", "collect", "study.toml"}, {"generate", "specimen.h5"}),
    ("mesopix study submit --s", {"--slurm", "--sbatch"}, {"--jobs", "--frames"}),
    ("mesopix simulate --pl", {"--platen", "--plane"}, {"--velocity"}),
    ("mesopix simulate --platen ", {"smooth", "rough"}, {"specimen.h5"}),
    ("mesopix simulate --platen r", {"rough"}, {"smooth"}),
    ("mesopix simulate --loading.platen ", {"smooth", "rough"}, {"specimen.h5"}),
    ("mesopix simulate --mortar.y", {"--mortar.young"}, {"--itz.young"}),
    ("mesopix simulate --set loading.pl", {"loading.platen="}, {"loading.velocity="}),
    ("mesopix simulate --velocity ", set(), {"specimen.h5", "smooth", "picture.png", "--output"}),
    ("mesopix simulate ", {"specimen.h5", "study.toml", "picture.png"}, {"table.csv"}),
    ("mesopix simulate specimen.h5 -o ", {"runs/"}, {"specimen.h5"}),
    ("mesopix calibrate --target ", {"table.csv"}, {"specimen.h5"}),
    ("mesopix calibrate ", {"study.toml"}, {"picture.png"}),
    ("mesopix plot runs --what ", {"damage", "stress", "curve"}, {"runs/"}),
    ("mesopix help sim", {"simulate"}, {"generate"}),
]
# Of these each shell shows another part.
in_one_word = [
    ("mesopix simulate --platen=r", {"rough"}, {"smooth"}),
    ("mesopix simulate --platen=", {"smooth", "rough"}, {"specimen.h5"}),
    ("mesopix simulate --set loading.platen=", {"smooth", "rough"}, {"specimen.h5"}),
    ("mesopix simulate --set loading.platen=r", {"rough"}, {"smooth"}),
    ("mesopix calibrate --target=", {"table.csv"}, {"specimen.h5"}),
    ("mesopix simulate --output=", {"runs/"}, {"specimen.h5"}),
]
files = ("specimen.h5", "study.toml", "picture.png", "table.csv")


def bash(line):
    words = [word for word in re.split(r"([=:])|\s", line) if word]  # as readline splits it
    if line.endswith(" "):
        words.append("")
    script = (f"source {shlex.quote(str(completions / 'mesopix.bash'))}; COMP_WORDS=({' '.join(map(shlex.quote, words))}); "
              f"COMP_CWORD={len(words) - 1}; _mesopix; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    done = subprocess.run(["bash", "--norc", "-c", script], capture_output=True, text=True, check=True)
    assert not done.stderr, done.stderr
    # Readline itself puts a slash behind a folder.
    return {word + "/" if Path(word).is_dir() else word for word in done.stdout.split("\n")}


def fish(line):
    script = f"source {shlex.quote(str(completions / 'mesopix.fish'))}; complete -C {shlex.quote(line)}"
    done = subprocess.run(["fish", "--no-config", "-c", script], capture_output=True, text=True, check=True)
    assert not done.stderr, done.stderr
    return {word.split("\t")[0] for word in done.stdout.split("\n")}


class Zsh:
    """A shell before a terminal; a key writes what would be completed into a file."""
    setup = """
PS1= PS2=
fpath=({completions} $fpath)
autoload -Uz compinit && compinit -D -u
compadd() {{
  local -a found
  [[ ${{@[(I)-[a-zA-Z]#[OAD]]}} -gt 0 ]] || {{
    builtin compadd -O found "$@"
    local -i suffix=${{@[(I)-S]}}
    local -a end; (( suffix )) && end=${{@[suffix + 1]}}
    print -rl -- $^found${{end:-}} >> {found}
  }}
  builtin compadd "$@"
}}
capture() {{ _main_complete; compstate[insert]= compstate[list]=; print -- '#' >> {found}; }}
zle -C capture complete-word capture
bindkey '^T' capture
print '#' >> {found}
"""

    def __init__(self, folder):
        self.found = folder / "found"
        (folder / "setup").write_text(self.setup.format(completions=shlex.quote(str(completions)), found=self.found))
        process, self.terminal = os.forkpty()
        if process == 0:
            os.execvpe("zsh", ["zsh", "-f", "-i"], dict(os.environ, TERM="dumb"))
        self.write(f"source {folder / 'setup'}\n")
        self.read()

    def write(self, text):
        os.write(self.terminal, text.encode())

    def read(self):
        end = time.monotonic() + 60
        while not self.found.exists() or not self.found.read_text().endswith("#\n"):
            if select.select([self.terminal], [], [], 0.05)[0]:
                os.read(self.terminal, 65536)
            assert time.monotonic() < end, "zsh says nothing"
        found = self.found.read_text().split("\n")
        self.found.unlink()
        return {word + "/" if Path(word).is_dir() else word for word in found}

    def __call__(self, line):
        self.write("\x15" + line + "\x14")  # on an empty line
        return self.read()


with tempfile.TemporaryDirectory() as name:
    os.chdir(name)
    os.environ["HOME"] = name
    Path("runs").mkdir()
    for file in files:
        Path(file).touch()
    (hidden := Path(name) / ".setup").mkdir()
    complete = Zsh(hidden) if shell == "zsh" else {"bash": bash, "fish": fish}[shell]
    failures = 0
    for line, wanted, unwanted in cases + in_one_word:
        found = complete(line)
        if (line, wanted, unwanted) in in_one_word:
            found = {word.rpartition("=")[2] for word in found}
        if wanted - found or unwanted & found:
            failures += 1
            print(f"{line!r}: lacks {sorted(wanted - found)}, has {sorted(unwanted & found)}; all: {sorted(found)}")
print(f"{len(cases) + len(in_one_word)} lines, {failures} completed as they should not be")
sys.exit(failures > 0)
