#!/usr/bin/env python3
"""Equal-time comparison of `daybreak render --renderer path`, or another renderer, with Mitsuba 3's `path`.

Renders each show scene for the same wall time with both (scene loading and kernel or class compilation of Mitsuba left
out; ours counts from the compiled scene on and includes the warm-up of the virtual machine; with renderers by Markov chains also
direct lighting and the start, and their samples per pixel are mutations) and prints the ratio of
efficiencies 1/(error * seconds) against the reference images of src/test/resources/reference, for two errors:
  relMSE = mean((x - ref)^2 / (ref^2 + 0.01)) and MSE = mean((x - ref)^2), each less the reference's own variance.

The scene `plain_box`, cornell_spheres without the spheres at 256x256, has no reference image: its error is the variance between the runs,
over the squared mean plus 0.01 and as such. Not among the default scenes.

Of `metropolis`, `pssmlt` and `mmlt` it also prints the ratio to what Mitsuba 0.6's `mlt` and `pssmlt` reach in the same measure.

Needs: python 3, `pip install mitsuba==3.9.1 OpenEXR==3.5.3 numpy`, and LLVM 19 for `llvm_ad_rgb` (Debian: libllvm19).
Usage: benchmarks/equal_time.py [--seconds 10] [--runs 3] [--threads 2] [--variants llvm_ad_rgb,scalar_rgb]
       [--renderer path] [--option OPTION ...] [SCENE ...]
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import OpenEXR

import thesis_figures

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SCENES = ["cornell_spheres", "gold_ring", "veach_room", "door_ajar"]
CHAINS = ["metropolis", "pssmlt", "mmlt"]

# Efficiency of Mitsuba 0.6's `mlt` (bidirectional mutation and manifold perturbation) and `pssmlt` over that of Mitsuba 3.9.1's `path`,
# llvm_ad_rgb, by relMSE and by MSE: 2 threads, one run of 10 to 15 s each, as measured with the reference images. Where
# fireflies rule (gold_ring) another run may be off by a factor of 2.
PEERS = {
    "cornell_spheres": {"mlt": (0.33, 0.09), "pssmlt": (0.63, 0.17)},
    "gold_ring": {"mlt": (2.6, 0.05), "pssmlt": (1.0, 0.04)},
    "veach_room": {"mlt": (13.1, 1.8), "pssmlt": (11.4, 1.7)},
    "door_ajar": {"mlt": (5.0, 4.1), "pssmlt": (0.99, 1.1)},
}
PEERS_VARIANT = "llvm_ad_rgb"


def read_rgb(path):
    channels = OpenEXR.File(path, separate_channels=True).channels()
    return np.stack([channels[c].pixels for c in "RGB"], axis=-1).astype(np.float64)


def errors(image, reference, variance):
    squared = (image - reference) ** 2 - variance
    return float(np.mean(squared / (reference**2 + 0.01))), float(np.mean(squared))


def run_daybreak(scene_file, seconds, threads, seed, renderer, extra):
    with tempfile.TemporaryDirectory() as folder:
        out, stats = os.path.join(folder, "out.exr"), os.path.join(folder, "stats.json")
        command = [os.path.join(ROOT, "daybreak"), "render", scene_file, "-o", out, "--renderer", renderer, "--time", str(seconds)]
        command += ["--threads", str(threads), "--seed", str(seed), "--stats", stats, "--progress", "none"] + extra
        subprocess.run(command, check=True)
        with open(stats, encoding="utf-8") as f:
            report = json.load(f)
        return read_rgb(out), report["seconds"]["render"]["wall"], report


# A fresh process for each run, so that no variant profits from another's memory or compiled kernels.
MITSUBA = """
import sys, time, numpy as np, mitsuba as mi
scene_file, variant, seconds, threads, seed, out = sys.argv[1], sys.argv[2], float(sys.argv[3]), int(sys.argv[4]), int(sys.argv[5]), sys.argv[6]
mi.set_variant(variant)
import drjit as dr
dr.set_thread_count(threads)
mi.Thread.thread().logger().set_log_level(mi.LogLevel.Error)
scene = mi.load_file(scene_file)
def render(spp, seed):
    return np.array(mi.render(scene, spp=spp, seed=seed), dtype=np.float64)[..., :3]
render(1, 999999); render(4, 999998)
start = time.perf_counter(); render(4, 999997); per_sample = (time.perf_counter() - start) / 4
spp = int(max(1, min(256, seconds / 4 / per_sample)))
if variant.startswith("llvm"):
    render(spp, 999996)
total, count, i = 0, 0, 0
start = time.perf_counter()
while True:
    total = total + render(spp, seed * 100000 + i) * spp
    count += spp; i += 1
    elapsed = time.perf_counter() - start
    if elapsed >= seconds: break
    rest = int((seconds - elapsed) / (elapsed / count))
    if not variant.startswith("llvm") or rest >= spp: spp = max(1, min(spp, rest))
