"""Open what mesopix export writes with the programs it is meant for.

    check_export.py gmsh|calculix|vtk|pictures|imagej|memory MESOPIX [CCX, or IJ.JAR]

Leaves with 77 where that program is not installed.
"""
import csv
import importlib
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

SKIPPED = 77
PIXEL = 0.5  # [mm]
PHASES = {0: "void", 1: "aggregate", 2: "mortar", 4: "fly ash 2", 5: "Fly-ash 2"}
ROWS = ["2220", "1145", "2222"]  # labels, the top row first


def needed(module):
    try:
        return importlib.import_module(module)
    except ImportError as error:
        print(f"{module} is not installed: {error}")
        sys.exit(SKIPPED)


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert done.returncode == 0, f"{command}: {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout + done.stderr


def specimen(rows, phases=PHASES):
    """specimen.h5 with these labels and pixels of PIXEL."""
    lines = "\n".join(" ".join(row) for row in rows)
    pathlib.Path("labels.pgm").write_text(f"P2\n{len(rows[0])} {len(rows)}\n255\n{lines}\n")
    used = {int(label) for row in rows for label in row}
    names = ",".join(f"{label}:{name}" for label, name in phases.items() if label in used)
    run(mesopix, "convert", "labels.pgm", "--label-phases", names, "--pixel-size", f"{PIXEL} mm", "--itz-mode", "none",
        "-o", "specimen.h5")


def export(form, source="specimen.h5", *options):
    """Names of the files that were written."""
    said = run(mesopix, "export", source, "--to", form, *options)
    return [line.removeprefix("wrote ") for line in said.splitlines() if line.startswith("wrote ")]


def near(value, wanted, tolerance=1e-9):
    assert abs(value - wanted) <= tolerance * max(1e-300, abs(wanted)), f"{value}, not {wanted}"


def check_gmsh():
    gmsh = needed("gmsh")
    specimen(ROWS)
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.logger.start()
    gmsh.open(export("msh")[0])
    complaints = [line for line in gmsh.logger.get() if line.startswith(("Warning", "Error"))]
    assert not complaints, complaints
    groups = {gmsh.model.getPhysicalName(dim, tag): (dim, tag) for dim, tag in gmsh.model.getPhysicalGroups()}
    assert groups == {"BOTTOM": (1, 1), "RIGHT": (1, 2), "TOP": (1, 3), "LEFT": (1, 4), "aggregate": (2, 1),
                      "mortar": (2, 2), "fly ash 2": (2, 4), "Fly-ash 2": (2, 5)}, groups

    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    place = {int(tag): (coordinates[3 * k], coordinates[3 * k + 1]) for k, tag in enumerate(tags)}
    assert len(place) == 19  # of 4 x 5, all but the top right one
    elements = {}
    for dim, surface in gmsh.model.getEntities(2):
        (kind,), (numbers,), (nodes,) = gmsh.model.mesh.getElements(dim, surface)
        assert kind == 3, "quadrangles of four nodes"
        for k, number in enumerate(numbers):
            elements[int(number)] = surface, [place[int(node)] for node in nodes[4 * k:4 * k + 4]]
    assert len(elements) == 11
    d = 1e-3 * PIXEL
    number = 0
    for row, line in enumerate(ROWS):
        for col, label in enumerate(line):
            if label == "0":
                continue
            number += 1
            surface, corners = elements[number]
            assert surface == int(label), (row, col, surface)
            left, bottom = col * d, (len(ROWS) - 1 - row) * d
            wanted = [(left, bottom), (left + d, bottom), (left + d, bottom + d), (left, bottom + d)]
            assert all(math.dist(p, q) < 1e-12 for p, q in zip(corners, wanted)), (corners, wanted)
    edges = {"BOTTOM": [(c * d, 0) for c in range(5)], "RIGHT": [(4 * d, r * d) for r in range(3)],
             "TOP": [(c * d, 3 * d) for c in range(4)], "LEFT": [(0, r * d) for r in range(4)]}
    for name, wanted in edges.items():
        nodes, _ = gmsh.model.mesh.getNodesForPhysicalGroup(*groups[name])
        found = sorted(place[int(node)] for node in nodes)
        assert len(found) == len(wanted) and all(math.dist(p, q) < 1e-12 for p, q in zip(found, wanted)), (name, found)
    gmsh.finalize()


