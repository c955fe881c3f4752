"""The annotations hold, and the stub tells the truth about what was compiled."""
import ast, os, subprocess, sys, tempfile, unittest
import mesopix
from mesopix import _core

PACKAGE = os.path.dirname(mesopix.__file__)


cache = tempfile.TemporaryDirectory()


def mypy(*words):
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", cache.name, *words],
                          cwd=os.path.dirname(PACKAGE), capture_output=True, text=True)
    return done.stdout + done.stderr


class Typing(unittest.TestCase):
    def test_the_package_is_sound(self):
        self.assertIn("Success", mypy("-p", "mesopix"))

    def test_callers_are_told_of_their_mistakes(self):
        lines = ("result = mesopix.simulate('scene.toml', {'loading.velocity': 0.1}, seed=3, stop_drop='20 %')",
                 "first: float = result.curve.stress[0]",
                 "result.save(folder='run')",
                 "result.peak_strian",
                 "mesopix.simulate(3.5)",
                 "mesopix.simulate('a.h5', progress=lambda p: p.strian)")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "caller.py")
            with open(path, "w") as caller:
                caller.write("import mesopix\n" + "\n".join(lines) + "\n")
            told = mypy(path)
        wrong = {int(line.split(":")[1]) - 2 for line in told.splitlines() if ": error:" in line}
        self.assertEqual(wrong, {3, 4, 5}, told)

    def test_the_stub_has_what_was_compiled_and_no_more(self):
        with open(os.path.join(PACKAGE, "_core.pyi")) as stub:
            tree = ast.parse(stub.read())

        def names(body):
            return {getattr(node, "name", None) or node.target.id for node in body
                    if isinstance(node, (ast.FunctionDef, ast.ClassDef, ast.AnnAssign))}

        def public(thing):
            return {name for name in vars(thing) if not name.startswith("_") or name == "_repr_png_"}

        self.assertEqual(names(tree.body), public(_core))
        for node in tree.body:
            if isinstance(node, ast.ClassDef):
                self.assertEqual(names(node.body), public(getattr(_core, node.name)), node.name)

    def test_everything_public_says_what_it_is(self):
        for name in mesopix.__all__:
            self.assertTrue(getattr(mesopix, name).__doc__, name)
        for kind in (mesopix.Specimen, mesopix.Result, mesopix.Calibration):
            for name, member in vars(kind).items():
                if not name.startswith("_"):
                    self.assertTrue(member.__doc__, f"{kind.__name__}.{name}")


if __name__ == "__main__":
    unittest.main()
