"""Small runs of every command that writes, for the tests of disks that fail.

To add one: its name, its arguments in a folder with the files of prepare(), and what it writes there."""
import subprocess
from dataclasses import dataclass

SCENE = """[generate]
width = "20 mm"
height = "20 mm"
pixel_size = "1 mm"
fraction = 0.3
d_min = "4 mm"
d_max = "6 mm"
[solver]
threads = 1
"""


@dataclass(frozen=True)
class Command:
    arguments: str
    writes: tuple  # names of files and folders
    each_alone: bool = False  # whether every file is tried, whatever became of those before it
    spare: str = ""  # a folder whose files the run may do without, and end well
    first: tuple = ()  # files without which the run does not begin
    anew: bool = False  # whether it first removes what an earlier run has left in the same folder


COMMANDS = {
    "generate": Command("generate scene.toml -o made.h5", ("made.h5", "made_preview.png")),
    "generate labels": Command("generate scene.toml -o made.png", ("made.png",)),
    "convert": Command("convert labels.png --width 20mm --itz-mode none -o cut.h5", ("cut.h5", "cut_preview.png")),
    "simulate": Command("simulate scene.toml -o run --frames 2", ("run",), True, first=("run/in_progress.lock",)),
    "simulate again": Command("simulate scene.toml -o first --overwrite --seed 2", ("first",), True,
                              first=("first/in_progress.lock", "first/scene.toml", "first/specimen.h5"), anew=True),
    "simulate moving": Command("simulate scene.toml -o moving --kinematics moving --stop-strain 1e-4", ("moving",), True,
                               first=("moving/in_progress.lock",)),
    "simulate checkpoints": Command("simulate scene.toml -o kept --checkpoint-every 1ms", ("kept",), True,
                                    "kept/checkpoints", ("kept/in_progress.lock", "kept/scene.toml", "kept/specimen.h5")),
    "calibrate": Command("calibrate scene.toml --peak-stress 4.5MPa --seeds 1"
                         " -o fitted", ("fitted",), True),
    "study": Command("study study.toml -o members --jobs 1", ("members",)),
    "scene init": Command("scene init begun.toml --schema begun.json", ("begun.json", "begun.toml")),
    "stiffness": Command("stiffness specimen.h5 -o stiffness.json", ("stiffness.json",)),
    "twin": Command("twin specimen.h5 -n 2 -o twins", ("twins",)),
    "report": Command("report first second -o both.html", ("both.html",)),
    "report again": Command("report first", ("first",), True, first=("first/in_progress.lock",)),
    "plot damage": Command("plot first -o damage.pdf", ("damage.pdf",)),
    "plot stress": Command("plot first --what stress -o stress.png", ("stress.png",)),
    "plot curve": Command("plot first --what curve -o curve.svg", ("curve.svg",)),
    "export run": Command("export first --to tif -o maps", ("maps",)),
    **{f"export {kind}": Command(f"export specimen.h5 --to {kind} -o out{ending}", (f"out{ending}",))
       for kind, ending in [("inp", ".inp"), ("msh", ".msh"), ("vti", ".vti"), ("png", ".png"), ("tif", ".tif"),
                            ("csv", ".csv"), ("roi", ".zip")]},
}


def arguments_of(command):
    # A space that stands in a value is written without it: "20mm" is "20 mm" to the program.
    return command.arguments.split()


def prepare(mesopix, folder):
    """What the commands read: a scene, a specimen, its labels, two runs of which one has frames."""
    (folder / "scene.toml").write_text(SCENE)
    (folder / "study.toml").write_text('scene = "scene.toml"\nseeds = 2\n')
    for line in ("generate scene.toml -o specimen.h5", "generate scene.toml -o labels.png",
                 "simulate specimen.h5 -o first --frames 2", "simulate specimen.h5 -o second --seed 2"):
        subprocess.run([mesopix, *line.split()], cwd=folder, check=True, capture_output=True)
