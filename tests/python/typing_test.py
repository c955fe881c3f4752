"""The annotations hold, and the stub tells the truth about what was compiled."""
import ast, os, subprocess, sys, tempfile, unittest
import mesopix
from mesopix import _core

PACKAGE = os.path.dirname(mesopix.__file__)


#: Right and wrong callers; the wrong ones are the last three.
CALLER = """import mesopix
result = mesopix.simulate("scene.toml", {"loading.velocity": 0.1}, seed=3, stop_drop="20 %")
first: float = result.curve.stress[0]
result.save(folder="run")
result.peak_strian
mesopix.simulate(3.5)
mesopix.simulate("a.h5", progress=lambda p: p.strian)
"""


class Typing(unittest.TestCase):
    def test_annotations_are_sound_and_tell_callers_of_their_mistakes(self):
        with tempfile.TemporaryDirectory() as folder:
            caller = os.path.join(folder, "caller.py")
            with open(caller, "w") as file:
                file.write(CALLER)
            told = subprocess.run(
                [sys.executable, "-m", "mypy", "--strict", "--cache-dir", os.devnull, os.path.basename(PACKAGE), caller],
                cwd=os.path.dirname(PACKAGE), capture_output=True, text=True).stdout
        errors = [line for line in told.splitlines() if ": error:" in line]
        self.assertEqual(["caller.py:5", "caller.py:6", "caller.py:7"],
                         [os.path.basename(error.split(": error:")[0]) for error in errors], told)

    def test_the_stub_has_what_was_compiled_and_no_more(self):
        with open(os.path.join(PACKAGE, "_core.pyi")) as stub:
            tree = ast.parse(stub.read())

        def names(body):
            return {getattr(node, "name", None) or node.target.id for node in body
                    if isinstance(node, (ast.FunctionDef, ast.ClassDef, ast.AnnAssign))}

        def public(thing):
            return {name for name in vars(thing) if not name.startswith("_") or name in {"_repr_png_", "__len__", "__getitem__"}}

        self.assertEqual(names(tree.body), public(_core))
        for node in tree.body:
            if isinstance(node, ast.ClassDef):
                self.assertEqual(names(node.body), public(getattr(_core, node.name)), node.name)

    def test_everything_public_says_what_it_is(self):
        for name in mesopix.__all__:
            self.assertTrue(getattr(mesopix, name).__doc__, name)
        for kind in (mesopix.Specimen, mesopix.Result, mesopix.Calibration, mesopix.Study, mesopix.Twins):
            for name, member in vars(kind).items():
                if not name.startswith("_"):
                    self.assertTrue(member.__doc__, f"{kind.__name__}.{name}")


if __name__ == "__main__":
    unittest.main()
