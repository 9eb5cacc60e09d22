#!/usr/bin/env python3
"""Does antialiasing `adaptive` pay? Its error over that of `sobol` at the same number of samples, scene by scene.

Both render each scene with several seeds; errors are those of equal_time.py, against the reference images of
src/test/resources/reference. Printed are the ratios of the mean errors with their standard errors over the seeds, and the ratio of
the rays traced, which tells the costs apart on a machine that has other things to do.

Needs: python 3, `pip install OpenEXR==3.5.3 numpy`.
Usage: benchmarks/adaptive.py [--spp 64] [--seeds 8] [--option "-A uniformShare=0.5"] [--command ./daybreak] [SCENE ...]
"""

import argparse
import json
import os
import shlex
import subprocess
import tempfile

import numpy as np

from equal_time import ROOT, SCENES, errors, read_rgb


def render(command, scene_file, antialiasing, spp, seed, options):
    with tempfile.TemporaryDirectory() as folder:
        out, stats = os.path.join(folder, "out.exr"), os.path.join(folder, "stats.json")
        arguments = ["render", scene_file, "--antialiasing", antialiasing, "--spp", str(spp), "--seed", str(seed)]
        subprocess.run([*command, *arguments, "-o", out, "--stats", stats, "--progress", "none", *options], check=True)
        with open(stats, encoding="utf-8") as f:
            report = json.load(f)
        return read_rgb(out), report["raysTotal"], report["samples"]


def ratio(adaptive, uniform):
    """Ratio of the means and its standard error, both from independent runs."""
    a, u = np.array(adaptive), np.array(uniform)
    relative = [x.std(ddof=1) / np.sqrt(len(x)) / x.mean() for x in (a, u)]
    return a.mean() / u.mean(), a.mean() / u.mean() * np.hypot(*relative)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=SCENES)
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--seeds", type=int, default=8)
    parser.add_argument("--option", default="", help="further options for the adaptive renders")
    parser.add_argument("--command", default=os.path.join(ROOT, "daybreak"))
    arguments = parser.parse_args()
    command = shlex.split(arguments.command)
    print(f"{'scene':16} {'spp':>5} {'samples':>8} {'rays':>6}   {'relMSE':>14}   {'MSE':>14}   (adaptive over sobol)")
    for name in arguments.scenes or SCENES:
        scene_file = os.path.join(ROOT, "scenes", name, "scene.xml")
        folder = os.path.join(ROOT, "src", "test", "resources", "reference", name)
        reference = read_rgb(os.path.join(folder, "reference.exr"))
        variance = read_rgb(os.path.join(folder, "standard_error.exr")) ** 2
        found = {"sobol": [], "adaptive": []}
        for seed in range(1, arguments.seeds + 1):
            for antialiasing, results in found.items():
                options = shlex.split(arguments.option) if antialiasing == "adaptive" else []
                image, rays, samples = render(command, scene_file, antialiasing, arguments.spp, seed, options)
                results.append((*errors(image, reference, variance), rays, samples))
        columns = [ratio(a, u) for a, u in zip(zip(*found["adaptive"]), zip(*found["sobol"]))]
        (rel, rel_error), (mse, mse_error), (rays, _), (samples, _) = columns
        print(
            f"{name:16} {arguments.spp:5} {samples:8.3f} {rays:6.3f}   {rel:6.3f} ± {rel_error:5.3f}   {mse:6.3f} ± {mse_error:5.3f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
