"""Writes the reference values that MitsubaComparisonTest reads, with Mitsuba 3 (pip install mitsuba; made with 3.9.1).

usage: python3 mitsuba_materials.py DIRECTORY    (core/src/test/resources/org/daybreak/core/material)

mitsuba-values.csv    material, wo, wi, f cos (rgb), density     non-delta lobes; wo is Mitsuba's wi and the reverse
mitsuba-samples.csv   material, wo, number, wi, weight, density  delta materials, one lobe number each
mitsuba-textures.csv  texture, u, v, rgb

Material and texture names stand for the parameters below; MitsubaComparisonTest builds the same.
"""

import math
import os
import random
import sys

import mitsuba as mi

mi.set_variant("scalar_rgb")

ETA = {"type": "rgb", "value": [0.2, 0.9, 1.4]}
K = {"type": "rgb", "value": [3.9, 2.4, 1.6]}
TINT = {"type": "rgb", "value": [0.75, 0.5, 0.9]}
BASE = {"type": "rgb", "value": [0.8, 0.4, 0.1]}


def rough(distribution, alpha):
    return {
        "type": "roughconductor",
        "distribution": distribution,
        "alpha": alpha,
        "eta": ETA,
        "k": K,
        "specular_reflectance": TINT,
    }


def plastic(nonlinear):
    return {
        "type": "plastic",
        "int_ior": 1.5,
        "ext_ior": 1.0,
        "diffuse_reflectance": BASE,
        "specular_reflectance": TINT,
        "nonlinear": nonlinear,
    }


def stretched(distribution):
    material = rough(distribution, 0.1)
    del material["alpha"]
    return material | {"alpha_u": 0.1, "alpha_v": 0.5}


def rough_dielectric(distribution, **alpha):
    return {
        "type": "roughdielectric",
        "distribution": distribution,
        "int_ior": 1.5,
        "ext_ior": 1.0,
        "specular_reflectance": TINT,
        "specular_transmittance": BASE,
    } | alpha


def principled(**parameters):
    return {"type": "principled", "base_color": BASE} | parameters


def principled_thin(**parameters):
    return {"type": "principledthin", "base_color": BASE} | parameters


CONTINUOUS = {
    "diffuse": {"type": "diffuse", "reflectance": BASE},
    "ggx0.12": rough("ggx", 0.12),
    "ggx0.6": rough("ggx", 0.6),
    "beckmann0.12": rough("beckmann", 0.12),
    "beckmann0.6": rough("beckmann", 0.6),
    "plastic": plastic(False),
    "plastic-nonlinear": plastic(True),
    "twosided": {"type": "twosided", "bsdf": rough("ggx", 0.6)},
    "ggx-stretched": stretched("ggx"),
    "beckmann-stretched": stretched("beckmann"),
    "glass-ggx": rough_dielectric("ggx", alpha=0.3),
    "glass-ggx-stretched": rough_dielectric("ggx", alpha_u=0.15, alpha_v=0.5),
    "glass-beckmann": rough_dielectric("beckmann", alpha=0.3),
    "principled": principled(),
    "principled-metal": principled(metallic=1.0, roughness=0.4, anisotropic=0.7, eta=1.5),
    "principled-glass": principled(spec_trans=1.0, roughness=0.5, eta=1.5),
    "principled-coat": principled(clearcoat=1.0, clearcoat_gloss=0.2, roughness=0.6, spec_tint=0.3, metallic=0.2),
    "principled-all": principled(
        roughness=0.5,
        anisotropic=0.5,
        metallic=0.3,
        spec_trans=0.4,
        eta=1.4,
        spec_tint=0.6,
        sheen=0.7,
        sheen_tint=0.5,
        flatness=0.4,
        clearcoat=0.8,
        clearcoat_gloss=0.1,
    ),
    "thin-all": principled_thin(
        roughness=0.4,
        spec_trans=0.5,
        eta=1.5,
        spec_tint=0.4,
        sheen=0.5,
        sheen_tint=0.3,
        flatness=0.5,
        diff_trans=0.8,
    ),
    "thin-pane": principled_thin(roughness=0.5, anisotropic=0.6, spec_trans=1.0, eta=1.4),
    "thin-paper": principled_thin(roughness=0.5, diff_trans=1.0),
    "blend": {"type": "blendbsdf", "weight": 0.3, "a": rough("ggx", 0.6), "b": {"type": "diffuse", "reflectance": BASE}},
    "normalmap": {
        "type": "normalmap",
        "flip_invalid_normals": False,
        "normalmap": {
            "type": "bitmap",
            "bitmap": mi.Bitmap(mi.TensorXf([0.65, 0.4, 0.9], (1, 1, 3))),
            "raw": True,
        },
        "bsdf": {"type": "diffuse", "reflectance": BASE},
    },
}

# Every fourth pair of these passes through, near the refracted direction for the index 1.5.
TRANSMISSIVE = ("glass", "principled-glass", "principled-all", "thin")

DELTA = {
    "conductor": {"type": "conductor", "eta": ETA, "k": K, "specular_reflectance": TINT},
    "dielectric": {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0, "specular_transmittance": TINT},
    "thindielectric": {"type": "thindielectric", "int_ior": 1.5, "ext_ior": 1.0, "specular_transmittance": TINT},
}


