#!/usr/bin/env python3
"""The thesis' comparisons of renderers at equal time.

`--figures pt-bpt` (figures 4.5 to 4.7): path tracing with bidirectional path tracing (depths 5/5, heuristic exponent 2, as in the
thesis' table A.1; path tracing has the 9 edges that such paths have at most).

`--figures mlt` (figures 5.6 and 5.7): bidirectional path tracing with Metropolis light transport, both with depths 5/5, the latter with 1000
seeds and, unless `--seconds` is given, 250 mutations per pixel; the other then gets the time that these take. The scenes are
  door_ajar    figure 5.7, 450x250: all light comes through the gap of a door;
  egg_1 to _3  figure 5.6: the caustic of the glass egg in veach_room, with the camera moved ever closer to it;
  plain_box    cornell_spheres without the spheres: lit plainly, where neither should be much ahead.

Renders each scene several times for the same wall time with both, and prints the ratio of their errors: the variance between runs,
averaged over the pixels, as such (MSE) and over the squared mean plus 0.01 (relMSE). Above 1, the second has less error. The standard
error behind it is a jackknife's, by leaving out one run of each at a time; it says nothing about what happens in none of the runs. What
both have in common, such as an error of the brightness of all chains of a run, is in the variance; a bias is not, so the means are
compared too: their difference in percent and in standard errors. The pictures of the first runs go side by side into FOLDER/<scene>.png.

Needs: python 3, `pip install OpenEXR==3.5.3 numpy pillow`. A machine that does nothing else meanwhile.
Usage: benchmarks/thesis_figures.py [--figures pt-bpt|mlt] [--seconds S] [--mutations 250] [--runs 4] [--threads 2] [--folder figures]
       [--size WxH] [--metropolis metropolis|pssmlt|mmlt] [--option NAME=VALUE ...] [SCENE ...]
"""

import argparse
import glob
import json
import os
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy as np
import OpenEXR
from PIL import Image

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DEPTHS = ["-P", "maxEyeDepth=5", "-P", "maxLightDepth=5", "-P", "heuristicExponent=2"]
SEED_PATHS = 1000
PT_BPT_SECONDS = 8

# The middle of the caustic on the table of veach_room beside the egg, and where the camera is from there: in front and above, so
# that it looks down on the table. Its distance in the scene file is 7.6.
CAUSTIC = np.array([0.3, 1.12, -0.73])
TO_CAMERA = np.array([-0.1, 0.55, 0.83])
ZOOMS = {"egg_1": 3.8, "egg_2": 1.9, "egg_3": 0.9}

FIGURES = {
    "pt-bpt": ["cornell_spheres", "gold_ring", "veach_room"],
    "mlt": ["door_ajar", *ZOOMS, "plain_box"],
}


def variant(scene, folder, edit):
    """Writes a scene with an edited tree, which finds its files where the original does."""
    original = os.path.join(ROOT, "scenes", scene)
    tree = ElementTree.parse(os.path.join(original, "scene.xml"))
    tree.getroot().insert(0, ElementTree.Element("path", value=original))
    edit(tree.getroot())
    file = os.path.join(folder, "scene.xml")
    tree.write(file, encoding="utf-8", xml_declaration=True)
    return file


def move_camera(root, distance):
    look = root.find("sensor/transform/lookat")
    look.set("origin", ", ".join(f"{x:.6g}" for x in CAUSTIC + distance * TO_CAMERA))
    look.set("target", ", ".join(f"{x:.6g}" for x in CAUSTIC))


def remove_spheres(root):
    for shape in root.findall("shape[@type='sphere']"):
        root.remove(shape)


def scene_file(name, folder):
    if name in ZOOMS:
        return variant("veach_room", folder, lambda root: move_camera(root, ZOOMS[name]))
    if name == "plain_box":
        return variant("cornell_spheres", folder, remove_spheres)
    return os.path.join(ROOT, "scenes", name, "scene.xml")


def render(file, renderer, options, arguments, seed):
    """Pixels, samples or mutations per pixel, and seconds."""
    with tempfile.TemporaryDirectory() as folder:
        image, stats = os.path.join(folder, "image.exr"), os.path.join(folder, "stats.json")
        command = [os.path.join(ROOT, "daybreak"), "render", file, "--renderer", renderer, *options]
        command += ["--threads", str(arguments.threads), "--seed", str(seed), "--progress", "none", "-o", image, "--stats", stats]
        if arguments.size:
            command += ["--size", arguments.size]
        # Warnings of the program go to the terminal: a run may have been too short for a first sample of every pixel.
        subprocess.run(command, check=True)
        channels = OpenEXR.File(image, separate_channels=True).channels()
        pixels = np.stack([channels[c].pixels for c in "RGB"], axis=-1).astype(np.float64)
        with open(stats, encoding="utf-8") as f:
            report = json.load(f)
        count = report["figures"].get("mutationsPerPixel", report["samples"] / (pixels.shape[0] * pixels.shape[1]))
        return pixels, count, report["seconds"]["render"]["wall"]


