#!/usr/bin/env python3
"""How cost grows: time per ray from 10^3 to 10^7 triangles, and the speed-up of a render from 1 to 2 threads.

Writes the numbers to standard output and the plots to docs/images/time_per_ray.png and docs/images/thread_speedup.png.
Needs: python 3 with matplotlib; `mvn -DskipTests package` on a JDK 25; a machine that does nothing else meanwhile.
Usage: benchmarks/scaling.py [--java PATH] [--largest 7] [--runs 5] [--seconds 16] [--scenes cornell_spheres,door_ajar]
"""

import argparse
import concurrent.futures
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

# Seconds that a virtual machine takes to compile what a render needs.
WARM = 4


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


def rate(scene, threads, seconds, options):
    """Samples per second once all is compiled: the median of what was done in each second from the fifth on."""
    with tempfile.TemporaryDirectory() as folder:
        command = [os.path.join(ROOT, "daybreak"), "render", os.path.join(ROOT, "scenes", scene, "scene.xml")]
        command += ["-o", os.path.join(folder, "out.exr"), "--threads", str(threads), "--time", str(seconds), "--progress", "json", *options]
        lines = subprocess.run(command, check=True, stderr=subprocess.PIPE, text=True).stderr.splitlines()
    rates, last = [], None
    for event in (json.loads(line) for line in lines if line.startswith("{")):
        if event.get("event") == "progress" and event["secondsElapsed"] >= WARM:
            now = event["secondsElapsed"], event["samples"]
            if last is None:
                last = now
            elif now[0] - last[0] >= 1:
                rates.append((now[1] - last[1]) / (now[0] - last[0]))
                last = now
    return statistics.median(rates)


def rates(scene, seconds, processes, threads, options):
    """Sum over processes that run at the same time."""
    with concurrent.futures.ThreadPoolExecutor(processes) as pool:
        return sum(pool.map(lambda _: rate(scene, threads, seconds, options), range(processes)))


def thread_speedup(scenes, runs, seconds, options):
    """Two threads over one; and two processes of one thread each, which share nothing but the machine: what it can give."""
    kinds = {"2 threads": (1, 2), "2 processes": (2, 1)}
    figure, axes = plt.subplots(figsize=(6.4, 0.8 + 0.6 * len(kinds) * len(scenes)))
    labels = []
    for scene in scenes:
        ratios = {kind: [] for kind in kinds}
        for _ in range(runs):
            one = rates(scene, seconds, 1, 1, options)
            for kind, (processes, threads) in kinds.items():
                ratios[kind].append(rates(scene, seconds, processes, threads, options) / one)
            print(f"{scene}: {one:.4g} samples/s with 1 thread; " + ", ".join(f"{k} {r[-1]:.3f}" for k, r in ratios.items()), flush=True)
        for kind, values in ratios.items():
            print(f"{scene}: {kind}: median {statistics.median(values):.3f} of {runs}", flush=True)
            axes.plot(values, [len(labels)] * runs, "o", alpha=0.6)
            axes.plot(statistics.median(values), len(labels), "k|", markersize=20)
            labels.append(f"{scene}, {kind}")
    axes.set_yticks(range(len(labels)), labels)
    axes.set_ylim(-0.5, len(labels) - 0.5)
    axes.axvline(2, color="grey", linewidth=0.8)
    axes.set_xlabel("samples per second over those of one thread; each run and their median")
    figure.tight_layout()
    if not options:
        figure.savefig(os.path.join(IMAGES, "thread_speedup.png"), dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--java", default="java")
    parser.add_argument("--largest", type=int, default=7, help="power of ten of the number of triangles")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=16, help="length of each render with threads")
    parser.add_argument("--scenes", default="cornell_spheres,door_ajar")
    parser.add_argument("--option", action="append", default=[], help="further option for daybreak render; then no plot of threads is made")
    parser.add_argument("--only", choices=["rays", "threads"])
    arguments = parser.parse_args()
    os.makedirs(IMAGES, exist_ok=True)
    if arguments.only != "threads":
        time_per_ray(arguments.java, arguments.largest)
    if arguments.only != "rays":
        thread_speedup(arguments.scenes.split(","), arguments.runs, arguments.seconds, arguments.option)


if __name__ == "__main__":
    main()
