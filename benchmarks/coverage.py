#!/usr/bin/env python3
"""What a setting changes in Metropolis light transport: how evenly chains visit the pixels, and the error.

Renders each scene several times with the defaults and with `--setting` (without the lens subpath mutation, if nothing else is given), with
the same number of mutations, in two ways:
  visits: without expected values and with direct light left to the chains each step deposits the luminance b * pixels / steps in one
          pixel, so the image tells how often each pixel was visited. Printed are the variance of the visits between runs over
          their mean, averaged over the pixels (1 for independent visits), and the share of the lit pixels that a run never visits;
  error:  as users render, the variance between runs, averaged over the pixels (MSE), over the squared mean plus 0.01 (relMSE), and that
          without the worst thousandth of the pixels, where few bright dots decide. CPU seconds are those of a render.
Both count on a reconstruction filter of one pixel, which the shipped scenes have.

Needs: python 3, `pip install OpenEXR==3.5.3 numpy`.
Usage: benchmarks/coverage.py [--setting NAME=VALUE] [--option NAME=VALUE ...] [--mutations 50] [--runs 8] [--threads 2] [--size WxH] [--seed-paths 1000] [SCENE ...]
"""

import argparse
import json
import os
import subprocess
import tempfile

import numpy as np
import OpenEXR

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SCENES = ["cornell_spheres", "gold_ring", "veach_room", "door_ajar"]
VISITS = ["-P", "separateDirect=false", "-P", "expectedValues=false"]

# Weights of linear Rec. 709 in the luminance.
LUMINANCE = np.array([0.212671, 0.715160, 0.072169])


def render(scene, options, arguments, seed):
    with tempfile.TemporaryDirectory() as folder:
        image, stats = os.path.join(folder, "image.exr"), os.path.join(folder, "stats.json")
        command = [os.path.join(ROOT, "daybreak"), "render", os.path.join(ROOT, "scenes", scene, "scene.xml")]
        command += ["--renderer", "metropolis", "--spp", str(arguments.mutations), "-P", f"seedPaths={arguments.seed_paths}", *options]
        for option in arguments.option:
            command += ["-P", option]
        command += ["--threads", str(arguments.threads), "--seed", str(seed), "--progress", "none", "-o", image, "--stats", stats]
        if arguments.size:
            command += ["--size", arguments.size]
        subprocess.run(command, check=True)
        channels = OpenEXR.File(image, separate_channels=True).channels()
        pixels = np.stack([channels[c].pixels for c in "RGB"], axis=-1).astype(np.float64)
        with open(stats, encoding="utf-8") as f:
            return pixels, json.load(f)


def visits(pixels, report):
    """Number of steps that ended in each pixel."""
    return pixels @ LUMINANCE * report["figures"]["mutationsPerPixel"] / report["figures"]["b"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=SCENES)
    parser.add_argument("--setting", default="lensSubpath=0", help="what to compare with the defaults")
    parser.add_argument("--option", action="append", default=[], help="parameter NAME=VALUE of both, such as sharing=never")
    parser.add_argument("--mutations", type=int, default=50, help="mutations per pixel")
    parser.add_argument("--seed-paths", type=int, default=1000)
    parser.add_argument("--size", help="size WxH of all images; default: the scenes'")
    parser.add_argument("--runs", type=int, default=8)
    parser.add_argument("--threads", type=int, default=2)
    arguments = parser.parse_args()
    if arguments.runs < 2:
        parser.error("a variance needs 2 runs at least")
    seeds = range(1, arguments.runs + 1)
    for scene in arguments.scenes:
        rows = []
        for label, options in (("default", []), (arguments.setting, ["-P", arguments.setting])):
            # Visits are those of steps: expected values are off in either case.
            moves = [] if arguments.setting.startswith("expectedValues=") else options
            counts = np.stack([visits(*render(scene, VISITS + moves, arguments, seed)) for seed in seeds])
            lit = counts.mean(0) > 0
            dispersion = (counts.var(0, ddof=1)[lit] / counts.mean(0)[lit]).mean()
            never = (counts < 0.5)[:, lit].mean()
            results = [render(scene, options, arguments, seed) for seed in seeds]
            images = np.stack([image for image, _ in results])
            cpu = np.mean([report["seconds"]["render"]["cpu"] for _, report in results])
            variance = images.var(0, ddof=1)
            relative = np.sort((variance / (images.mean(0) ** 2 + 0.01)).mean(-1), axis=None)
            most = relative[: len(relative) * 999 // 1000].sum() / len(relative)
            rows.append((dispersion, variance.mean(), relative.mean(), most, cpu))
            print(
                f"{scene:16} {label:20} variance of visits over mean {dispersion:.2f}, never visited {100 * never:.1f} %,"
                f" MSE {variance.mean():.3e}, relMSE {relative.mean():.3e}, of most pixels {most:.3e}, {cpu:.2f} s CPU",
                flush=True,
            )
        ratio = [b / a for a, b in zip(*rows)]
        print(
            f"{scene:16} {arguments.setting} over default: variance of visits {ratio[0]:.2f}, MSE {ratio[1]:.2f}, relMSE {ratio[2]:.2f},"
            f" of most pixels {ratio[3]:.2f}, CPU {ratio[4]:.2f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
