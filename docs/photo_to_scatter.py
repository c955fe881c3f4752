# %% [markdown]
# # From a photograph to the scatter of the strength
#
# A cut of concrete becomes a specimen, and is pulled apart fifty times, each time with other random strengths. Cells
# begin at `# %%`: VS Code, Spyder and PyCharm run them one by one, `jupytext --to ipynb` makes a notebook of them, and
# `python3 docs/photo_to_scatter.py` runs them all. FIELDS and PIXELS in the environment make it smaller, or finer.

# %%
import concurrent.futures
import os
import pathlib

import matplotlib.pyplot as plt
import numpy as np

import mesopix

fields = int(os.environ.get("FIELDS", 50))
pixels = int(os.environ.get("PIXELS", 150))

# %% [markdown]
# The picture is 150 mm wide. Take your own photograph in its place: it may be a JPEG as it comes from a phone.

# %%
picture = pathlib.Path("data/concrete.png")
specimen = mesopix.convert(picture, width="150 mm", pixels=pixels)
print(specimen)
print(*specimen.notes, sep="\n")

# %% [markdown]
# One run of tension, until the stress has dropped to a fifth of its peak. All settings are in
# `help(mesopix.simulate)`; what is not given has its default.

# %%
loading = dict(velocity="0.1 m/s", stop_strain=4e-4, stop_drop=0.2, threads=1)
result = mesopix.simulate(specimen, seed=1, **loading)
print(result)

# %% [markdown]
# Fifty strength fields, as many at a time as there are cores: a run leaves the interpreter free, so threads are enough.

# %%
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    results = list(pool.map(lambda seed: mesopix.simulate(specimen, seed=seed, **loading), range(1, fields + 1)))
peaks = np.array([result.peak_stress for result in results])
print(f"peak {1e-6 * peaks.mean():.2f} MPa, standard deviation {1e-6 * peaks.std(ddof=1):.2f} MPa")

# %% [markdown]
# The curves, their peaks, and how often each pixel failed.

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
for result in results:
    result.plot(left, color="0.6", linewidth=0.7)
left.plot([1e6 * result.peak_strain for result in results], 1e-6 * peaks, ".", color="tab:red", label="peaks")
left.legend()
failed = np.mean([result.damage() != 0 for result in results], axis=0)
image = right.imshow(failed, extent=(0, 1e3 * specimen.width, 0, 1e3 * specimen.height), cmap="magma", vmin=0)
right.set_xlabel("x [mm]")
right.set_ylabel("y [mm]")
figure.colorbar(image, label="share of the runs in which a pixel failed")
figure.savefig("photo_to_scatter.png", dpi=150)