def solve(ccx, mesh, young, poisson, strain, height):
    """Pull the top edge; sum of the reactions there [N per m of thickness] and the stresses yy [Pa]."""
    deck = pathlib.Path(mesh).read_text()
    for phase, modulus in young.items():
        deck += f"*MATERIAL, NAME=M_{phase}\n*ELASTIC\n{modulus}, {poisson}\n"
        deck += f"*SOLID SECTION, ELSET={phase}, MATERIAL=M_{phase}\n1.\n"
    corner = next(line for line in deck.splitlines() if line.endswith(", 0, 0")).split(",")[0]
    deck += f"*BOUNDARY\nBOTTOM, 2, 2\n{corner}, 1, 1\n*STEP\n*STATIC\n*BOUNDARY\nTOP, 2, 2, {strain * height:.10g}\n"
    deck += "*NODE PRINT, NSET=TOP, TOTALS=ONLY\nRF\n"
    deck += "".join(f"*EL PRINT, ELSET={phase}\nS\n" for phase in young) + "*END STEP\n"
    pathlib.Path("job.inp").write_text(deck)
    said = run(ccx, "-i", "job")
    assert "Job finished" in said and "*WARNING" not in said and "*ERROR" not in said, said
    rows = [line.split() for line in pathlib.Path("job.dat").read_text().splitlines()]
    reaction = next(float(row[1]) for row in rows if len(row) == 3)
    return reaction, [float(row[3]) for row in rows if len(row) == 8]


