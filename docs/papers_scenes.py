#!/usr/bin/env python3
"""Makes the example scenes of [Ph73], [PA90] and [P93]: docs/papers_scenes.py FOLDER [TIMES]

Spheres, cylinders and cones are OBJ meshes beside the scenes. Sizes that the papers do not give are ours. TIMES makes the
spheres, and what stands beside them, so many times as fine, to see what that changes: see gallery.sh.
"""
import json
import math
import pathlib
import sys


TIMES = int(sys.argv[2]) if len(sys.argv) > 2 else 1


def rounded(p):
    return [round(x, 6) for x in p]


def obj(vertices, facets):
    lines = ["v " + " ".join(f"{x:.5f}" for x in v) for v in vertices]
    return "\n".join(lines + ["f " + " ".join(str(i + 1) for i in f) for f in facets]) + "\n"


def sphere(rings, segments, radius=1.0, centre=(0, 0, 0)):
    """Closed, in triangles; the poles lie on the z axis."""
    vertices = [(0, 0, 1)]
    for i in range(1, rings):
        a = math.pi * i / rings
        for k in range(segments):
            b = 2 * math.pi * k / segments
            vertices.append((math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a)))
    vertices.append((0, 0, -1))
    at = lambda i, k: 1 + (i - 1) * segments + k % segments
    facets = [(0, at(1, k), at(1, k + 1)) for k in range(segments)]
    for i in range(1, rings - 1):
        for k in range(segments):
            facets += [(at(i, k), at(i + 1, k), at(i + 1, k + 1)), (at(i, k), at(i + 1, k + 1), at(i, k + 1))]
    facets += [(len(vertices) - 1, at(rings - 1, k + 1), at(rings - 1, k)) for k in range(segments)]
    moved = [tuple(c + radius * x for c, x in zip(centre, v)) for v in vertices]
    return obj(moved, facets)


def cylinder(sides, radius=1.0, height=3.0, x=0.0, closed=True):
    """Standing on z = 0; sides in two triangles each."""
    vertices, facets = [], []
    for z in (0, height):
        for k in range(sides):
            b = 2 * math.pi * (k + 0.5) / sides - math.pi / 2
            vertices.append((x + radius * math.cos(b), radius * math.sin(b), z))
    for k in range(sides):
        a, b = k, (k + 1) % sides
        facets += [(a, b, sides + b), (a, sides + b, sides + a)]
    if closed:
        facets += [tuple(range(sides, 2 * sides)), tuple(range(sides - 1, -1, -1))]
    return obj(vertices, facets)


def cone(sides, radius=1.2, height=3.0, x=0.0):
    """In rows, so that the normals at its tip are each of a facet's side."""
    rows, vertices, facets = 6, [], []
    for i in range(rows):
        r, z = radius * (1 - i / rows), height * i / rows
        for k in range(sides):
            b = 2 * math.pi * (k + 0.5) / sides - math.pi / 2
            vertices.append((x + r * math.cos(b), r * math.sin(b), z))
    vertices.append((x, 0, height))
    for i in range(rows):
        for k in range(sides):
            a, b = i * sides + k, i * sides + (k + 1) % sides
            if i + 1 < rows:
                facets += [(a, b, b + sides), (a, b + sides, a + sides)]
            else:
                facets.append((a, b, len(vertices) - 1))
    facets.append(tuple(range(sides - 1, -1, -1)))
    return obj(vertices, facets)


def far_light(x, y, z):
    """[Ph73]: light infinitely far away, of irradiance pi, so that a white surface across it has radiance 1."""
    return [{"name": "light", "shape": "direction", "direction": [x, y, z], "irradiance": round(math.pi, 12)}]


def camera(eye, look_at, fov, width, height):
    return {"eye": eye, "look_at": look_at, "fov": fov, "width": width, "height": height}


def scene(folder, name, **keys):
    document = {"gnomon": 1, "dimension": 3, **keys}
    text = json.dumps(document)
    for key in ("\"camera\"", "\"materials\"", "\"lights\"", "\"blockers\"", "\"receivers\""):
        text = text.replace(", " + key, ",\n " + key)
    text = text.replace("}, {\"name\"", "},\n  {\"name\"")
    (folder / (name + ".scene.json")).write_text(text + "\n")


