#!/usr/bin/env python3
"""What the efficiency-optimised roulette over occlusion tests is worth: russianRoulette=efficiency against throughput.

Renders each scene several times for the same wall time with `bidirectional` and both kinds of roulette, in turns, and prints for each
the shadow rays per sample and the error: the variance between runs, averaged over the pixels, as such (MSE), without the
5 worst pixels, and over the squared mean plus 0.01 (relMSE). Efficiency is 1/(error * seconds); its ratio is above 1 where
the roulette pays. The last column is the difference of the two means in standard errors (Welch's t), as the roulette must
not change the mean: with 5 runs of each kind one above 5 comes by chance once in a thousand times.

Needs: python 3, `pip install OpenEXR==3.5.3 numpy`. For figures to be quoted a machine that does nothing else meanwhile.
Usage: benchmarks/roulette.py [--seconds 10] [--runs 5] [--threads 2] [--size WxH] [--scenes NAME,NAME]
"""

import argparse
import json
import os
import subprocess
import tempfile

import numpy as np
import OpenEXR

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SCENES = "cornell_spheres,gold_ring,veach_room,door_ajar"
ROULETTES = ("throughput", "efficiency")
WORST = 5


def render(scene, roulette, seed, arguments):
    """The image, and what the statistics say: seconds, samples, shadow rays."""
    with tempfile.TemporaryDirectory() as folder:
        image, stats = os.path.join(folder, "image.exr"), os.path.join(folder, "stats.json")
        command = [os.path.join(ROOT, "daybreak"), "render", os.path.join(ROOT, "scenes", scene, "scene.xml")]
        command += ["--renderer", "bidirectional", "-P", "russianRoulette=" + roulette, "--time", str(arguments.seconds)]
        command += ["--spp", "1000000", "--threads", str(arguments.threads), "--seed", str(seed), "--progress", "none"]
        command += ["-o", image, "--stats", stats] + (["--size", arguments.size] if arguments.size else [])
        subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
        channels = OpenEXR.File(image, separate_channels=True).channels()
        pixels = np.stack([channels[c].pixels for c in "RGB"], axis=-1).astype(np.float64)
        with open(stats, encoding="utf-8") as f:
            report = json.load(f)
        return pixels, report["seconds"]["render"]["wall"], report["samples"], report["rays"]["shadow"]


def errors(variance, mean):
    """MSE, MSE without the worst pixels, relMSE."""
    pixels = np.sort(variance.mean(axis=-1), axis=None)
    return variance.mean(), pixels[:-WORST].mean(), (variance / (mean**2 + 0.01)).mean()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--runs", type=int, default=5, help="runs of each kind, at least 2")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--size", default="", help="size of the images, such as 160x120; default: the scenes'")
    parser.add_argument("--scenes", default=SCENES, help="names in the folder scenes, separated by commas")
    arguments = parser.parse_args()
    if arguments.runs < 2:
        parser.error("--runs must be at least 2")
    print("| scene | samples per pixel | shadow rays per sample | efficiency by MSE | without the worst | by relMSE | means |")
    print("|---|---|---|---|---|---|---|")
    for scene in arguments.scenes.split(","):
        runs = {roulette: [] for roulette in ROULETTES}
        # In turns, so that what else the machine does meets both; with seeds of their own, so that the means are independent.
        for run in range(arguments.runs):
            for i, roulette in enumerate(ROULETTES):
                runs[roulette].append(render(scene, roulette, len(ROULETTES) * run + i + 1, arguments))
        images = {roulette: np.stack([run[0] for run in runs[roulette]]) for roulette in ROULETTES}
        mean = np.mean([images[roulette].mean(axis=0) for roulette in ROULETTES], axis=0)
        samples, shadows, costs, levels = [], [], [], []
        for roulette in ROULETTES:
            seconds, taken, rays = (np.array([run[i] for run in runs[roulette]]) for i in (1, 2, 3))
            variance = images[roulette].var(axis=0, ddof=1)
            samples.append(taken.mean() / (mean.shape[0] * mean.shape[1]))
            shadows.append(rays.sum() / taken.sum())
            costs.append(np.array(errors(variance, mean)) * seconds.mean())
            levels.append(images[roulette].mean(axis=(1, 2, 3)))
        ratio = costs[0] / costs[1]
        deviation = np.sqrt(sum(level.var(ddof=1) for level in levels) / arguments.runs)
        difference = abs(levels[0].mean() - levels[1].mean()) / deviation
        print(
            f"| {scene} | {samples[0]:.1f}, {samples[1]:.1f} | {shadows[0]:.1f} → {shadows[1]:.1f} "
            f"| {ratio[0]:.2f} | {ratio[1]:.2f} | {ratio[2]:.2f} | {difference:.1f} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