np.savez(out, image=total / count, seconds=elapsed, spp=count)
"""


def run_mitsuba(scene_file, variant, seconds, threads, seed):
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.npz")
        command = [sys.executable, "-c", MITSUBA, scene_file, variant, str(seconds), str(threads), str(seed), out]
        subprocess.run(command, check=True, env={**os.environ, "OMP_NUM_THREADS": str(threads)})
        data = np.load(out)
        return data["image"], float(data["seconds"]), int(data["spp"])


def plain_box(arguments, variants):
    """Compares without a reference: by the variance between runs."""
    with tempfile.TemporaryDirectory() as folder:
        def edit(root):
            thesis_figures.remove_spheres(root)
            for size in ("width", "height"):
                root.find(f"sensor/film/integer[@name='{size}']").set("value", "256")

        file = thesis_figures.variant("cornell_spheres", folder, edit)
        runs = range(1, arguments.runs + 1)
        ours = [run_daybreak(file, arguments.seconds, arguments.threads, r, arguments.renderer, arguments.option)[:2] for r in runs]
        rows = {arguments.renderer: ours}
        for variant in variants:
            rows[variant] = [run_mitsuba(file, variant, arguments.seconds, arguments.threads, r)[:2] for r in runs]
    cost = {}
    for name, results in rows.items():
        images = np.stack([image for image, _ in results])
        mean, variance = images.mean(0), images.var(0, ddof=1)
        rel, mse = np.mean(variance / (mean**2 + 0.01)), np.mean(variance)
        seconds = statistics.mean(s for _, s in results)
        cost[name] = rel * seconds, mse * seconds
        print(f"{'plain_box':18} {name:14} {seconds:8.2f} s {rel:11.4e} {mse:11.4e}   mean {mean.mean():.5f}", flush=True)
    for variant in variants:
        rel, mse = (cost[variant][i] / cost[arguments.renderer][i] for i in (0, 1))
        print(f"{'plain_box':18} {arguments.runs} runs against {variant}: {rel:.2f} by relMSE, {mse:.2f} by MSE", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=SCENES)
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--variants", default="llvm_ad_rgb,scalar_rgb")
    parser.add_argument("--renderer", default="path")
    parser.add_argument("--option", action="append", default=[], help="further option for daybreak render")
    arguments = parser.parse_args()
    variants = [v for v in arguments.variants.split(",") if v]
    print(f"{'scene':18} {'renderer':14} {'spp':>8} {'seconds':>8} {'relMSE':>11} {'MSE':>11}   efficiency daybreak/peer: relMSE  MSE")
    for name in arguments.scenes or SCENES:
        if name == "plain_box":
            plain_box(arguments, variants)
            continue
        scene_file = os.path.join(ROOT, "scenes", name, "scene.xml")
        folder = os.path.join(ROOT, "src", "test", "resources", "reference", name)
        reference = read_rgb(os.path.join(folder, "reference.exr"))
        variance = read_rgb(os.path.join(folder, "standard_error.exr")) ** 2
        ratios = {v: ([], []) for v in variants}
        for run in range(arguments.runs):
            image, seconds, report = run_daybreak(
                scene_file, arguments.seconds, arguments.threads, run + 1, arguments.renderer, arguments.option)
            rel, mse = errors(image, reference, variance)
            spp = report["figures"].get("mutationsPerPixel", report["samples"] / (image.shape[0] * image.shape[1]))
            print(f"{name:18} {arguments.renderer:14} {spp:8.1f} {seconds:8.2f} {rel:11.4e} {mse:11.4e}", flush=True)
            for variant in variants:
                other, other_seconds, other_spp = run_mitsuba(scene_file, variant, arguments.seconds, arguments.threads, run + 1)
                other_rel, other_mse = errors(other, reference, variance)
                ratios[variant][0].append(other_rel * other_seconds / (rel * seconds))
                ratios[variant][1].append(other_mse * other_seconds / (mse * seconds))
                print(
                    f"{name:18} {variant:14} {other_spp:8.1f} {other_seconds:8.2f} {other_rel:11.4e} {other_mse:11.4e}"
                    f"   {ratios[variant][0][-1]:30.2f} {ratios[variant][1][-1]:6.2f}",
                    flush=True,
                )
        for variant in variants:
            rel, mse = (statistics.median(x) for x in ratios[variant])
            print(f"{name:18} median of {arguments.runs} against {variant}: {rel:.2f} by relMSE, {mse:.2f} by MSE", flush=True)
            if arguments.renderer in CHAINS and variant == PEERS_VARIANT:
                for peer, (peer_rel, peer_mse) in PEERS.get(name, {}).items():
                    print(
                        f"{name:18} over Mitsuba 0.6 {peer}: {rel / peer_rel:.2f} by relMSE, {mse / peer_mse:.2f} by MSE",
                        flush=True,
                    )


if __name__ == "__main__":
    main()
