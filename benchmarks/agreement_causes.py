#!/usr/bin/env python3
"""The numbers behind "Where the models differ" in docs/agreement.md, from Mitsuba's own functions and from quadrature.

Rough plastic: the reflectance of a rough coat from inside, as Mitsuba takes it (from values of its eval), by single
reflections and by what is not transmitted (Monte Carlo over visible normals, Heitz 2018).
Bump maps: values of a bump map over metal, before and after surface and directions are turned together.

Needs: python 3, `pip install mitsuba==3.9.1 numpy`.
"""

import os

import mitsuba as mi
import numpy as np

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "src", "test", "resources", "agreement")
SAMPLES = 400_000


def visible_normals(wo, alpha, rng):
    v = np.array([alpha * wo[0], 0, wo[2]])
    v /= np.linalg.norm(v)
    first = np.array([1.0, 0, 0]) if v[2] > 0.9999 else np.cross([0, 0, 1], v)
    first /= np.linalg.norm(first)
    second = np.cross(v, first)
    radius, angle = np.sqrt(rng.random(SAMPLES)), 2 * np.pi * rng.random(SAMPLES)
    a, b = radius * np.cos(angle), radius * np.sin(angle)
    s = (1 + v[2]) / 2
    b = (1 - s) * np.sqrt(1 - a * a) + s * b
    normals = np.outer(a, first) + np.outer(b, second) + np.outer(np.sqrt(np.maximum(0, 1 - a * a - b * b)), v)
    normals[:, :2] *= alpha
    return normals / np.linalg.norm(normals, axis=1, keepdims=True)


def fresnel(cosine, eta):
    squared_sine = (1 - cosine**2) / eta**2
    refracted = np.sqrt(np.maximum(0, 1 - squared_sine))
    perpendicular = (cosine - eta * refracted) / np.maximum(cosine + eta * refracted, 1e-12)
    parallel = (eta * cosine - refracted) / np.maximum(eta * cosine + refracted, 1e-12)
    return np.where(squared_sine >= 1, 1, (perpendicular**2 + parallel**2) / 2), refracted


def masking(z, alpha):
    return 2 / (1 + np.sqrt(1 + alpha**2 * (1 - z**2) / np.maximum(z**2, 1e-12)))


def facets(cosine, alpha, eta, rng):
    """Transmittance and reflectance of a GGX interface for one direction, single scattering."""
    wo = np.array([np.sqrt(1 - cosine**2), 0, cosine])
    m = visible_normals(wo, alpha, rng)
    c = np.maximum(m @ wo, 0)
    reflectance, refracted = fresnel(c, eta)
    below = -((c / eta - refracted) * m[:, 2] - wo[2] / eta)
    above = 2 * c * m[:, 2] - wo[2]
    transmitted = np.where((c > 0) & (below > 0), (1 - reflectance) * masking(below, alpha), 0)
    reflected = np.where((c > 0) & (above > 0), reflectance * masking(above, alpha), 0)
    return transmitted.mean(), reflected.mean()


def rough_plastic(alpha, eta):
    rng = np.random.default_rng(1)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    nodes, weights = (nodes + 1) / 2, weights / 2 * (nodes + 1)
    outside = np.array([facets(c, alpha, eta, rng) for c in nodes])
    inside = np.array([facets(c, alpha, 1 / eta, rng) for c in nodes])
    transmittance, from_inside, single = weights @ outside[:, 0], weights @ inside[:, 0], weights @ inside[:, 1]

    def value(albedo):
        coat = {"distribution": "ggx", "alpha": alpha, "int_ior": eta, "ext_ior": 1.0}
        bsdf = mi.load_dict({"type": "roughplastic", "diffuse_reflectance": {"type": "rgb", "value": albedo}} | coat)
        point = mi.SurfaceInteraction3f()
        point.wi = mi.Vector3f(0, 0, 1)
        return bsdf.eval(mi.BSDFContext(), point, mi.Vector3f(np.sqrt(0.75), 0, 0.5))[0]

    base = value(1.0) - value(0.0)
    passed = facets(1.0, alpha, eta, rng)[0] * facets(0.5, alpha, eta, rng)[0]
    theirs = 1 - passed * 0.5 / (np.pi * eta**2 * base)
    ours = 1 - transmittance / eta**2
    print(f"rough plastic, GGX, alpha {alpha}, eta {eta}:")
    print(f"  transmittance from inside {from_inside:.4f}, from outside over eta squared {transmittance / eta**2:.4f}")
    print(f"  reflectance from inside: single {single:.4f}, Mitsuba {theirs:.4f}, what is not transmitted {ours:.4f}")
    print(f"  base, ours over Mitsuba's: {(1 - theirs) / (1 - ours):.3f}")


def bump_map(alpha_u, alpha_v):
    index = {"eta": {"type": "rgb", "value": [0.2, 0.9, 1.4]}, "k": {"type": "rgb", "value": [3.9, 2.4, 1.6]}}
    metal = {"type": "roughconductor", "distribution": "ggx", "alpha_u": alpha_u, "alpha_v": alpha_v} | index
    texture = {"type": "bitmap", "filename": os.path.join(FOLDER, "bumps.png"), "raw": True}
    bsdf = mi.load_dict({"type": "bumpmap", "scale": 0.05, "flip_invalid_normals": False, "t": texture, "b": metal})
    a, b = 0.7, 1.1
    turn = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    tilt = np.array([[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]])
    values = []
    for axes in (np.eye(3), turn @ tilt):
        s, t, n = (mi.Vector3f(*axes[:, k]) for k in range(3))
        point = mi.SurfaceInteraction3f()
        point.uv = mi.Point2f(0.4, 0.55)
        point.n, point.sh_frame = mi.Normal3f(n), mi.Frame3f(s, t, mi.Normal3f(n))
        point.dp_du, point.dp_dv = 2 * s, 2 * t
        # Directions are given in the frame of the surface, so they turn with it.
        point.wi = mi.Vector3f(0.3, 0.2, np.sqrt(0.87))
        values.append(bsdf.eval(mi.BSDFContext(), point, mi.Vector3f(-0.35, 0.1, np.sqrt(0.8675)))[0])
    print(f"bump map over metal, alpha_u {alpha_u}, alpha_v {alpha_v}: {values[0]:.4f}, turned {values[1]:.4f}")


def main():
    mi.set_variant("scalar_rgb")
    rough_plastic(0.2, 1.5)
    rough_plastic(0.12, 1.9)
    bump_map(0.2, 0.2)
    bump_map(0.15, 0.4)


if __name__ == "__main__":
    main()
