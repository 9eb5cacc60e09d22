#!/usr/bin/env python3
"""Time to write and read a float RGBA OpenEXR image with ZIP: our codec against the official library.

The official library is the Python wheel OpenEXR (File(..., num_threads=N), from numpy arrays to a file and back); ours is
benchmarks.exr.ExrSpeed in one Java process. Both take turns, on the same pixels, with the same number of threads; each
run reads the file that the other one wrote, and the pixels are compared once. The first run counts the warm-up of the
virtual machine and is shown apart. Images: "smooth" is noise-free, "noisy" has 5 % noise, as rendered images do.

Needs: python 3, `pip install OpenEXR==3.5.3 numpy`, and `mvn -Pquick package` (or `mvn -pl exr,benchmarks -am compile`).
Usage: benchmarks/exr_speed.py [--size 4096] [--runs 5] [--threads 1,2] [--images smooth,noisy]
"""

import argparse
import os
import statistics
import subprocess
import tempfile
import time

import numpy as np
import OpenEXR

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def make_image(kind, size):
    y, x = np.mgrid[0:size, 0:size].astype(np.float32) / size
    rng = np.random.default_rng(1)
    channels = {}
    for k, name in enumerate("RGB"):
        plane = 0.5 + 0.5 * np.sin(7 * x + k) * np.cos(5 * y - k)
        if kind == "noisy":
            plane = plane * (1 + 0.05 * rng.standard_normal((size, size), dtype=np.float32))
        channels[name] = plane.astype(np.float32)
    channels["A"] = np.ones((size, size), np.float32)
    return channels


def official_write(channels, path, threads):
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    # A copy: the library puts its own objects into the dictionary.
    file = OpenEXR.File(header, dict(channels), num_threads=threads)
    start = time.perf_counter()
    file.write(path)
    return time.perf_counter() - start


def official_read(path, threads):
    start = time.perf_counter()
    channels = OpenEXR.File(path, separate_channels=True, num_threads=threads).channels()
    return time.perf_counter() - start, channels


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", type=int, default=4096)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--threads", default="1,2")
    parser.add_argument("--images", default="smooth,noisy")
    arguments = parser.parse_args()
    classes = os.pathsep.join(os.path.join(ROOT, module, "target", "classes") for module in ("exr", "benchmarks"))
    command = ["java", "-Xmx4g", "-cp", classes, "org.daybreak.benchmarks.exr.ExrSpeed"]
    print(f"{'image':7} {'threads':>7} {'run':>4}  {'write: ours':>11} {'official':>8} {'ratio':>5}  {'read: ours':>10} {'official':>8} {'ratio':>5}")
    with tempfile.TemporaryDirectory() as folder:
        official, ours = os.path.join(folder, "official.exr"), os.path.join(folder, "ours.exr")
        for kind in arguments.images.split(","):
            channels = make_image(kind, arguments.size)
            for threads in map(int, arguments.threads.split(",")):
                with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as java:

                    def ask(what, path):
                        java.stdin.write(f"{what} {threads} {path}\n")
                        java.stdin.flush()
                        return float(java.stdout.readline())

                    ratios = ([], [])
                    for run in range(arguments.runs + 1):
                        write = [0, official_write(channels, official, threads)]
                        read = [ask("read", official), 0]
                        write[0] = ask("write", ours)
                        read[1], back = official_read(ours, threads)
                        label = "cold" if run == 0 else str(run)
                        if run == 0:
                            same = all(back[c].pixels.tobytes() == channels[c].tobytes() for c in channels)
                            assert same, "the pixels differ"
                        else:
                            ratios[0].append(write[0] / write[1])
                            ratios[1].append(read[0] / read[1])
                        print(
                            f"{kind:7} {threads:7} {label:>4}  {write[0]:11.3f} {write[1]:8.3f} {write[0] / write[1]:5.2f}"
                            f"  {read[0]:10.3f} {read[1]:8.3f} {read[0] / read[1]:5.2f}",
                            flush=True,
                        )
                    java.stdin.close()
                sizes = os.path.getsize(ours) / os.path.getsize(official)
                write, read = (statistics.median(r) for r in ratios)
                print(f"{kind:7} {threads:7}  median ratio ours/official: write {write:.2f}, read {read:.2f}; size {sizes:.3f}")


if __name__ == "__main__":
    main()
