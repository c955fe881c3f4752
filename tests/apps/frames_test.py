#!/usr/bin/env python3
"""Runs the program and opens its frames with VTK and h5py, as ParaView would.   frames_test.py MESOPIX

Every .hdf is read by vtkHDFReader and h5py, frames.hdf.series as JSON, frames.xdmf by both of VTK's readers of XDMF;
numbers are compared with each other, with curve.csv and with result.h5."""
import csv, json, os, signal, subprocess, sys, tempfile, time
from pathlib import Path

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOHDF import vtkHDFReader
from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
from vtkmodules.vtkIOXdmf3 import vtkXdmf3Reader

mesopix = Path(sys.argv[1]).resolve()
UNITS = {"displacement": "m", "velocity": "m/s", "stress": "Pa", "damage": "1", "phase": "1", "id": "1"}
TYPES = {"displacement": "f4", "velocity": "f4", "stress": "f4", "damage": "f4", "phase": "u1", "id": "i4"}
WIDTHS = {"displacement": 3, "velocity": 3, "stress": 9, "damage": 1, "phase": 1, "id": 1}

SCENE = """[generate]
width = "20 mm"
height = "20 mm"
pixel_size = "1 mm"
fraction = 0.3
d_min = "4 mm"
d_max = "6 mm"
"""


def run(folder, *options, code=0, source="scene.toml"):
    done = subprocess.run([mesopix, "simulate", source, "-o", folder, "--overwrite", *options],
                          capture_output=True, text=True)
    assert done.returncode == code, f"exit code {done.returncode}, not {code}: {done.stderr}"
    return done.stderr


def arrays(grid):
    data = grid.GetPointData()
    found = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    found["Points"] = vtk_to_numpy(grid.GetPoints().GetData())
    return found


def read_hdf(path):
    reader = vtkHDFReader()
    assert reader.CanReadFile(str(path)), f"VTK does not know {path}"
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutputDataObject(0)
    assert grid.GetClassName() == "vtkUnstructuredGrid"
    field = grid.GetFieldData()
    values = {field.GetArrayName(i): vtk_to_numpy(field.GetArray(i))[0] for i in range(field.GetNumberOfArrays())}
    assert all(grid.GetCellType(i) == 1 for i in range(grid.GetNumberOfCells())), "not all cells are vertices"
    assert all(grid.GetCell(i).GetPointId(0) == i for i in range(grid.GetNumberOfCells()))
    return grid, values


def check_with_h5py(path, points):
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        assert list(root.attrs["Version"]) == [1, 0] and root.attrs["Version"].dtype == np.int64
        assert root.attrs["Type"] == b"UnstructuredGrid"
        kind = h5py.h5a.open(root.id, b"Type").get_type()
        assert not kind.is_variable_str() and kind.get_cset() == h5py.h5t.CSET_ASCII
        for name in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"):
            assert root[name].shape == (1,) and root[name].dtype == np.int64 and root[name][0] == points
        assert root["Offsets"].shape == (points + 1,) and root["Types"].dtype == np.uint8
        assert root["Points"].attrs["unit"] == "m"
        assert set(root["PointData"]) == set(UNITS)
        for name, unit in UNITS.items():
            data = root["PointData"][name]
            assert data.attrs["unit"] == unit and data.attrs["meaning"] and data.dtype == TYPES[name], name
            assert data.shape == ((points,) if WIDTHS[name] == 1 else (points, WIDTHS[name])), name
            assert data.compression == "gzip" and data.shuffle and data.chunks, name
        units = {name: data.attrs["unit"] for name, data in root["FieldData"].items()}
        assert units == {"TimeValue": "s", "strain": "1", "step": "1", "history_row": "1"}


def check_xdmf(reader, path, frames):
    reader.SetFileName(str(path.resolve()))
    reader.UpdateInformation()
    times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    assert list(times) == [values["TimeValue"] for _, values in frames], f"{reader.GetClassName()}: {times}"
    for time_value, (grid, _) in zip(times, frames):
        reader.UpdateTimeStep(time_value)
        other = reader.GetOutputDataObject(0)
        assert other.GetNumberOfCells() == grid.GetNumberOfCells()
        for name, values in arrays(grid).items():
            assert np.array_equal(arrays(other)[name].reshape(values.shape), values), f"{reader.GetClassName()}: {name}"


