"""Prints reference values of FLIP, computed by the package flip-evaluator, for images that FlipTest makes by the same formulas.

    python3 cli/src/test/python/flip_reference.py > cli/src/test/resources/org/daybreak/cli/flip/reference.csv
"""

import flip_evaluator
import numpy as np

WIDTH, HEIGHT = 96, 64


def picture(shift, noise, scale):
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH].astype(np.float64)
    x = x + shift
    hashed = np.sin(12.9898 * x + 78.233 * y) * 43758.5453
    random = hashed - np.floor(hashed)
    planes = []
    for c in range(3):
        smooth = 0.5 + 0.4 * np.sin(0.13 * (c + 1) * x + 0.05 * y) * np.cos(0.11 * y - 0.3 * c)
        edge = np.where((x - 48) ** 2 + (y - 32) ** 2 < 400, 0.3, 0.0)
        planes.append(np.clip(smooth + edge + noise * (random - 0.5), 0, None) * scale)
    return np.stack(planes, axis=-1).astype(np.float32)


def srgb(linear):
    v = np.clip(linear.astype(np.float64), 0, 1)
    return np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055).astype(np.float32)


CASES = [
    ("shift", "LDR", picture(1, 0, 1), picture(0, 0, 1)),
    ("noise", "LDR", picture(0, 0.3, 1), picture(0, 0, 1)),
    ("dark", "LDR", picture(0, 0.1, 0.05), picture(0, 0, 0.05)),
    ("hdr", "HDR", picture(0, 0.3, 20), picture(0, 0, 20)),
    ("hdrShift", "HDR", picture(2, 0.05, 0.01), picture(0, 0, 0.01)),
]

print("case,x,y,error")
for name, kind, image, reference in CASES:
    if kind == "LDR":
        image, reference = srgb(image), srgb(reference)
    error, mean, _ = flip_evaluator.evaluate(reference, image, kind, applyMagma=False)
    print(f"{name},mean,mean,{mean:.6f}")
    for i in range(12):
        x, y = (i * 37) % WIDTH, (i * 23) % HEIGHT
        print(f"{name},{x},{y},{float(np.squeeze(error)[y, x]):.6f}")
