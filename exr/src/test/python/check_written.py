"""Reads the files that OfficialLibraryTest has written, with the official library, and compares all samples bit by bit.

Usage: python3 check_written.py DIRECTORY. File names are COMPRESSION_TYPE_PATTERN_WIDTHxHEIGHT.exr,
COMPRESSION_tiles_PATTERN_LEVELS-ROUNDING.exr, COMPRESSION_parts_PATTERN_COUNT.exr, and layers.exr. Of reduced levels the
wheel reads none; tiled_images.cpp checks those.
"""

import pathlib
import sys

import numpy as np
import OpenEXR

from make_fixtures import planes, noise, smooth


def check_planes(file, expected, where, channels=None):
    channels = channels or file.channels()
    assert sorted(channels) == sorted(expected), (where, sorted(channels))
    for name, samples in expected.items():
        got = channels[name].pixels
        assert got.dtype == samples.dtype and got.shape == samples.shape, (where, name, got.dtype, got.shape)
        assert got.tobytes() == samples.tobytes(), (where, name)


PATTERNS = {"smooth": smooth, "noise": noise}
MIXED = {"B": "float", "G": "half", "id": "uint"}


def check_header(header, compression, width, height, where):
    assert header["compression"].name.split("_")[0] == {"none": "NO"}.get(compression, compression.upper()), where
    assert [v.tolist() for v in header["dataWindow"]] == [[-3, 5], [width - 4, height + 4]], (where, header)
    assert [v.tolist() for v in header["displayWindow"]] == [[0, 0], [99, 49]], (where, header)


def check_pattern(path):
    compression, kind, pattern, rest = path.stem.split("_", 3)
    file = OpenEXR.File(str(path), separate_channels=True)
    if kind == "parts":
        assert [part.name() for part in file.parts] == ["left", "right", "depth"], path
        for i, (part, size) in enumerate(zip(file.parts, ((9, 21), (10, 20), (300, 200)))):
            check_header(part.header, compression, *size, path)
            expected = {
                name: PATTERNS[pattern](*size, 1000 * i + k, MIXED[name]) for k, name in enumerate(sorted(MIXED))
            }
            check_planes(file, expected, (path, i), part.channels)
        return
    if kind == "tiles":
        check_header(file.header(), compression, 13, 11, path)
        tiles = file.header()["tiles"]
        levels, rounding = rest.upper().split("-")
        assert (tiles.xSize, tiles.ySize) == (8, 5) and tiles.roundingMode.name == "ROUND_" + rounding, path
        assert tiles.mode.name == {"ONE_LEVEL": "ONE_LEVEL"}.get(levels, levels + "_LEVELS"), (path, tiles)
        check_planes(file, planes(13, 11, MIXED, PATTERNS[pattern]), path)
        return
    width, height = map(int, rest.split("x"))
    check_header(file.header(), compression, width, height, path)
    check_planes(file, planes(width, height, {"R": kind, "G": kind, "B": kind}, PATTERNS[pattern]), path)


def check_layers(path):
    file = OpenEXR.File(str(path), separate_channels=True)
    names = {
        "R": "half",
        "Z": "float",
        "albedo.R": "half",
        "id": "uint",
        "a channel whose name is longer than 31 bytes.Y": "float",
    }
    check_planes(file, planes(9, 21, names, smooth), path)
    header = file.header()
    assert header["renderer"] == "path \u2013 \u00fc", header
    assert header["samples"] == 64 and header["time"] == 1.5, header
    assert header["crop"][0].tolist() == [1, 2] and header["crop"][1].tolist() == [3, 4], header
    assert np.allclose(header["chromaticities"], (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)), header
    assert header["aMatrix"].tolist() == [[0, 1, 2], [3, 4, 5], [6, 7, 8]], header


if __name__ == "__main__":
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.exr"))
    for each in files:
        (check_layers if each.stem == "layers" else check_pattern)(each)
    print(len(files), "files agree")
