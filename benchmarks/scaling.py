#!/usr/bin/env python3
"""How cost grows: time per ray from 10^3 to 10^7 triangles, and the speed-up of a whole render from 1 to 2 threads.

Writes the numbers to standard output and the plots to docs/images/time_per_ray.png and docs/images/thread_speedup.png.
Needs: python 3 with matplotlib; `mvn -DskipTests package` on a JDK 25; a machine that does nothing else meanwhile.
Usage: benchmarks/scaling.py [--java PATH] [--largest 7] [--runs 5] [--scenes cornell_spheres,door_ajar]
"""

import argparse
import csv
import io
import json
import os
import statistics
import subprocess
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
IMAGES = os.path.join(ROOT, "docs", "images")


def time_per_ray(java, largest):
    command = [java, "-Xmx12g", "-XX:+UseG1GC", "-XX:+UseTransparentHugePages", "--add-modules", "jdk.incubator.vector"]
    command += ["-cp", os.path.join(ROOT, "benchmarks", "target", "benchmarks.jar")]
    command += ["org.daybreak.benchmarks.intersection.ScalingBenchmark", "vector512", str(largest)]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    rows = list(csv.DictReader(line for line in io.StringIO(text) if "," in line))
    print(text)
    figure, axes = plt.subplots(figsize=(6.4, 4.2))
    kinds = [k for k in rows[0] if k.endswith("_ns")]
    for kind in kinds:
        axes.plot([float(r["triangles"]) for r in rows], [float(r[kind]) for r in rows], marker="o", label=kind[:-3])
    axes.set_xscale("log")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("triangles")
    axes.set_ylabel("CPU nanoseconds per ray, one thread")
    axes.legend()
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(os.path.join(IMAGES, "time_per_ray.png"), dpi=100)


def render_seconds(scene, threads, spp):
    with tempfile.TemporaryDirectory() as folder:
        stats = os.path.join(folder, "stats.json")
        command = [os.path.join(ROOT, "daybreak"), "render", os.path.join(ROOT, "scenes", scene, "scene.xml")]
        command += ["-o", os.path.join(folder, "out.exr"), "--threads", str(threads), "--spp", str(spp)]
        command += ["--stats", stats, "--progress", "none"]
        subprocess.run(command, check=True)
        with open(stats, encoding="utf-8") as f:
            return json.load(f)["seconds"]["render"]["wall"]


def thread_speedup(scenes, runs, spp):
    medians = {}
    for scene in scenes:
        ratios = []
        for _ in range(runs):
            one, two = render_seconds(scene, 1, spp), render_seconds(scene, 2, spp)
            ratios.append(one / two)
            print(f"{scene}: 1 thread {one:.2f} s, 2 threads {two:.2f} s, speed-up {one / two:.3f}", flush=True)
        medians[scene] = ratios
        print(f"{scene}: median speed-up {statistics.median(ratios):.3f} of {runs} pairs", flush=True)
    figure, axes = plt.subplots(figsize=(6.4, 3.2))
    axes.boxplot([medians[s] for s in scenes], orientation="horizontal")
    axes.set_yticks(range(1, len(scenes) + 1), scenes)
    axes.axvline(2, color="grey", linewidth=0.8)
    axes.set_xlabel("speed-up of the whole render, 2 threads over 1")
    figure.tight_layout()
    figure.savefig(os.path.join(IMAGES, "thread_speedup.png"), dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--java", default="java")
    parser.add_argument("--largest", type=int, default=7, help="power of ten of the number of triangles")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--spp", type=int, default=256)
    parser.add_argument("--scenes", default="cornell_spheres,door_ajar")
    parser.add_argument("--only", choices=["rays", "threads"])
    arguments = parser.parse_args()
    os.makedirs(IMAGES, exist_ok=True)
    if arguments.only != "threads":
        time_per_ray(arguments.java, arguments.largest)
    if arguments.only != "rays":
        thread_speedup(arguments.scenes.split(","), arguments.runs, arguments.spp)


if __name__ == "__main__":
    main()
