#!/usr/bin/env python3
"""Makes the textures of the user guide, docs/guide/textures.

Needs: python 3, `pip install OpenEXR==3.5.3 numpy pillow`.
"""

import os

import numpy as np
import OpenEXR
from PIL import Image

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "textures")


def save(name, values):
    Image.fromarray((np.clip(values, 0, 1) * 255 + 0.5).astype(np.uint8)).save(os.path.join(FOLDER, name), optimize=True)


def unit_square(width, height):
    """Coordinates of pixel centres in [0, 1]."""
    return np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(height) + 0.5) / height)


def periodic_noise(size, seed, lowest, highest):
    """Noise of a band of frequencies, that repeats without a seam, in [-1, 1]."""
    spectrum = np.fft.fft2(np.random.default_rng(seed).standard_normal((size, size)))
    frequencies = np.fft.fftfreq(size) * size
    frequency = np.hypot(*np.meshgrid(frequencies, frequencies))
    noise = np.real(np.fft.ifft2(spectrum * ((frequency >= lowest) & (frequency <= highest))))
    return noise / np.abs(noise).max()


def bumps():
    """Hammered metal, 16 bits: steps of 8 bits would be seen as facets."""
    height = 0.5 + 0.5 * periodic_noise(128, 3, 2, 5)
    Image.fromarray((height * 65535 + 0.5).astype(np.uint16)).save(os.path.join(FOLDER, "bumps.png"), optimize=True)


def tiles():
    """Normals of a tile with bevelled edges."""
    u, v = unit_square(64, 64)
    x, y = (0.62 * np.sign(c) * np.clip((np.abs(c) - 0.72) / 0.28, 0, 1) for c in (2 * u - 1, 2 * v - 1))
    z = np.sqrt(np.maximum(0.05, 1 - x * x - y * y))
    normals = np.stack([x, y, z], axis=-1)
    save("tiles.png", 0.5 + 0.5 * normals / np.linalg.norm(normals, axis=-1, keepdims=True))


def holes():
    u, v = unit_square(64, 64)
    save("holes.png", (np.hypot(u - 0.5, v - 0.5) - 0.33) * 64 / 1.5 + 0.5)


def leaf():
    """A leaf with its veins; opacity in the fourth channel."""
    width, height, fine = 192, 156, 4
    u, v = unit_square(width * fine, height * fine)
    v = (v - 0.5) * height / width
    along = np.clip((u - 0.06) / 0.88, 0, 1)
    half_width = 0.34 * np.sin(np.pi * along**0.72) ** 0.9 * (1 - 0.25 * along)
    blade = (np.abs(v) < half_width) & (u > 0.06) & (u < 0.94)
    stalk = (np.abs(v) < 0.012) & (u < 0.12) & (u > 0.005)
    phase = 11 * (u - 0.9 * np.abs(v))
    side_veins = np.exp(-(((phase - np.round(phase)) / 0.10) ** 2)) * (np.abs(v) > 0.004)
    vein = np.maximum(np.exp(-((v / 0.006) ** 2)), 0.65 * side_veins)[..., None]
    grain = np.kron(periodic_noise(256, 5, 6, 14), np.ones((4, 4)))[: height * fine, : width * fine, None]
    colour = np.array([0.36, 0.60, 0.20]) * (1 + 0.10 * grain) * (1 - vein) + np.array([0.62, 0.74, 0.38]) * vein
    picture = np.dstack([colour, (blade | stalk).astype(float)])
    save("leaf.png", picture.reshape(height, fine, width, fine, 4).mean(axis=(1, 3)))


def screen():
    """Colour bars."""
    bars = 0.75 * np.array([(1, 1, 1), (1, 1, 0), (0, 1, 1), (0, 1, 0), (1, 0, 1), (1, 0, 0), (0, 0, 1)])
    u, _ = unit_square(128, 72)
    save("screen.png", bars[(u * 7).astype(int)])


def slide():
    """A round window of coloured panes."""
    u, v = unit_square(128, 128)
    x, y = 2 * u - 1, 2 * v - 1
    radius, sector = np.hypot(x, y), np.arctan2(y, x) / (2 * np.pi) * 12
    panes = np.array(
        [(0.9, 0.25, 0.12), (0.95, 0.7, 0.15), (0.15, 0.55, 0.25), (0.12, 0.35, 0.8), (0.5, 0.2, 0.7), (0.85, 0.85, 0.8)]
    )
    picture = np.where((radius < 0.3)[..., None], panes[5], panes[(sector % 6).astype(int)])
    lead = ((np.abs(sector % 1 - 0.5) > 0.46) & (radius > 0.3)) | (np.abs(radius - 0.3) < 0.03) | (radius > 0.92)
    save("slide.png", np.where(lead[..., None], 0.02, picture))


def downlight():
    """A luminaire with a bat-wing distribution."""
    angles = [0, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 70, 90]
    candela = [900, 960, 1100, 1350, 1700, 1950, 1800, 1300, 800, 420, 200, 90, 40, 10, 0]
    with open(os.path.join(FOLDER, "downlight.ies"), "w", encoding="ascii") as f:
        f.write("IESNA:LM-63-2002\n[LUMINAIRE] Recessed downlight with a bat-wing distribution\nTILT=NONE\n")
        f.write(f"1 1000 1 {len(angles)} 1 1 2 0 0 0\n1 1 20\n")
        f.write(" ".join(map(str, angles)) + "\n0\n" + " ".join(map(str, candela)) + "\n")


def evening():
    """A panorama of the sky at sunset, +y up, the sun in its middle column."""
    u, v = unit_square(128, 64)
    azimuth, polar = 2 * np.pi * (u - 0.5), np.pi * v
    elevation = np.pi / 2 - polar
    height = 0.14
    toward = np.cos(elevation) * np.cos(height) * np.cos(azimuth) + np.sin(elevation) * np.sin(height)
    angle = np.arccos(np.clip(toward, -1, 1))
    near = (0.5 + 0.5 * toward)[..., None]
    horizon = np.array([0.42, 0.36, 0.44]) * (1 - near) + np.array([0.95, 0.50, 0.24]) * near
    low = np.exp(-np.maximum(elevation, 0) / 0.3)[..., None]
    sky = np.array([0.10, 0.20, 0.48]) * (1 - low) + horizon * low
    sky += np.exp(-((angle / 0.45) ** 1.3))[..., None] * np.array([1.1, 0.5, 0.15])
    sky += np.exp(-((angle / 0.075) ** 2))[..., None] * np.array([160, 95, 42])
    sky = np.where((elevation < 0)[..., None], np.array([0.10, 0.085, 0.075]), sky)
    header = {"compression": OpenEXR.PIZ_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"RGB": sky.astype(np.float16)}).write(os.path.join(FOLDER, "evening.exr"))


def main():
    os.makedirs(FOLDER, exist_ok=True)
    for make in (bumps, tiles, holes, leaf, screen, slide, downlight, evening):
        make()


if __name__ == "__main__":
    main()
