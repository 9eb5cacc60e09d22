#!/usr/bin/env python3
"""Agreement with Mitsuba 3: renders the scenes of src/test/resources/agreement with both and fills in docs/agreement.md.

Each scene is rendered by independent runs of both programs, with seeds of their own. Three tests compare the runs:

  image  Welch's t-test of the means of the whole image (mean of the three channels);
  tiles  Welch's t-tests of the means of 8x8-pixel tiles in each channel, of which the largest |z| must stay below the
         Sidak bound for their number;
  rms    the sum over tiles of the squared z values of the channels' mean, against chi-squared: it finds small
         differences that are everywhere.

All t values are turned into the z values of the same probability. Each test has a false-alarm rate of 1e-4. A scene agrees if it
passes all three. Mitsuba computes in 32-bit floating point, so that relative differences of tiles below some 1e-4 cannot
be told from rounding: (2e-5 of the mean)^2 is added to each variance. Where both programs have no variance at all, as in
directly seen lights, this alone decides.

"seen" is the relative error of the whole image, and of the median tile, that the test would have found with a probability of
95 %: (bound + 1.645) standard errors of the difference. If that of the image is not below 2 %, the scene is rendered anew with
four times the samples.

Scenes in the folder "differs" show models that differ by design; they are expected to disagree.

Needs: python 3, `pip install mitsuba==3.9.1 OpenEXR==3.5.3 numpy scipy`.
Usage: benchmarks/agreement.py [--runs 12] [--spp 16] [SCENE ...], a scene's name or the beginning of it, after
`mvn -DskipTests package`.
Results are kept in target/agreement from one call to the next; docs/agreement.md shows all of them.
Exit code 1 if a scene disagrees that should not, or agrees that should not.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import zlib

import mitsuba as mi
import numpy as np
import OpenEXR
from scipy import stats

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDER = os.path.join(ROOT, "src", "test", "resources", "agreement")
RESULTS = os.path.join(ROOT, "target", "agreement")
PAGE = os.path.join(ROOT, "docs", "agreement.md")
FALSE_ALARMS = 1e-4
TILE = 8
ROUNDING = 2e-5
VISIBLE = 0.02
KINDS = {
    "material": "Materials",
    "light": "Lights",
    "camera": "Cameras",
    "texture": "Textures",
    "shape": "Shapes",
    "filter": "Reconstruction filters",
    "differs": "Models that differ by design",
}


class Daybreak:
    """Our program in one virtual machine for all renders."""

    def __init__(self, classpath):
        command = ["java", "-cp", classpath, "org.daybreak.benchmarks.agreement.RepeatedRender"]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def render(self, scene, spp, seed):
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "out.exr")
            options = ["--spp", str(spp), "--seed", str(seed), "--progress", "none", "-o", out]
            self.process.stdin.write("\t".join(["render", scene] + options) + "\n")
            self.process.stdin.flush()
            code = self.process.stdout.readline().strip()
            if code != "0":
                sys.exit(f"{scene}: daybreak ended with code {code}")
            channels = OpenEXR.File(out, separate_channels=True).channels()
            return np.stack([channels[c].pixels for c in "RGB"], axis=-1).astype(np.float64)


def theirs(scene, spp, seed):
    return np.array(mi.render(scene, spp=spp, seed=seed), dtype=np.float64)[..., :3]


def tiles(image):
    """Means of the tiles of each channel: an array (tiles, 3)."""
    height, width, _ = image.shape
    rows, columns = height // TILE, width // TILE
    cut = image[: rows * TILE, : columns * TILE]
    return cut.reshape(rows, TILE, columns, TILE, 3).mean(axis=(1, 3)).reshape(-1, 3)


def welch(a, b):
    """z values and standard errors of the differences of the means of arrays of runs, over their first axis."""
    mean = (a.mean(axis=0) + b.mean(axis=0)) / 2
    variance_a, variance_b = a.var(axis=0, ddof=1) / len(a), b.var(axis=0, ddof=1) / len(b)
    total = variance_a + variance_b + (ROUNDING * mean) ** 2
    alive = total > 0
    safe = np.where(alive, total, 1)
    t = np.where(alive, (a.mean(axis=0) - b.mean(axis=0)) / np.sqrt(safe), 0)
    squares = variance_a**2 / (len(a) - 1) + variance_b**2 / (len(b) - 1)
    freedom = np.where(squares > 0, safe**2 / np.where(squares > 0, squares, 1), 1e9)
    z = np.sign(t) * stats.norm.isf(np.maximum(stats.t.sf(np.abs(t), freedom), 1e-300))
    return z, np.sqrt(total), alive


def compare(name, runs, spp, daybreak):
    """Compares the programs, with four times the samples until an error of the image of 2 % would be seen."""
    file = os.path.join(FOLDER, name + ".xml")
    scene = mi.load_file(file)
    # Scenes have seeds of their own, else all that share a stage would share its noise.
    seeds = [zlib.crc32(name.encode()) % 50_000 * 20 + i for i in range(runs)]
    while True:
        a = np.array([tiles(daybreak.render(file, spp, seed)) for seed in seeds])
        b = np.array([tiles(theirs(scene, spp, seed)) for seed in seeds])
        result = evaluate(a, b)
        if result["seen"] < VISIBLE:
            return {"runs": runs, "spp": spp} | result
        spp *= 4


def evaluate(a, b):
    runs = len(a)
    (whole,), (error,), _ = welch(a.mean(axis=(1, 2))[:, None], b.mean(axis=(1, 2))[:, None])
    z, errors, alive = welch(a, b)
    grey, _, grey_alive = welch(a.mean(axis=2), b.mean(axis=2))
    sum_of_squares, count = float((grey**2).sum()), max(1, int(grey_alive.sum()))
    bound_image = stats.norm.isf(FALSE_ALARMS / 2)
    bound_tile = stats.norm.isf((1 - (1 - FALSE_ALARMS) ** (1 / max(1, alive.sum()))) / 2)
    # The bound of a t-test with these degrees of freedom, as a multiple of the standard error.
    freedom = 2 * (runs - 1)
    steps = [stats.t.isf(stats.norm.sf(bound), freedom) + 1.645 for bound in (bound_image, bound_tile)]
    mean = b.mean()
    largest = float(np.abs(z).max())
    probability = float(stats.chi2.sf(sum_of_squares, count))
    return {
        "difference": float(a.mean() / mean - 1),
        "error": float(error / mean),
        "z": float(whole),
        "largest": largest,
        "bound": float(bound_tile),
        "rms": float(np.sqrt(sum_of_squares / count)),
        "probability": probability,
        "seen": float(steps[0] * error / mean),
        "seenInTile": float(steps[1] * np.median((errors / np.maximum(b.mean(axis=0), 1e-300))[alive])),
        "agrees": bool(abs(whole) <= bound_image and largest <= bound_tile and probability >= FALSE_ALARMS),
    }


def comment(name):
    with open(os.path.join(FOLDER, name + ".xml"), encoding="utf-8") as f:
        return re.search(r"<!-- (.*?) -->", f.read(), re.DOTALL).group(1).rstrip(".").replace("\n", " ")


def row(name, result):
    r = result
    short = name.split("/" if "/" in name else "_", 1)[1]
    return (
        f"| `{short}` | {comment(name)} | {100 * r['difference']:+.2f} ± {100 * r['error']:.2f} | {r['z']:+.2f} |"
        f" {r['largest']:.2f} ({r['bound']:.2f}) | {r['rms']:.2f} | {r['spp']} | {100 * r['seen']:.2f} | {100 * r['seenInTile']:.1f} |"
        f" {'yes' if r['agrees'] else '**no**'} |"
    )


def tables(results):
    parts = []
    for kind, title in KINDS.items():
        names = [n for n in results if n.startswith(kind)]
        if names:
            parts.append(
                f"### {title}\n\n| scene | what it shows | difference of means, % | z of the image | largest z of a tile (bound)"
                " | rms z | samples | seen, % | seen in a tile, % | agrees |\n|---|---|---|---|---|---|---|---|---|---|\n"
                + "\n".join(row(n, results[n]) for n in names)
            )
    return "\n\n".join(parts)


def all_names():
    here = sorted(f[:-4] for f in os.listdir(FOLDER) if f.endswith(".xml"))
    return here + sorted("differs/" + f[:-4] for f in os.listdir(os.path.join(FOLDER, "differs")))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--runs", type=int, default=12)
    parser.add_argument("--spp", type=int, default=16)
    jar = os.path.join(ROOT, "benchmarks", "target", "benchmarks.jar")
    parser.add_argument("--classpath", default=jar, help="where our classes are")
    arguments = parser.parse_args()
    daybreak = Daybreak(arguments.classpath)
    known = all_names()
    names = [n for n in known if not arguments.scenes or any(n.startswith(s) for s in arguments.scenes)]
    mi.set_variant("scalar_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    os.makedirs(os.path.join(RESULTS, "differs"), exist_ok=True)
    for name in names:
        result = compare(name, arguments.runs, arguments.spp, daybreak)
        print(row(name, result), flush=True)
        with open(os.path.join(RESULTS, name + ".json"), "w", encoding="utf-8") as f:
            json.dump(result, f, indent=1)
    results = {}
    for name in known:
        if os.path.exists(os.path.join(RESULTS, name + ".json")):
            with open(os.path.join(RESULTS, name + ".json"), encoding="utf-8") as f:
                results[name] = json.load(f)
    with open(PAGE, encoding="utf-8") as f:
        page = f.read()
    begin, end = "<!-- tables: benchmarks/agreement.py -->\n", "\n<!-- end of tables -->"
    head, rest = page.split(begin)
    with open(PAGE, "w", encoding="utf-8") as f:
        f.write(head + begin + "\n" + tables(results) + "\n" + end + rest.split(end)[1])
    wrong = [n for n in names if results[n]["agrees"] == n.startswith("differs")]
    if wrong:
        print("not as expected: " + ", ".join(wrong), file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