def renders(file, renderer, options, arguments):
    runs = [render(file, renderer, options, arguments, seed) for seed in range(1, arguments.runs + 1)]
    images, counts, seconds = zip(*runs)
    return np.stack(images), np.mean(counts), np.mean(seconds)


def compare(name, arguments):
    """Images, samples per pixel and seconds of both renderers, by name."""
    with tempfile.TemporaryDirectory() as folder:
        file = scene_file(name, folder)
        # Runs of both take turns only scene by scene: what the virtual machine has compiled is not shared anyway.
        if arguments.figures == "pt-bpt":
            limit = ["--time", str(arguments.seconds or PT_BPT_SECONDS), "--spp", "1000000"]
            return {
                "path": renders(file, "path", ["-P", "maxDepth=9", *limit], arguments),
                "bidirectional": renders(file, "bidirectional", DEPTHS + limit, arguments),
            }
        chains = [*DEPTHS, "-P", f"seedPaths={SEED_PATHS}"]
        for option in arguments.option:
            chains += ["-P", option]
        chains += ["--time", str(arguments.seconds)] if arguments.seconds else ["--spp", str(arguments.mutations)]
        second = renders(file, arguments.metropolis, chains, arguments)
        first = renders(file, "bidirectional", [*DEPTHS, "--time", str(arguments.seconds or second[2])], arguments)
        return {"bidirectional": first, arguments.metropolis: second}


def errors_of(images, mean):
    variance = images.var(0, ddof=1)
    return np.array([variance.mean(), (variance / (mean**2 + 0.01)).mean()])


def jackknife(first, second, mean):
    """Standard errors of the ratios of errors; none of two runs."""
    runs = len(first)
    if runs < 3:
        return np.full(2, np.nan)
    left = [errors_of(np.delete(first, i, 0), mean) / errors_of(np.delete(second, i, 0), mean) for i in range(runs)]
    return np.sqrt((runs - 1) * np.var(left, axis=0))


def print_errors(name, results):
    (first, second), sets = results.keys(), [images for images, _, _ in results.values()]
    mean = np.mean([images.mean(0) for images in sets], axis=0)
    errors, levels = [], []
    for renderer, (images, count, seconds) in results.items():
        errors.append(errors_of(images, mean))
        levels.append(images.mean((1, 2, 3)))
        print(
            f"{name:16} {renderer:14} {count:7.1f} spp {seconds:6.1f} s  mean {images.mean():.4f}"
            f"  MSE {errors[-1][0]:.3e}  relMSE {errors[-1][1]:.3e}"
        )
    ratio = errors[0] / errors[1]
    doubt = jackknife(*sets, mean)
    difference = levels[1].mean() - levels[0].mean()
    deviation = np.sqrt(sum(level.var(ddof=1) / len(level) for level in levels))
    print(
        f"{name:16} {first} over {second}: MSE {ratio[0]:.2f} ± {doubt[0]:.2f}, relMSE {ratio[1]:.2f} ± {doubt[1]:.2f};"
        f" means differ by {100 * difference / levels[0].mean():+.2f} %, {difference / deviation:+.1f} standard errors",
        flush=True,
    )


def write_picture(file, pictures):
    both = np.concatenate(pictures, axis=1)
    shown = np.clip(both / (both + 1.5 * both.mean()) * 1.4, 0, 1) ** (1 / 2.2)
    Image.fromarray((shown * 255).astype(np.uint8)).save(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--figures", choices=sorted(FIGURES), default="pt-bpt")
    parser.add_argument("--seconds", type=float, help="time of each run; default: 8, or what the mutations take")
    parser.add_argument("--mutations", type=int, default=250, help="mutations per pixel, unless there are seconds")
    parser.add_argument("--metropolis", choices=["metropolis", "pssmlt", "mmlt"], default="metropolis")
    parser.add_argument("--option", action="append", default=[], help="further parameter NAME=VALUE of the chains")
    parser.add_argument("--size", help="size WxH of all images; default: the scenes'")
    parser.add_argument("--runs", type=int, default=4)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--folder", default="figures")
    arguments = parser.parse_args()
    known = FIGURES[arguments.figures]
    shipped = [os.path.basename(os.path.dirname(file)) for file in glob.glob(os.path.join(ROOT, "scenes", "*", "scene.xml"))]
    for name in arguments.scenes:
        if name not in [*known, *shipped]:
            parser.error(f"there is no scene '{name}'; those of the figures are {', '.join(known)}")
    if arguments.runs < 2:
        parser.error("a variance needs 2 runs at least")
    os.makedirs(arguments.folder, exist_ok=True)
    for name in arguments.scenes or known:
        results = compare(name, arguments)
        print_errors(name, results)
        write_picture(os.path.join(arguments.folder, name + ".png"), [images[0] for images, _, _ in results.values()])


if __name__ == "__main__":
    main()
