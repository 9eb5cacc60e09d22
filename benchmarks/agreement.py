#!/usr/bin/env python3
"""Agreement with Mitsuba 3: renders every scene of src/test/resources/agreement with both and writes docs/agreement.md.

Each scene is rendered by independent runs of both programs. The means of 8x8-pixel tiles of each colour channel are compared by
Welch's t-test, their variances taken from the spread between the runs; a t value is turned into the z value of the same
probability. A scene agrees if no tile's |z| exceeds the Sidak-corrected bound for its number of tiles at a false-alarm
rate of 1e-4 per scene, and neither does the z value of the mean of the whole image, by the plain bound. Black tiles count for nothing.

Needs: python 3, `pip install mitsuba==3.9.1 OpenEXR==3.5.3 numpy scipy`.
Usage: benchmarks/agreement.py [--runs 4] [--spp 64] [--output docs/agreement.md] [SCENE ...]
Exit code 1 if a scene disagrees.
"""

import argparse
import os
import subprocess
import sys
import tempfile

import mitsuba as mi
import numpy as np
import OpenEXR
from scipy import stats

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDER = os.path.join(ROOT, "src", "test", "resources", "agreement")
FALSE_ALARMS = 1e-4
TILE = 8


def ours(scene, spp, seed):
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.exr")
        command = [os.path.join(ROOT, "daybreak"), "render", scene, "--spp", str(spp), "--seed", str(seed), "-o", out]
        subprocess.run(command + ["--progress", "none"], check=True, stderr=subprocess.DEVNULL)
        channels = OpenEXR.File(out, separate_channels=True).channels()
        return np.stack([channels[c].pixels for c in "RGB"], axis=-1).astype(np.float64)


def tiles(image):
    height, width, _ = image.shape
    rows, columns = height // TILE, width // TILE
    cut = image[: rows * TILE, : columns * TILE]
    return cut.reshape(rows, TILE, columns, TILE, 3).mean(axis=(1, 3)).ravel()


def z_values(a, b):
    """z values of the differences of means of the columns of two arrays of runs."""
    variance_a, variance_b = a.var(axis=0, ddof=1) / len(a), b.var(axis=0, ddof=1) / len(b)
    total = variance_a + variance_b
    alive = total > 0
    t = np.zeros(a.shape[1])
    t[alive] = (a.mean(axis=0) - b.mean(axis=0))[alive] / np.sqrt(total[alive])
    freedom = np.ones(a.shape[1])
    freedom[alive] = total[alive] ** 2 / (variance_a[alive] ** 2 / (len(a) - 1) + variance_b[alive] ** 2 / (len(b) - 1))
    return np.sign(t) * stats.norm.isf(stats.t.sf(np.abs(t), freedom)), alive


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--runs", type=int, default=4)
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--output", default=os.path.join(ROOT, "docs", "agreement.md"))
    arguments = parser.parse_args()
    names = arguments.scenes or sorted(f[:-4] for f in os.listdir(FOLDER) if f.endswith(".xml"))
    mi.set_variant("scalar_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    rows, failed = [], []
    for name in names:
        scene_file = os.path.join(FOLDER, name + ".xml")
        scene = mi.load_file(scene_file)
        runs_of_peer = [
            np.array(mi.render(scene, spp=arguments.spp, seed=1000 + i), dtype=np.float64)[..., :3]
            for i in range(2 * arguments.runs)
        ]
        runs = [ours(scene_file, arguments.spp, 1 + i) for i in range(arguments.runs)]
        a, b = np.array([tiles(x) for x in runs]), np.array([tiles(x) for x in runs_of_peer])
        z, alive = z_values(a, b)
        whole, _ = z_values(np.array([[x.mean()] for x in runs]), np.array([[x.mean()] for x in runs_of_peer]))
        count = max(1, int(alive.sum()))
        bound = stats.norm.isf((1 - (1 - FALSE_ALARMS) ** (1 / count)) / 2)
        agrees = np.abs(z).max() <= bound and abs(whole[0]) <= stats.norm.isf(FALSE_ALARMS / 2)
        if not agrees:
            failed.append(name)
        ratio = a.mean() / b.mean() - 1
        rows.append(
            f"| {name} | {100 * ratio:+.2f} % | {whole[0]:+.2f} | {np.abs(z).max():.2f} | {bound:.2f} |"
            f" {np.sqrt(np.mean(z[alive] ** 2)):.2f} | {'yes' if agrees else '**no**'} |"
        )
        print(rows[-1], flush=True)
    if not arguments.scenes:
        with open(arguments.output, "w", encoding="utf-8") as f:
            f.write(
                "# Agreement with Mitsuba 3\n\n"
                "Made by `benchmarks/agreement.py`, which says how: small scenes of `src/test/resources/agreement`, one for each\n"
                f"material, light, camera and filter that Mitsuba 3.9.1 has too, rendered from the same file; {arguments.runs} runs of ours and"
                f" {2 * arguments.runs} of\nMitsuba's at {arguments.spp} samples per pixel, tiles of {TILE}×{TILE} pixels in three channels,"
                " false-alarm rate 1e-4 per scene.\n\n"
                "| scene | difference of means | z of the image mean | largest z of a tile | its bound | rms z | agrees |\n"
                "|---|---|---|---|---|---|---|\n" + "\n".join(rows) + "\n"
            )
    if failed:
        print("disagree: " + ", ".join(failed), file=sys.stderr)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