def check_folder(folder, points=None, ends_well=True):
    """What holds for any run; one that ends well has a frame of its end.  @return the frames: grid and field data."""
    folder = Path(folder)
    series = json.loads((folder / "frames.hdf.series").read_text())
    assert series["file-series-version"] == "1.0"
    names = [file["name"] for file in series["files"]]
    assert sorted(names) == sorted(str(p.relative_to(folder)) for p in (folder / "frames").iterdir())
    frames = [read_hdf(folder / name) for name in names]
    assert [file["time"] for file in series["files"]] == [values["TimeValue"] for _, values in frames]
    with open(folder / "curve.csv") as file:
        curve = list(csv.DictReader(file))
    for name, (grid, values) in zip(names, frames):
        row = curve[int(values["history_row"])]
        moves = int(row["moving_points"]) > 0
        assert grid.GetNumberOfPoints() == (int(row["moving_points"]) if moves else points or grid.GetNumberOfPoints())
        check_with_h5py(folder / name, grid.GetNumberOfPoints())
        for value, column in (("TimeValue", "time_s"), ("strain", "strain")):  # moving points are a step later
            step = 3 * values[value] / max(values["step"], 1)
            assert abs(values[value] - float(row[column])) <= (step if moves else 0), (name, column)
        failures = int(row["tension_failures"]) + int(row["shear_failures"])
        assert moves or np.count_nonzero(arrays(grid)["damage"] == 1) == failures
    assert not ends_well or int(frames[-1][1]["history_row"]) == len(curve) - 1, "the last frame is not the end"
    check_xdmf(vtkXdmfReader(), folder / "frames.xdmf", frames)
    check_xdmf(vtkXdmf3Reader(), folder / "frames.xdmf", frames)
    return frames


def check_small_strain():
    assert "7 frames for ParaView: run/frames.hdf.series" in run("run", "--frames", "6")
    frames = check_folder("run", points=400)
    assert len(frames) == 7
    last = arrays(frames[-1][0])
    with h5py.File("run/result.h5") as file:
        mode = file["failure_mode"][()].ravel()
    assert np.array_equal(last["damage"] == 1, mode[last["id"]] > 0) and mode.any(), "other points have failed"
    for point in (0, 399):  # the first pixel is at the top left
        row, col = divmod(int(last["id"][point]), 20)
        place = last["Points"][point] - last["displacement"][point]
        assert np.allclose(place, [1e-3 * (col + 0.5), 1e-3 * (19.5 - row), 0], atol=1e-8)
    stress = last["stress"].reshape(-1, 3, 3)
    assert np.array_equal(stress, stress.transpose(0, 2, 1))
    assert np.allclose(stress[:, 2, 2], 0.2 * (stress[:, 0, 0] + stress[:, 1, 1]), rtol=1e-5, atol=10)


def check_handover():
    run("moving", "--frames", "5", "--kinematics", "auto", "--handover-strain", "2e-4")
    frames = check_folder("moving", points=400)
    assert len(frames) == 6
    last = arrays(frames[-1][0])
    with h5py.File("moving/result.h5") as file:
        for axis, name in enumerate(("end_x", "end_y")):
            assert np.allclose(last["Points"][:, axis], file[name][()].ravel()[last["id"]], rtol=1e-6)


def check_points_that_leave():
    run("flight", "--frames", "4", "--kinematics", "moving", "--direction", "none", "--initial-velocity-x", "40 m/s",
        "--right", "open", "--duration", "300 us", "--motion.margin", "3 mm")
    counts = [grid.GetNumberOfPoints() for grid, _ in check_folder("flight")]
    assert counts[0] == 400 and counts[-1] < 300, counts


def check_extra_points():
    run("extra", "--frames", "2", "--itz.mode", "points")
    counts = {grid.GetNumberOfPoints() for grid, _ in check_folder("extra")}
    assert counts == {json.loads(Path("extra/summary.json").read_text())["points"]} and counts.pop() > 400


def check_overwriting():
    run("run", "--frames", "2")
    assert len(check_folder("run", points=400)) == 3
    run("run")
    assert not [p.name for p in Path("run").iterdir() if p.name.startswith("frames")], "frames of another run are left"


def check_interruption():
    process = subprocess.Popen([mesopix, "simulate", "scene.toml", "-o", "stopped", "-q", "--frames", "1000",
                                "--velocity", "0.001 m/s", "--stop-strain", "0.01"])
    while not len(list(Path("stopped/frames").glob("p_00000[5-9].hdf"))) > 0:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    assert process.wait() == 75
    assert len(check_folder("stopped", points=400)) >= 6


def check_divergence():
    """Pixels alone in their cells beside a block of mortar bear no such step."""
    rows = ["2 " * 6 + ("0 2 0 0 0 0" if row % 4 == 0 else "0 " * 6) for row in range(12)]
    Path("lone.pgm").write_text("P2 12 12 2\n" + "\n".join(rows) + "\n")
    run("diverged", "--frames", "100000", "--convert.method", "labels", "--convert.label-phases", "0:void,2:mortar",
        "--convert.pixel-size", "1 mm", "--cfl", "1", "--mortar.poisson", "0.4999", "--mortar.tensile-scale",
        "unbreakable", code=65, source="lone.pgm")
    frames = check_folder("diverged", points=75, ends_well=False)
    assert len(frames) > 1 and all(np.isfinite(values).all() for values in arrays(frames[-1][0]).values())


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    Path("scene.toml").write_text(SCENE)
    check_small_strain()
    check_handover()
    check_points_that_leave()
    check_extra_points()
    check_overwriting()
    check_interruption()
    check_divergence()
    os.chdir("/")
print("VTK and h5py read all frames")
