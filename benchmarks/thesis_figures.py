#!/usr/bin/env python3
"""The thesis' comparison of path tracing with bidirectional path tracing (figures 4.5 to 4.7), at equal time.

Renders each scene several times for the same wall time with `path` and with `bidirectional` (depths 5/5, heuristic exponent 2, as in the
thesis' table A.1; path tracing has the 9 edges that such paths have at most), and prints the ratio of their errors: the
variance between runs, averaged over the pixels, as such (MSE) and over the squared mean plus 0.01 (relMSE). Above 1, bidirectional path
tracing has less error. The pictures of the first runs go side by side into FOLDER/<scene>.png.

Needs: python 3, `pip install OpenEXR==3.5.3 numpy pillow`. A machine that does nothing else meanwhile.
Usage: benchmarks/thesis_figures.py [--seconds 8] [--runs 4] [--threads 2] [--folder figures] [SCENE ...]
"""

import argparse
import json
import os
import subprocess
import tempfile

import numpy as np
import OpenEXR
from PIL import Image

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SCENES = ["cornell_spheres", "gold_ring", "veach_room"]
RENDERERS = {
    "path": ["-P", "maxDepth=9"],
    "bidirectional": ["-P", "maxEyeDepth=5", "-P", "maxLightDepth=5", "-P", "heuristicExponent=2"],
}


def render(scene, renderer, seconds, threads, seed):
    with tempfile.TemporaryDirectory() as folder:
        image, stats = os.path.join(folder, "image.exr"), os.path.join(folder, "stats.json")
        command = [os.path.join(ROOT, "daybreak"), "render", os.path.join(ROOT, "scenes", scene, "scene.xml")]
        command += ["--renderer", renderer, *RENDERERS[renderer], "--time", str(seconds), "--spp", "1000000"]
        command += ["--threads", str(threads), "--seed", str(seed), "--progress", "none", "-o", image, "--stats", stats]
        subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
        channels = OpenEXR.File(image, separate_channels=True).channels()
        pixels = np.stack([channels[c].pixels for c in "RGB"], axis=-1).astype(np.float64)
        with open(stats, encoding="utf-8") as f:
            report = json.load(f)
        return pixels, report["samples"] / (pixels.shape[0] * pixels.shape[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=SCENES)
    parser.add_argument("--seconds", type=float, default=8)
    parser.add_argument("--runs", type=int, default=4)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--folder", default="figures")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    for scene in arguments.scenes:
        errors, pictures, mean = {}, [], None
        for renderer in RENDERERS:
            # Runs of both take turns only scene by scene: what the virtual machine has compiled is not shared anyway.
            runs = [
                render(scene, renderer, arguments.seconds, arguments.threads, seed)
                for seed in range(1, arguments.runs + 1)
            ]
            images = np.stack([image for image, _ in runs])
            mean = images.mean(0) if mean is None else 0.5 * (mean + images.mean(0))
            errors[renderer] = (images.var(0, ddof=1), np.mean([spp for _, spp in runs]), images.mean())
            pictures.append(images[0])
        row = {}
        for renderer, (variance, spp, level) in errors.items():
            row[renderer] = (variance.mean(), (variance / (mean**2 + 0.01)).mean())
            print(
                f"{scene:16} {renderer:14} {spp:7.1f} spp  mean {level:.4f}"
                f"  MSE {row[renderer][0]:.3e}  relMSE {row[renderer][1]:.3e}"
            )
        ratio = [a / b for a, b in zip(row["path"], row["bidirectional"])]
        print(f"{scene:16} path over bidirectional: MSE {ratio[0]:.2f}, relMSE {ratio[1]:.2f}", flush=True)
        both = np.concatenate(pictures, axis=1)
        shown = np.clip(both / (both + 0.5) * 1.4, 0, 1) ** (1 / 2.2)
        Image.fromarray((shown * 255).astype(np.uint8)).save(os.path.join(arguments.folder, scene + ".png"))


if __name__ == "__main__":
    main()