def phong_scenes(folder):
    """Figures 1.7 and 2.4, 4.7, and the comparison rows of 4.16 to 4.20. k_d = C_p, k_s = W / pi, k_a L_a = C_p d."""
    paint = lambda name, colour, w, n: {"name": name, "model": "phong_classic", "diffuse": colour, "ambient": colour,
                                        "specular": round(w / math.pi, 9), "exponent": n}
    for figure, sides in (("1_7", (3, 4, 8, 12)), ("2_4", (8, 16, 32, 64))):
        meshes = []
        for k, n in enumerate(sides):
            file = f"phong_cylinder_{figure}_{n}.obj"
            (folder / file).write_text(cylinder(n, 1, 3, 2.6 * k, closed=False))
            meshes.append({"name": f"sides_{n}", "shape": "mesh", "file": file, "material": "white", "normals": "angle"})
        scene(folder, f"phong_{figure}", ambient_radiance=0.1, camera=camera([3.9, -16, 3.2], [3.9, 0, 1.5], 20, 640, 240),
              materials=[paint("white", 0.8, 0.2, 4)], lights=far_light(0.25, 1, -0.35), blockers=meshes)
    (folder / "phong_cone.obj").write_text(cone(12))
    scene(folder, "phong_4_7", ambient_radiance=0.1, camera=camera([0, -12, 2.6], [0, 0, 1.4], 20, 240, 280),
          materials=[paint("white", 0.8, 0.3, 4)], lights=far_light(0.6, 1, -0.4),
          blockers=[{"name": "cone", "shape": "mesh", "file": "phong_cone.obj", "material": "white", "normals": "angle",
                     "crease": 60}])
    bodies = []
    for row, (w, n) in enumerate(((0.2, 2), (0.6, 20))):
        x, kind = 0.0, "high" if row else "low"
        for name, text in (("cone", cone(48 * TIMES, 1, 2, 0)), ("cylinder", cylinder(48 * TIMES, 0.8, 2, 2.6)),
                           ("sphere", sphere(32 * TIMES, 64 * TIMES, 1, (5.2, 0, 1)))):
            lines = []
            for line in text.splitlines():  # the second row stands behind and above the first
                if line.startswith("v "):
                    a, b, c = map(float, line.split()[1:])
                    line = f"v {a:.5f} {b:.5f} {c + 2.6 * row:.5f}"
                lines.append(line)
            file = f"phong_{kind}_{name}.obj"
            (folder / file).write_text("\n".join(lines) + "\n")
            bodies.append({"name": f"{kind}_{name}", "shape": "mesh", "file": file, "material": kind, "normals": "angle",
                           "crease": 80})
            x += 2.6
    scene(folder, "phong_4_18", ambient_radiance=0.1, camera=camera([2.6, -18, 2.9], [2.6, 0, 2.3], 20, 480, 360),
          materials=[paint("low", [0.38, 0.3, 0.2], 0.2, 2), paint("high", [0.23, 0.3, 0.5], 0.6, 20)],
          lights=far_light(0.5, 1, -0.5), blockers=bodies)


floor = lambda size, z=0: {"name": "floor", "shape": "polygon", "material": "floor",
                           "vertices": [[-size, -size, z], [size, -size, z], [size, size, z], [-size, size, z]]}