def bitmap(wrap, filter_type, transform=None):
    width, height = 5, 4
    pixels = [[[((7 * x + 3 * y + 5 * c) % 11) / 10 for c in range(3)] for x in range(width)] for y in range(height)]
    texture = {
        "type": "bitmap",
        "bitmap": mi.Bitmap(mi.TensorXf([v for row in pixels for p in row for v in p], (height, width, 3))),
        "raw": True,
        "format": "variant",
        "wrap_mode": wrap,
        "filter_type": filter_type,
    }
    if transform is not None:
        texture["to_uv"] = mi.ScalarTransform3f(transform)
    return texture


def checkerboard(transform=None):
    texture = {"type": "checkerboard", "color0": BASE, "color1": TINT}
    if transform is not None:
        texture["to_uv"] = mi.ScalarTransform3f(transform)
    return texture


# u' = 1.5 u + 0.25 v + 0.1, v' = -0.5 u + 2 v - 0.3
AFFINE = [[1.5, 0.25, 0.1], [-0.5, 2.0, -0.3], [0, 0, 1]]

TEXTURES = {
    f"{filter_type}-{wrap}": bitmap(wrap, filter_type)
    for filter_type in ("bilinear", "nearest")
    for wrap in ("repeat", "mirror", "clamp")
}
TEXTURES["bilinear-affine"] = bitmap("repeat", "bilinear", AFFINE)
TEXTURES["checkerboard"] = checkerboard()
TEXTURES["checkerboard-affine"] = checkerboard(AFFINE)


def direction(rng, down):
    cosine = rng.random() ** 2
    phi = 2 * math.pi * rng.random()
    sine = math.sqrt(1 - cosine * cosine)
    return [sine * math.cos(phi), sine * math.sin(phi), -cosine if down else cosine]


def interaction(wo):
    si = mi.SurfaceInteraction3f()
    si.wi = mi.Vector3f(wo)
    si.n = mi.Normal3f(0, 0, 1)
    si.sh_frame = mi.Frame3f(mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0), mi.Normal3f(0, 0, 1))
    si.dp_du = mi.Vector3f(1.5, 0, 0)
    si.dp_dv = mi.Vector3f(0.25, -0.8, 0)
    return si


def number(x):
    return f"{float(x):.9g}"


def line(name, *values):
    return name + "," + ",".join(number(x) for x in values)


def write(path, header, lines):
    with open(path, "w", encoding="ascii") as file:
        file.write(header + "\n" + "\n".join(lines) + "\n")


def values():
    rng = random.Random(1)
    context = mi.BSDFContext()
    for name, description in CONTINUOUS.items():
        bsdf = mi.load_dict(description)
        for i in range(40):
            wo = direction(rng, down=i % 8 == 7)
            if i % 2 == 0:
                # Near the mirror direction, where rough conductors have their light.
                wi = [-wo[0] + 0.2 * rng.gauss(0, 1), -wo[1] + 0.2 * rng.gauss(0, 1), abs(wo[2]) + 0.05]
                length = math.sqrt(sum(x * x for x in wi))
                wi = [x / length for x in wi]
                if wo[2] < 0:
                    wi[2] = -wi[2]
            else:
                wi = direction(rng, down=i % 8 >= 6)
            if name.startswith(TRANSMISSIVE) and i % 4 == 1:
                eta = 1.5 if wo[2] > 0 else 1 / 1.5
                x, y = (-wo[j] / eta + 0.1 * rng.gauss(0, 1) for j in (0, 1))
                shrink = min(1, 0.99 / math.hypot(x, y))
                x, y = shrink * x, shrink * y
                wi = [x, y, -math.copysign(math.sqrt(1 - x * x - y * y), wo[2])]
            si = interaction(wo)
            f = bsdf.eval(context, si, mi.Vector3f(wi))
            yield line(name, *wo, *wi, *f, bsdf.pdf(context, si, mi.Vector3f(wi)))


def samples():
    rng = random.Random(2)
    for name, description in DELTA.items():
        bsdf = mi.load_dict(description)
        for i in range(24):
            wo = direction(rng, down=i % 2 == 1)
            w = rng.random() if i % 4 < 2 else 0.02 * rng.random()
            sample, weight = bsdf.sample(mi.BSDFContext(), interaction(wo), w, mi.Point2f(0.3, 0.6))
            yield line(name, *wo, w, *sample.wo, *weight, sample.pdf)


def textures():
    rng = random.Random(3)
    for name, description in TEXTURES.items():
        texture = mi.load_dict(description)
        for _ in range(25):
            si = mi.SurfaceInteraction3f()
            # Multiples of 2^-16 are the same numbers in single precision.
            u, v = (math.floor(rng.uniform(-2.5, 2.5) * 65536) / 65536 for _ in range(2))
            si.uv = mi.Point2f(u, v)
            yield line(name, u, v, *texture.eval(si))


def main():
    directory = sys.argv[1]
    write(os.path.join(directory, "mitsuba-values.csv"), "material,wox,woy,woz,wix,wiy,wiz,r,g,b,density", values())
    write(
        os.path.join(directory, "mitsuba-samples.csv"),
        "material,wox,woy,woz,number,wix,wiy,wiz,r,g,b,density",
        samples(),
    )
    write(os.path.join(directory, "mitsuba-textures.csv"), "texture,u,v,r,g,b", textures())


if __name__ == "__main__":
    main()
