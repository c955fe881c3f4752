"""pip install . into a new environment, without a network. Usage: install_test.py SOURCE_DIR BUILD_DIR

Takes what is compiled in the build folder, which must be of this Python."""
import subprocess, sys, tempfile
from pathlib import Path

source, build = sys.argv[1:]
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", f"{folder}/env"], check=True)
    python = f"{folder}/env/bin/python"
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index", "--no-cache-dir", "--no-build-isolation",
                    "--config-settings", f"build={build}", source], check=True)
    code = "import mesopix; print(mesopix.__file__); print(mesopix.generate(fraction=0, width=0.05, height=0.05))"
    file, specimen = subprocess.run(
        [python, "-c", code], cwd=folder, check=True, capture_output=True, text=True).stdout.splitlines()
    assert Path(file).is_relative_to(folder), f"{file} is not the one that was installed"
    assert "100 x 100 pixels" in specimen, specimen
    assert (Path(file).parent / "py.typed").exists() and (Path(file).parent / "_core.pyi").exists()