def linear_light_scenes(folder):
    """[PA90] Plates 1 and 2, [P93] 3.11 to 3.14: light 10 long, 5 above a primitive that is 1 above a floor."""
    shiny = {"name": "shiny", "model": "phong_classic", "diffuse": [0.5, 0.15, 0.1], "specular": 0.4, "exponent": 64}
    ground = {"name": "floor", "model": "phong_classic", "diffuse": 0.5, "specular": 0.15, "exponent": 32}
    tube = [{"name": "tube", "shape": "segment", "vertices": [[-5, 0, 7], [5, 0, 7]], "intensity_per_length": 6}]
    (folder / "pa90_sphere.obj").write_text(sphere(24 * TIMES, 48 * TIMES, 1, (0, 0, 2)))
    scene(folder, "pa90_sphere", camera=camera([0, -11, 5], [0, 0, 1.2], 36, 400, 300), materials=[shiny, ground],
          lights=tube, receivers=[floor(12)],
          blockers=[{"name": "sphere", "shape": "mesh", "file": "pa90_sphere.obj", "material": "shiny", "normals": "angle"}])
    box = lambda name, x0, x1, y0, y1, z0, z1, material: {
        "name": name, "shape": "polytope", "material": material,
        "vertices": [[x, y, z] for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]}
    wood = {"name": "wood", "diffuse": [0.45, 0.3, 0.16], "ambient": [0.45, 0.3, 0.16], "specular": 0.1, "exponent": 20}
    paper = {"name": "paper", "diffuse": 0.75, "ambient": 0.75}
    steel = {"name": "steel", "model": "blinn", "diffuse": 0.15, "ambient": 0.15, "specular": 0.5, "exponent": 80}
    desk = [box("top", -2, 2, -1, 1, 1.4, 1.5, "wood")]
    for k, (x, y) in enumerate(((-1.9, -0.9), (1.8, -0.9), (1.8, 0.8), (-1.9, 0.8))):
        desk.append(box(f"leg_{k}", x, x + 0.1, y, y + 0.1, 0, 1.4, "steel"))
    desk += [box("book", -1.4, -0.7, -0.5, 0.3, 1.5, 1.65, "paper"), box("stand", 1.1, 1.3, 0.5, 0.7, 1.5, 3, "steel"),
             box("shade", -0.4, 1.3, 0.35, 0.85, 3, 3.1, "steel"), box("cup", 0.2, 0.5, -0.4, -0.1, 1.5, 1.9, "steel")]
    scene(folder, "p93_desk", ambient_radiance=0.12, camera=camera([4.2, -5.4, 4.4], [0, 0.1, 1.5], 34, 400, 300),
          materials=[wood, paper, steel, {"name": "floor", "diffuse": 0.5, "ambient": 0.5}],
          lights=[{"name": "lamp", "shape": "segment", "vertices": [[-0.3, 0.6, 2.95], [1.0, 0.6, 2.95]],
                   "intensity_per_length": 3}],
          blockers=desk, receivers=[floor(6)])
    lamps, tables = [], []
    for i, x in enumerate((-4, 0, 4)):
        for j, y in enumerate((-2, 3)):
            for k in (-0.2, 0.2):
                lamps.append({"name": f"tube_{i}{j}{'ab'[k > 0]}", "shape": "segment",
                              "vertices": [[x - 1, y + k, 4], [x + 1, y + k, 4]], "intensity_per_length": 1.5})
            tables.append(box(f"table_{i}{j}", x - 1.2, x + 1.2, y - 0.6, y + 0.6, 0.95, 1.05, "wood"))
            tables.append(box(f"foot_{i}{j}", x - 0.1, x + 0.1, y - 0.1, y + 0.1, 0, 0.95, "steel"))
    walls = [{"name": "back", "shape": "polygon", "material": "paper",
              "vertices": [[-7, 6, 0], [7, 6, 0], [7, 6, 4.2], [-7, 6, 4.2]]}]
    scene(folder, "p93_cafeteria", ambient_radiance=0.05, camera=camera([0, -12, 3.2], [0, 0, 1.3], 40, 400, 300),
          materials=[wood, paper, steel, {"name": "floor", "diffuse": 0.4, "ambient": 0.4, "specular": 0.3, "exponent": 60}],
          lights=lamps, blockers=tables, receivers=[floor(9)] + walls)


def lobe_scenes(folder):
    """[P93] 3.8: (R . L)^n of a linear light on a floor, n = 1 to 1000; 3.10: emissions and flaps."""
    stripes, materials = [], []
    for k, n in enumerate((1, 10, 100, 1000)):
        materials.append({"name": f"n{n}", "model": "phong_classic", "diffuse": 0, "specular": 1, "exponent": n})
        x = 5 * k
        stripes.append({"name": f"floor_{n}", "shape": "polygon", "material": f"n{n}",
                        "vertices": [[x, -4, 0], [x + 4.8, -4, 0], [x + 4.8, 6, 0], [x, 6, 0]]})
    tubes = [{"name": f"tube_{k}", "shape": "segment", "vertices": [[5 * k + 1.4, 3, 2], [5 * k + 3.4, 3, 2]]}
             for k in range(4)]
    scene(folder, "p93_3_8", camera=camera([9.9, -14, 9], [9.9, 1.5, 0], 42, 640, 280), materials=materials, lights=tubes,
          blockers=[], receivers=stripes)
    kinds = [{}, {"emission": {"profile": "cosine"}}, {"flaps": {"angle": 30}},
             {"shade": {"from": [0, -1, -1], "to": [0, 1, -1]}}]
    lights = [{"name": f"tube_{k}", "shape": "segment", "vertices": [[6 * k + 1.5, 0, 1.5], [6 * k + 3.5, 0, 1.5]], **kind}
              for k, kind in enumerate(kinds)]
    stripes = [{"name": f"floor_{k}", "shape": "polygon", "material": "floor",
                "vertices": [[6 * k, -4, 0], [6 * k + 5, -4, 0], [6 * k + 5, 4, 0], [6 * k, 4, 0]]} for k in range(4)]
    walls = [{"name": f"wall_{k}", "shape": "polygon", "material": "black",
              "vertices": [[6 * k + 5.5, -4, 0], [6 * k + 5.5, 4, 0], [6 * k + 5.5, 4, 4], [6 * k + 5.5, -4, 4]]}
             for k in range(3)]
    scene(folder, "p93_3_10", camera=camera([11.5, -2, 24], [11.5, 0, 0], 26, 640, 240), lights=lights, blockers=walls,
          receivers=stripes, materials=[{"name": "floor", "diffuse": 0.8}, {"name": "black", "diffuse": 0}])


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    phong_scenes(folder)
    linear_light_scenes(folder)
    lobe_scenes(folder)


if __name__ == "__main__":
    main()
