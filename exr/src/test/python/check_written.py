"""Reads the files that OfficialLibraryTest has written, with the official library, and compares all samples bit by bit.

Usage: python3 check_written.py DIRECTORY. File names are COMPRESSION_TYPE_PATTERN_WIDTHxHEIGHT.exr, and layers.exr.
"""

import pathlib
import sys

import numpy as np
import OpenEXR

from make_fixtures import planes, noise, smooth


def check_planes(file, expected, where):
    channels = file.channels()
    assert sorted(channels) == sorted(expected), (where, sorted(channels))
    for name, samples in expected.items():
        got = channels[name].pixels
        assert got.dtype == samples.dtype and got.shape == samples.shape, (where, name, got.dtype, got.shape)
        assert got.tobytes() == samples.tobytes(), (where, name)


def check_pattern(path):
    compression, kind, pattern, size = path.stem.split("_")
    width, height = map(int, size.split("x"))
    file = OpenEXR.File(str(path), separate_channels=True)
    header = file.header()
    assert header["compression"].name.split("_")[0] == {"none": "NO"}.get(compression, compression.upper()), path
    assert [v.tolist() for v in header["dataWindow"]] == [[-3, 5], [width - 4, height + 4]], (path, header)
    assert [v.tolist() for v in header["displayWindow"]] == [[0, 0], [99, 49]], (path, header)
    pattern = {"smooth": smooth, "noise": noise}[pattern]
    check_planes(file, planes(width, height, {"R": kind, "G": kind, "B": kind}, pattern), path)


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
