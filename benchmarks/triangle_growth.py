#!/usr/bin/env python3
"""Whether samples cost more with more triangles for any reason but intersection: CPU time per sample of a room with a bumpy ball of
2 to 10^6 triangles, split by a profile of the virtual machine into intersection (packages accel, and Intersector calls from them) and
the rest. The rest must stay the same.

Needs: `mvn -DskipTests package`; a JDK 25 for --java.
Usage: benchmarks/triangle_growth.py [--java PATH] [--renderer bidirectional] [--spp 32] [--most 6] [--runs 3]
"""

import argparse
import json
import math
import os
import re
import statistics
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

SCENE = """<scene version="3.0.0">
  <integrator type="path"/>
  <sensor type="perspective"><float name="fov" value="60"/>
    <transform name="to_world"><lookat origin="0,0,2.5" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="256"/><integer name="height" value="256"/><rfilter type="box"/></film>
  </sensor>
  <bsdf type="diffuse" id="grey"><rgb name="reflectance" value="0.6"/></bsdf>
  <shape type="cube"><boolean name="flip_normals" value="true"/>
    <transform name="to_world"><scale value="3"/></transform><ref id="grey"/></shape>
  <shape type="rectangle"><transform name="to_world"><rotate x="1" angle="90"/><translate y="2.9"/></transform>
    <ref id="grey"/><emitter type="area"><rgb name="radiance" value="20"/></emitter></shape>
  <shape type="ply"><string name="filename" value="ball.ply"/><ref id="grey"/></shape>
</scene>
"""


def write_ball(path, triangles):
    """A unit ball with bumps; with fewer than 32 triangles a square of two."""
    rows = max(1, round(math.sqrt(triangles / 4)))
    columns = 2 * rows
    points, faces = [], []
    if rows < 3:
        points = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
        faces = [(0, 1, 2), (0, 2, 3)]
    else:
        for j in range(rows + 1):
            for i in range(columns):
                theta, phi = math.pi * j / rows, 2 * math.pi * i / columns
                r = 1 + 0.05 * math.sin(9 * theta) * math.sin(11 * phi)
                points.append((r * math.sin(theta) * math.cos(phi), r * math.cos(theta), r * math.sin(theta) * math.sin(phi)))
        for j in range(rows):
            for i in range(columns):
                a, b = j * columns + i, j * columns + (i + 1) % columns
                faces += [(a, b, b + columns), (a, b + columns, a + columns)]
    with open(path, "w", encoding="ascii") as f:
        f.write(f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n")
        f.write("property float x\nproperty float y\nproperty float z\n")
        f.write(f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
        f.writelines("%g %g %g\n" % p for p in points)
        f.writelines("3 %d %d %d\n" % t for t in faces)
    return len(faces)


def measure(java, folder, renderer, spp):
    """CPU seconds of rendering, samples, rays, and the part of the profile that is intersection."""
    profile, stats = os.path.join(folder, "p.jfr"), os.path.join(folder, "s.json")
    command = [java, "--add-modules", "jdk.incubator.vector"]
    command += [f"-XX:StartFlightRecording=filename={profile},settings=profile", "-Xlog:disable", "-Xlog:all=error:stderr"]
    command += ["-jar", os.path.join(ROOT, "cli", "target", "daybreak.jar"), "render", os.path.join(folder, "scene.xml")]
    command += ["--renderer", renderer, "--spp", str(spp), "--progress", "none", "--stats", stats]
    command += ["-o", os.path.join(folder, "o.exr")]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    jfr = os.path.join(os.path.dirname(java), "jfr")
    text = subprocess.run(
        [jfr, "print", "--events", "jdk.ExecutionSample", "--stack-depth", "1", profile], check=True, capture_output=True, text=True
    ).stdout
    inside = total = 0
    for event in text.split("jdk.ExecutionSample")[1:]:
        if "daybreak-worker" not in event:
            continue
        total += 1
        inside += bool(re.search(r"org\.daybreak\.(core\.accel|accel\.vector)\.|jdk\.incubator\.vector|VectorSupport", event))
    with open(stats, encoding="utf-8") as f:
        report = json.load(f)
    return report["seconds"]["render"]["cpu"], report["samples"], report["raysTotal"], inside / total


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--java", default="java")
    parser.add_argument("--renderer", default="bidirectional")
    parser.add_argument("--spp", type=int, default=32)
    parser.add_argument("--most", type=int, default=6, help="power of ten of the number of triangles")
    parser.add_argument("--runs", type=int, default=3)
    arguments = parser.parse_args()
    print("triangles  samples/s/core  rays/sample  ns/sample: intersection    rest   (medians)")
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "scene.xml"), "w", encoding="utf-8") as f:
            f.write(SCENE)
        for power in range(arguments.most + 1):
            triangles = write_ball(os.path.join(folder, "ball.ply"), 10**power)
            rows = []
            for _ in range(arguments.runs):
                cpu, samples, rays, part = measure(arguments.java, folder, arguments.renderer, arguments.spp)
                per_sample = cpu / samples * 1e9
                rows.append((samples / cpu, rays / samples, per_sample * part, per_sample * (1 - part)))
            rate, rays, inside, rest = (statistics.median(column) for column in zip(*rows))
            print(f"{triangles:9d}  {rate:14.0f}  {rays:11.2f}  {inside:23.0f}  {rest:6.0f}", flush=True)


if __name__ == "__main__":
    main()