def check_calculix(ccx):
    if not shutil.which(ccx):
        print("ccx is not installed")
        sys.exit(SKIPPED)
    strain, height = 1e-5, 6e-3 * PIXEL

    specimen(["22222222"] * 6)  # plane stress: E; plane strain: E / (1 - nu^2)
    for plane, stiffness in (("stress", 20e9), ("strain", 20e9 / (1 - 0.2**2))):  # as it is, with the default mortar
        shutil.copy(export("inp", "specimen.h5", "--plane", plane)[0], "job.inp")
        said = run(ccx, "-i", "job")
        assert "Job finished" in said and "*WARNING" not in said and "*ERROR" not in said, said
        rows = [line.split() for line in pathlib.Path("job.dat").read_text().splitlines()]
        near(next(float(row[1]) for row in rows if len(row) == 3), stiffness * 1e-4 * 8e-3 * PIXEL, 1e-5)
    for plane, stiffness in (("stress", 30e9), ("strain", 30e9 / (1 - 0.2**2))):
        mesh = export("inp", "specimen.h5", "--plane", plane, "--mesh-only")[0]
        reaction, stresses = solve(ccx, mesh, {"MORTAR": 30e9}, 0.2, strain, height)
        near(reaction, stiffness * strain * 8e-3 * PIXEL, 1e-5)
        assert len(stresses) >= 48
        for stress in stresses:
            near(stress, stiffness * strain, 1e-5)

    # Layers in series beside a void column, without Poisson's effect: the compliances add.
    specimen(["22222220"] * 2 + ["11111110"] * 1 + ["44444440"] * 3)
    stiffness = 6 / (2 / 20e9 + 1 / 70e9 + 3 / 40e9)
    mesh = export("inp", "specimen.h5", "--mesh-only")[0]
    reaction, stresses = solve(ccx, mesh, {"MORTAR": 20e9, "AGGREGATE": 70e9, "FLY_ASH_2": 40e9}, 0, strain, height)
    near(reaction, stiffness * strain * 7e-3 * PIXEL, 1e-5)
    for stress in stresses:
        near(stress, stiffness * strain, 1e-5)

    # A column beside much void: memory follows the largest number of an element, be there an element or not.
    edge = 1000
    specimen(["0" * (edge - 1) + "2"] * edge)
    export("inp")
    with subprocess.Popen([ccx, "-i", "specimen"], stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = status
    rows = [line.split() for line in pathlib.Path("specimen.dat").read_text().splitlines()]
    near(next(float(row[1]) for row in rows if len(row) == 3), 20e9 * 1e-4 * 1e-3 * PIXEL, 1e-5)
    assert status == 0 and usage.ru_maxrss < 150e3, f"ccx took {usage.ru_maxrss} kB"


def check_vtk():
    reader_module = needed("vtkmodules.vtkIOXML")
    specimen(ROWS)
    reader = reader_module.vtkXMLImageDataReader()
    reader.SetFileName(export("vti")[0])
    reader.Update()
    assert reader.GetErrorCode() == 0
    image = reader.GetOutput()
    assert image.GetExtent() == (0, 4, 0, 3, 0, 0), image.GetExtent()
    assert image.GetOrigin() == (0, 0, 0)
    for spacing in image.GetSpacing()[:2]:
        near(spacing, 1e-3 * PIXEL)
    phases = image.GetCellData().GetArray("phase")
    assert phases.GetDataTypeAsString() == "unsigned char" and phases.GetNumberOfTuples() == 12
    for row, line in enumerate(ROWS):
        for col, label in enumerate(line):
            centre = [(col + 0.5) * 5e-4, (len(ROWS) - row - 0.5) * 5e-4, 0]
            assert phases.GetValue(cell_at(image, centre)) == int(label), (row, col)
    names = image.GetFieldData().GetAbstractArray("phase_names")
    for label, name in PHASES.items():
        assert names.GetValue(label) == name, (label, names.GetValue(label))


def cell_at(image, point):
    """Number of the cell of VTK round a point."""
    place, weights = [0, 0, 0], [0.0, 0.0, 0.0]
    assert image.ComputeStructuredCoordinates(point, place, weights) == 1
    return image.ComputeCellId(place)


def check_pictures():
    image_module = needed("PIL.Image")
    specimen(ROWS)
    labels = [int(label) for row in ROWS for label in row]
    with image_module.open(export("png")[0]) as picture:
        assert picture.mode == "L" and picture.size == (4, 3) and list(picture.getdata()) == labels
        near(picture.info["dpi"][0], 25.4 / PIXEL, 1e-4)
    tif = export("tif")[0]
    with image_module.open(tif) as picture:
        assert picture.mode == "L" and list(picture.getdata()) == labels
        assert picture.tag_v2[296] == 1 and float(picture.tag_v2[282]) == float(picture.tag_v2[283]) == 1 / PIXEL
        assert picture.tag_v2[270].startswith("ImageJ=1.53t\nunit=mm\n")

    # Both are the specimen again, by the command that export tells.
    for form in ("png", "tif"):
        said = run(mesopix, "export", "specimen.h5", "--to", form)
        command = said.split("a specimen again: ")[1].splitlines()[0]
        back = f"{form}.h5"
        run("sh", "-c", command.replace("mesopix", mesopix, 1) + f" -o {back}")
        export("png", back)
        assert pathlib.Path(f"{form}_labels.png").read_bytes() == pathlib.Path("specimen_labels.png").read_bytes()


def generate():
    run(mesopix, "generate", "--width", "30 mm", "--height", "20 mm", "--pixel-size", f"{PIXEL} mm", "--fraction", 0.3,
        "--d-max", "8 mm", "--d-min", "3 mm", "--itz-mode", "none", "-o", "specimen.h5")


def check_imagej(jar):
    if not pathlib.Path(jar).is_file() or not shutil.which("java") or not shutil.which("xvfb-run"):
        print("imagej, java or xvfb is not installed")
        sys.exit(SKIPPED)
    image_module = needed("PIL.Image")
    generate()
    labels, = export("tif")
    rois, = export("roi")
    table, = export("csv")
    run(mesopix, "simulate", "specimen.h5", "-o", "run", "--stop-strain", 2e-4, "--mortar.tensile-scale", "4 MPa", "-q")
    damage, strain = export("tif", "run")
    here = pathlib.Path.cwd()
    pathlib.Path("look.ijm").write_text(f"""
        open("{here / labels}"); getPixelSize(unit, w, h); getMinAndMax(low, high);
        print("labels", getWidth(), getHeight(), bitDepth(), unit, w, h, low, high);
        roiManager("Open", "{here / rois}");
        for (i = 0; i < roiManager("count"); i++) {{
          roiManager("select", i); List.setMeasurements; getStatistics(area, mean);
          print("roi", Roi.getName, Roi.getType, area, mean, List.getValue("X"), List.getValue("Y"));
        }}
        open("{here / damage}"); getPixelSize(unit, w, h); getStatistics(area, mean, low, high, deviation, counts);
        print("damage", bitDepth(), unit, w, h, counts[0], counts[1], counts[2]);
        open("{here / strain}"); getPixelSize(unit, w, h); failed = 0; sum = 0;
        for (y = 0; y < getHeight(); y++) for (x = 0; x < getWidth(); x++) {{
          v = getPixel(x, y); if (!isNaN(v)) {{ failed++; sum = sum + 1e6 * v; }}
        }}
        print("strain", bitDepth(), unit, w, h, failed, sum);
        """)
    log = run("xvfb-run", "-a", "java", f"-Duser.home={here}", "-jar", jar, "-batch", here / "look.ijm")
    said = [line.split() for line in log.splitlines()]
    told = {words[0]: words[1:] for words in said if words}
    assert told["labels"] == ["60", "40", "8", "mm", "0.5", "0.5", "0", "2"], told["labels"]

    outlines = [words[1:] for words in said if words and words[0] == "roi"]
    inclusions = list(csv.DictReader(open(table, newline="")))
    assert len(outlines) == len(inclusions) > 5, outlines
    for (name, kind, area, mean, x, y), row in zip(outlines, inclusions):
        assert name == f"inclusion_{int(row['id']):04}" and kind == "polygon"
        assert float(mean) == 1, "pixels inside that are no aggregate"
        near(float(area), float(row["area_mm2"]), 0.1)  # ImageJ counts pixels
        assert math.dist((float(x), 20 - float(y)), (float(row["x_mm"]), float(row["y_mm"]))) < 0.4 * PIXEL

    figures = run(mesopix, "inspect", "run")
    words = figures.replace("\n", " ").split()
    tension, shear = int(words[words.index("tension") - 1]), int(words[words.index("shear") - 1])
    assert tension > 10, figures
    assert told["damage"] == ["8", "mm", "0.5", "0.5", str(2400 - tension - shear), str(tension), str(shear)], told
    with image_module.open(strain) as picture:
        strains = [value for value in picture.getdata() if not math.isnan(value)]
    assert len(strains) == tension + shear
    assert told["strain"][:5] == ["32", "mm", "0.5", "0.5", str(len(strains))], told["strain"]
    near(float(told["strain"][5]), 1e6 * sum(strains), 1e-3)


def check_memory():
    """Files much larger than what the program holds."""
    edge = 1300
    pathlib.Path("labels.pgm").write_bytes(f"P5\n{edge} {edge}\n255\n".encode() + b"\2\2\1\2" * (edge * edge // 4))
    run(mesopix, "convert", "labels.pgm", "--label-phases", "1:aggregate,2:mortar", "--pixel-size", f"{PIXEL} mm",
        "--itz-mode", "none", "-o", "specimen.h5")
    for form in ("inp", "msh"):
        with subprocess.Popen([mesopix, "export", "specimen.h5", "--to", form, "-q"]) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = status
        assert status == 0
        size = os.path.getsize(f"specimen.{form}")
        assert size > 90e6, size
        assert usage.ru_maxrss * 1024 < 0.8 * size, f"{usage.ru_maxrss} kB for a file of {size} bytes"


mesopix = str(pathlib.Path(sys.argv[2]).resolve())
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    {"gmsh": check_gmsh, "calculix": check_calculix, "vtk": check_vtk, "pictures": check_pictures,
     "imagej": check_imagej, "memory": check_memory}[sys.argv[1]](*sys.argv[3:])
    os.chdir("/")
