"""Makes the OpenEXR files in src/test/resources with the official library (wheels OpenEXR==3.5.3 and numpy).

Run from any directory: python3 make_fixtures.py. The sample values follow the formulas smooth(), noise(), noise24() and
ramp(), which TestPatterns.java repeats, so that the tests can compare every sample bit by bit. Tiled images with several
levels and interleaved parts are beyond the wheel; ../cpp/tiled_images.cpp makes those.
"""

import pathlib

import numpy as np
import OpenEXR

OUT = pathlib.Path(__file__).resolve().parents[1] / "resources" / "org" / "daybreak" / "exr"
TYPES = {"half": np.float16, "float": np.float32, "uint": np.uint32}


def grid(width, height):
    return np.meshgrid(np.arange(width, dtype=np.uint32), np.arange(height, dtype=np.uint32))


def smooth(width, height, k, kind):
    """Multiples of 1/16 up to 8, exact in each type (unsigned integers: the multiple plus 128)."""
    x, y = grid(width, height)
    step = (x * 3 + y * 5 + np.uint32(k) * 7) % 257
    if kind == "uint":
        return step.astype(np.uint32)
    return ((step.astype(np.int32) - 128) / 16).astype(TYPES[kind])


def noise(width, height, k, kind):
    """Arbitrary bit patterns: NaN, infinities and denormals included, and nothing that deflate could pack."""
    x, y = grid(width, height)
    with np.errstate(over="ignore"):
        bits = x * np.uint32(0x9E3779B1) + y * np.uint32(0x85EBCA77)
        bits = bits + np.uint32(k) * np.uint32(0xC2B2AE3D) + np.uint32(0x27D4EB2F)
        bits = (bits ^ (bits >> np.uint32(15))) * np.uint32(0x2C1B3C6D)
        bits = (bits ^ (bits >> np.uint32(12))) * np.uint32(0x297A2D39)
        bits = bits ^ (bits >> np.uint32(15))
    if kind == "half":
        return (bits >> np.uint32(16)).astype(np.uint16).view(np.float16)
    return bits.view(TYPES[kind])


def noise24(width, height, k, kind):
    """Noise whose lowest byte is 0: floats that PXR24 keeps as they are."""
    bits = noise(width, height, k, kind)
    return (bits.view(np.uint32) & np.uint32(0xFFFFFF00)).view(TYPES[kind]) if kind != "half" else bits


def ramp(width, height, k, kind):
    """Counts the pixels: many different words that still pack well, for which PIZ uses its other wavelet."""
    x, y = grid(width, height)
    bits = x + y * np.uint32(width) + np.uint32(k)
    return bits.astype(np.uint16).view(np.float16) if kind == "half" else bits.view(TYPES[kind])


def planes(width, height, names, pattern):
    """names maps each channel to its type; k counts the channels in sorted order."""
    return {name: pattern(width, height, k, names[name]) for k, name in enumerate(sorted(names))}


def write(name, channels, compression, **header):
    header = {"compression": compression, "type": OpenEXR.scanlineimage, **header}
    OpenEXR.File(header, channels).write(str(OUT / (name + ".exr")))


def window(x, y, width, height):
    return (np.array([x, y], np.int32), np.array([x + width - 1, y + height - 1], np.int32))


def readable():
    rgb = lambda kind: {"R": kind, "G": kind, "B": kind}
    for code in ("no", "rle", "zips", "zip", "piz", "pxr24"):
        compression = getattr(OpenEXR, code.upper() + "_COMPRESSION")
        name = "none" if code == "no" else code
        for kind in TYPES:
            # PXR24 rounds floats, so that noise of 32 bits would not come back.
            for pattern in (smooth, noise24 if code == "pxr24" and kind == "float" else noise):
                write(f"{name}_{kind}_{pattern.__name__}", planes(17, 35, rgb(kind), pattern), compression)
    for kind in TYPES:
        write(f"piz_{kind}_ramp", planes(640, 33, {"Y": kind}, ramp), OpenEXR.PIZ_COMPRESSION)
    tiles = OpenEXR.TileDescription()
    tiles.xSize, tiles.ySize = 16, 8
    OpenEXR.File(
        {"type": OpenEXR.tiledimage, "tiles": tiles, "compression": OpenEXR.ZIP_COMPRESSION},
        planes(37, 21, rgb("half"), smooth),
    ).write(str(OUT / "tiled_smooth.exr"))
    parts = [
        OpenEXR.Part({"type": OpenEXR.scanlineimage, "compression": compression}, planes(9, 21, rgb(kind), smooth), name)
        for name, kind, compression in (
            ("left", "half", OpenEXR.ZIP_COMPRESSION),
            ("right", "float", OpenEXR.PIZ_COMPRESSION),
        )
    ]
    OpenEXR.File(parts).write(str(OUT / "parts_smooth.exr"))
    write("one_pixel", planes(1, 1, {"Y": "half"}, smooth), OpenEXR.ZIP_COMPRESSION)
    write(
        "negative_origin",
        planes(17, 20, {"Y": "half", "Z": "float"}, smooth),
        OpenEXR.ZIP_COMPRESSION,
        dataWindow=window(-5, -7, 17, 20),
        displayWindow=window(0, 0, 10, 12),
        pixelAspectRatio=1.5,
        screenWindowCenter=np.array([0.25, -0.5], np.float32),
        screenWindowWidth=2.0,
    )
    write(
        "decreasing",
        planes(13, 37, rgb("half"), smooth),
        OpenEXR.ZIP_COMPRESSION,
        dataWindow=window(3, -2, 13, 37),
        displayWindow=window(0, 0, 20, 40),
        lineOrder=OpenEXR.DECREASING_Y,
    )
    write(
        "layers",
        planes(
            9,
            21,
            {
                "A": "half",
                "B": "half",
                "G": "half",
                "R": "half",
                "Z": "float",
                "albedo.B": "half",
                "albedo.G": "half",
                "albedo.R": "half",
                "id": "uint",
                "light.key.R": "float",
                "a channel whose name is longer than 31 bytes.Y": "float",
            },
            smooth,
        ),
        OpenEXR.ZIPS_COMPRESSION,
        anInt=-7,
        aFloat=0.5,
        aString="Daybreak \u2013 \u00fcber",
        renderer="path",
        aV2i=np.array([3, -4], np.int32),
        aV2f=np.array([0.25, -4], np.float32),
        aBox2i=window(1, 2, 3, 4),
        aBox2f=(np.array([0.5, 1], np.float32), np.array([2, 3], np.float32)),
        chromaticities=(0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290),
        aMatrix=np.arange(9, dtype=np.float32).reshape(3, 3),
    )


def refused():
    small = lambda: planes(8, 8, {"R": "half", "G": "half", "B": "half"}, smooth)
    for name in ("B44", "B44A", "DWAA", "DWAB", "HTJ2K256", "HTJ2K32", "ZSTD"):
        write("refused_" + name.lower(), small(), getattr(OpenEXR, name + "_COMPRESSION"))
    deep = np.empty((2, 2), object)
    for i in range(4):
        deep[i // 2, i % 2] = np.array([1.0] * (i + 1), np.float32)
    OpenEXR.File(
        {"type": OpenEXR.deepscanline, "compression": OpenEXR.ZIPS_COMPRESSION}, {"Z": deep}
    ).write(str(OUT / "refused_deep.exr"))


if __name__ == "__main__":
    OUT.mkdir(parents=True, exist_ok=True)
    readable()
    refused()
