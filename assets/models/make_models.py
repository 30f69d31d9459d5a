"""Makes the models of this folder: closed all-quad skins, from formulas alone.

    blender --background --python assets/models/make_models.py -- [NAME ...]

An animal is a list of eggs and tubes. Their smooth union is a signed distance f(p); the surface
f = 0 is meshed coarsely (surface nets) for the half x >= 0, QuadriFlow turns that into quads, a
relaxation spreads them evenly over f = 0, and the half is mirrored. Bowl and pillow are grids that
are bent into shape. Units: all models stand on y = -1 and are about 2 high; y is up, z is ahead.
"""
import os
import sys
from itertools import product
import numpy as np

FLOOR = -1.0


# --- shapes: signed distances, negative inside ------------------------------------------------

def egg(centre, radii, tilt=0.0, roll=0.0):
    """Ellipsoid, tilted about x (nods ahead) and then rolled about z (leans to -x) [degrees]."""
    a, b = np.radians(tilt), np.radians(roll)
    nod = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    lean = np.array([[np.cos(b), -np.sin(b), 0], [np.sin(b), np.cos(b), 0], [0, 0, 1]])
    centre, radii, turn = np.array(centre, float), np.array(radii, float), lean @ nod

    def distance(p):
        q = (p - centre) @ turn
        near = np.linalg.norm(q / radii, axis=1)
        steep = np.linalg.norm(q / radii**2, axis=1)
        return near * (near - 1) / np.maximum(steep, 1e-9)
    return distance, [(*centre, max(radii))]


def spline(points, pieces=6):
    """Catmull-Rom curve through rows of points, ends included."""
    p = np.array(points, float)
    p = np.vstack([2 * p[0] - p[1], p, 2 * p[-1] - p[-2]])
    t = np.linspace(0, 1, pieces, endpoint=False)[:, None]
    a, b, c, d = p[:-3], p[1:-2], p[2:-1], p[3:]
    rows = [b[i] + 0.5 * t * (c[i] - a[i] + t * (2 * a[i] - 5 * b[i] + 4 * c[i] - d[i]
            + t * (3 * b[i] - a[i] - 3 * c[i] + d[i]))) for i in range(len(a))]
    return np.vstack(rows + [p[-2:-1]])


def tube(*points):
    """The hull of balls rolled along the spline through rows (x, y, z, radius): round cones."""
    rows = spline(points)

    def distance(p):
        best = np.full(len(p), np.inf)
        for a, b in zip(rows[:-1], rows[1:]):
            axis, widen = b[:3] - a[:3], b[3] - a[3]
            length = np.linalg.norm(axis)
            slope = np.clip(widen / length, -0.95, 0.95)
            along = (p - a[:3]) @ axis / length
            across = np.sqrt(np.maximum(((p - a[:3])**2).sum(axis=1) - along**2, 0))
            t = np.clip((along + across * slope / np.sqrt(1 - slope**2)) / length, 0, 1)
            best = np.minimum(best, np.hypot(along - t * length, across) - a[3] - t * widen)
        return best
    return distance, rows


def box(low, high, bevel):
    """Box from corner to corner, its edges rounded."""
    low, high = np.array(low, float), np.array(high, float)

    def distance(p):
        q = abs(p - (low + high) / 2) - (high - low) / 2 + bevel
        return np.linalg.norm(np.maximum(q, 0), axis=1) + np.minimum(q.max(axis=1), 0) - bevel
    return distance, [(*corner, 0) for corner in (low, high)]


def disc(low, high, radius, bevel):
    """Upright cylinder between two heights, its edges rounded."""
    flat, _ = box((-radius, low, -1), (radius, high, 1), bevel)

    def distance(p):
        return flat(np.stack([np.hypot(p[:, 0], p[:, 2]), p[:, 1], 0 * p[:, 1]], axis=1))
    return distance, [(-radius, low, -radius, 0), (radius, high, radius, 0)]


def carve(shape, tool):
    """A shape without what is inside the tool."""
    return (lambda p: np.maximum(shape[0](p), -tool[0](p))), shape[1]


def fluted(shape, count, depth, middle, width):
    """Grooves from top to bottom around the y axis, deepest at the middle height."""
    def distance(p):
        fade = np.exp(-((p[:, 1] - middle) / width)**4)
        return shape[0](p) + depth * fade * np.cos(count * np.arctan2(p[:, 0], p[:, 2]))
    return distance, shape[1]


def pair(shape):
    """A shape at x > 0 and its mirror image, as two shapes."""
    distance, hull = shape
    flip = np.array([-1.0, 1, 1])
    return [shape, (lambda p: distance(p * flip), [(-r[0], *r[1:]) for r in hull])]


def union(shapes, blend):
    """Smooth union: -blend log sum exp(-d/blend), the same for any order of the shapes."""
    def field(p):
        d = np.array([distance(p) for distance, _ in shapes]) / -blend
        top = d.max(axis=0)
        return -blend * (top + np.log(np.exp(d - top).sum(axis=0)))
    hull = np.array([row for _, rows in shapes for row in rows])
    return field, hull


# --- surface ----------------------------------------------------------------------------------

def gradient(field, p, step=1e-4):
    axes = np.eye(3) * step
    return np.stack([field(p + a) - field(p - a) for a in axes], axis=1) / (2 * step)


def project(field, p, rounds=4):
    """Newton steps along the gradient onto field = 0."""
    for _ in range(rounds):
        g = gradient(field, p)
        p = p - (field(p) / np.maximum((g * g).sum(axis=1), 1e-6))[:, None] * g
    return p


def surface_net(field, hull, cell):
    """Half x >= 0 of field = 0: one vertex per crossed cell, one quad per crossed grid edge.

    The first layer of cells is centred on x = 0, so that its vertices lie on the mirror plane.
    """
    low = (hull[:, :3] - hull[:, 3:]).min(axis=0) - 2 * cell
    high = (hull[:, :3] + hull[:, 3:]).max(axis=0) + 2 * cell
    low[0] = -cell / 2
    size = np.ceil((high - low) / cell).astype(int) + 1
    grid = np.stack(np.meshgrid(*map(np.arange, size), indexing="ij"), axis=-1)
    points = (low + cell * grid).reshape(-1, 3)
    value = np.concatenate([field(part) for part in np.array_split(points, 64)]).reshape(size)
    inside = value < 0

    # cells with corners on both sides
    corners = sum(inside[i:size[0] - 1 + i, j:size[1] - 1 + j, k:size[2] - 1 + k].astype(int)
                  for i in (0, 1) for j in (0, 1) for k in (0, 1))
    mixed = (corners > 0) & (corners < 8)
    number = np.where(mixed, np.cumsum(mixed.ravel()).reshape(mixed.shape) - 1, -1)
    vertices = low + cell * (np.argwhere(mixed) + 0.5)

    # the four cells around every crossed grid edge
    quads = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        first = inside.take(range(size[axis] - 1), axis)
        last = inside.take(range(1, size[axis]), axis)
        for outward, crossed in ((True, first & ~last), (False, ~first & last)):
            edge = np.argwhere(crossed)
            edge = edge[(edge[:, u] > 0) & (edge[:, v] > 0)]
            ring = []
            for du, dv in ((1, 1), (0, 1), (0, 0), (1, 0)):
                at = edge.copy()
                at[:, u] -= du
                at[:, v] -= dv
                ring.append(number[at[:, 0], at[:, 1], at[:, 2]])
            ring = np.stack(ring, axis=1)
            quads.append(ring if outward else ring[:, ::-1])
    middle = vertices[:, 0] == 0
    vertices = project(field, vertices)
    vertices[middle, 0] = 0
    return vertices, np.vstack(quads)


def quadriflow(vertices, quads, count, seed):
    """Blender's QuadriFlow on an open half, its boundary kept."""
    import bpy
    mesh = bpy.data.meshes.new("half")
    mesh.from_pydata(vertices.tolist(), [], quads.tolist())
    thing = bpy.data.objects.new("half", mesh)
    bpy.context.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    thing.select_set(True)
    bpy.ops.object.quadriflow_remesh(mode="FACES", target_faces=count, seed=seed,
                                     use_preserve_boundary=True, use_mesh_symmetry=False)
    out = thing.data
    points = np.array([v.co[:] for v in out.vertices])
    faces = np.array([f.vertices[:] for f in out.polygons])
    bpy.data.objects.remove(thing)
    if len(faces) == len(quads):
        raise RuntimeError("QuadriFlow did nothing: the net is not manifold, try another cell")
    return points, faces


def rim(quads):
    """Vertices on edges that have one face only."""
    edges = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    edge, uses = np.unique(edges, axis=0, return_counts=True)
    return np.unique(edge[uses == 1])


def relax(field, points, quads, rounds, crowd=10.0):
    """Moves vertices to the weighted mean of the centres of their quads, along field = 0.

    A quad weighs its area, times more where the surface turns within it: tips get smaller quads.
    """
    middle = rim(quads)
    for _ in range(rounds):
        points[middle, 0] = 0
        normal = gradient(field, points)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        turn = 1 - np.linalg.norm(normal[quads].mean(axis=1), axis=1)
        a, b, c, d = points[quads].transpose(1, 0, 2)
        weight = np.linalg.norm(np.cross(c - a, d - b), axis=1) * (1 + crowd * turn)
        pull = weight[:, None] * (a + b + c + d) / 4
        total, share = np.zeros_like(points), np.zeros(len(points))
        for corner in quads.T:
            np.add.at(total, corner, pull)
            np.add.at(share, corner, weight)
        points = project(field, 0.5 * points + 0.5 * total / share[:, None], rounds=1)
    points = project(field, points)
    points[middle, 0] = 0
    return points


def mirror(points, quads):
    """Joins a half with its mirror image along x = 0."""
    middle = rim(quads)
    twin = np.arange(len(points)) + len(points)
    twin[middle] = middle
    return np.vstack([points, points * [-1, 1, 1]]), np.vstack([quads, twin[quads][:, ::-1]])


def skin(shapes, quads, seed, cell=0.045, blend=0.04, rounds=60):
    """Even quads over the smooth union of shapes, left and right alike.

    QuadriFlow meets the asked number only within some 10 %, and the quality of its quads varies:
    quads, seed and cell of each model below are the best of dozens tried."""
    field, hull = union(shapes, blend)
    rough, net = surface_net(field, hull, cell)
    points, faces = quadriflow(relax(field, rough, net, 6, crowd=0), net, quads // 2, seed)
    return mirror(relax(field, points, faces, rounds), faces)


# --- grids ------------------------------------------------------------------------------------

def blocks(*boxes):
    """Surface of a union of boxes (low, high) of unit cells: integer points, outward quads."""
    cells = {cell for low, high in boxes for cell in product(*map(range, low, high))}
    number, quads = {}, []
    for cell, axis, side in product(sorted(cells), range(3), (0, 1)):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        beside = list(cell)
        beside[axis] += 2 * side - 1
        if tuple(beside) in cells:
            continue
        ring = []
        for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
            corner = list(cell)
            corner[axis] += side
            corner[u] += du
            corner[v] += dv
            ring.append(number.setdefault(tuple(corner), len(number)))
        quads.append(ring if side else ring[::-1])
    return np.array(list(number), float), np.array(quads)


def on_sphere(points):
    """Points on the cube [-1, 1]^3, at even angles, to the unit sphere."""
    points = np.tan(points * np.pi / 4)
    return points / np.linalg.norm(points, axis=1)[:, None]


# --- models -----------------------------------------------------------------------------------

def squirrel():
    """Sits upright, a bushy tail along its back; the tip of the tail is a vertex.

    A free tail unbends when a string pulls its tip, and the squirrel floats upright; grown to the
    back up to the head, it turns the squirrel upside down.
    """
    shapes = [egg((0, -0.40, 0.03), (0.42, 0.50, 0.40), tilt=8),
              egg((0, 0.38, 0.18), (0.35, 0.31, 0.33)),
              tube((0, 0.30, 0.40, 0.20), (0, 0.26, 0.58, 0.11)),
              egg((0, 0.12, -0.10), (0.24, 0.30, 0.26)),
              tube((0, -0.80, -0.30, 0.18), (0, -0.62, -0.56, 0.28), (0, -0.15, -0.60, 0.37),
                   (0, 0.32, -0.52, 0.38), (0, 0.72, -0.60, 0.29), (0, 0.94, -0.88, 0.19),
                   (0, 0.94, -1.16, 0.11))]
    shapes += pair(tube((0.20, 0.54, 0.14, 0.17), (0.27, 0.84, 0.14, 0.095)))
    shapes += pair(egg((0.20, 0.27, 0.30), (0.19, 0.17, 0.18)))
    shapes += pair(tube((0.30, -0.04, 0.16, 0.15), (0.39, -0.20, 0.42, 0.13),
                        (0.21, -0.12, 0.64, 0.13)))
    shapes += pair(egg((0.31, -0.66, 0.08), (0.21, 0.28, 0.34), tilt=-20))
    shapes += pair(tube((0.28, -0.91, 0.10, 0.13), (0.30, -0.90, 0.46, 0.15)))
    return skin(shapes, quads=1460, seed=3, cell=0.042)


def turtle():
    """Shell with a brim, flat belly, long neck, four stout legs, a small tail."""
    shapes = [egg((0, 0.10, 0), (0.80, 0.56, 0.94)),
              egg((0, -0.08, 0), (0.97, 0.17, 1.11)),
              egg((0, -0.18, 0), (0.74, 0.22, 0.90)),
              tube((0, -0.10, 0.75, 0.20), (0, 0.02, 1.12, 0.18), (0, 0.30, 1.34, 0.18)),
              egg((0, 0.44, 1.46), (0.29, 0.27, 0.34), tilt=12),
              tube((0, -0.16, -0.90, 0.17), (0, -0.20, -1.32, 0.12))]
    shapes += pair(tube((0.50, -0.18, 0.58, 0.20), (0.82, -0.30, 0.88, 0.20),
                        (0.90, -0.42, 0.96, 0.21)))
    shapes += pair(tube((0.50, -0.18, -0.58, 0.20), (0.78, -0.30, -0.86, 0.20),
                        (0.84, -0.42, -0.94, 0.21)))
    return skin(shapes, quads=1660, seed=2, cell=0.055)


def balloon():
    """The party balloon: a teardrop that narrows to a neck with a rolled lip."""
    field, _ = union([tube((0, 0.25, 0, 0.75), (0, -0.10, 0, 0.55), (0, -0.40, 0, 0.31),
                           (0, -0.62, 0, 0.12), (0, -0.90, 0, 0.12)),
                      egg((0, -0.94, 0), (0.25, 0.11, 0.25))], blend=0.02)
    points, quads = blocks(((0, -7, -7), (7, 7, 7)), ((0, -18, -2), (2, -7, 2)))
    used, quads = np.unique(quads[(points[quads, 0] > 0).any(axis=1)], return_inverse=True)
    points, quads = points[used], quads.reshape(-1, 4)
    x, y, z = points.T
    body = 0.7 * on_sphere(np.maximum(points, -7) / 7) + [0, 0.25, 0]
    thin = 0.06 * np.maximum(abs(x), abs(z)) / np.maximum(np.hypot(x, z), 1)
    neck = np.stack([x * thin, 0.045 * y - 0.2, z * thin], axis=1)
    points = relax(field, np.where(y[:, None] < -7, neck, body), quads, 400)
    return mirror(points, quads)


def bowl():
    """A cube-sphere whose part above a level is reflected below it: a sphere pushed in.

    The equator of the cube-sphere is a row of its grid; a conformal map takes it to the level.
    """
    level, edge = 0.27, 0.04
    points, quads = blocks(((-7, -7, -7), (7, 7, 7)))
    x, y, z = on_sphere(points / 7).T
    grow = (1 - level) / (1 + level)
    shrink = 2 * np.sqrt(grow) / ((1 + y) + grow * (1 - y))
    y = ((1 + y) - grow * (1 - y)) / ((1 + y) + grow * (1 - y))
    return np.stack([x * shrink, level - np.hypot(y - level, edge), z * shrink], axis=1), quads


def pillow():
    """A cushion of two sheets with a seam around, its corners drawn out."""
    points, quads = blocks(((-9, -1, -9), (9, 1, 9)))
    x, y, z = (points / [9, 1, 9]).T
    full = np.sqrt((1 - x * x) * (1 - z * z))
    brim = 1 + 0.03 * (y == 0)
    return np.stack([x * brim * (1 - 0.10 * (1 - z * z)), y * (0.055 + 0.26 * full),
                     z * brim * (1 - 0.10 * (1 - x * x))], axis=1), quads


def teddy():
    """The big one: sits, legs ahead, arms out, round ears close to the head."""
    shapes = [egg((0, -0.38, 0), (0.50, 0.52, 0.44)),
              egg((0, -0.44, 0.16), (0.42, 0.42, 0.38)),
              egg((0, 0.44, 0.02), (0.48, 0.42, 0.40)),
              egg((0, 0.31, 0.34), (0.23, 0.18, 0.22)),
              egg((0, 0.41, 0.55), (0.085, 0.06, 0.06)),
              egg((0, -0.60, -0.46), (0.14, 0.14, 0.14))]
    shapes += pair(egg((0.39, 0.76, 0.0), (0.22, 0.22, 0.12), tilt=-8, roll=-25))
    shapes += pair(egg((0.175, 0.53, 0.37), (0.06, 0.075, 0.06)))
    shapes += pair(tube((0.38, -0.06, 0.02, 0.17), (0.64, -0.18, 0.18, 0.165),
                        (0.76, -0.24, 0.40, 0.185)))
    shapes += pair(tube((0.28, -0.70, 0.10, 0.22), (0.42, -0.78, 0.50, 0.21),
                        (0.46, -0.78, 0.68, 0.20)))
    shapes += pair(egg((0.47, -0.72, 0.82), (0.21, 0.26, 0.14), tilt=-8))
    return skin(shapes, quads=11240, seed=2, cell=0.023, blend=0.035)


def heart():
    """Two tapered tubes that meet in a point below, and a cushion between them."""
    shapes = pair(tube((0.0, -0.86, 0, 0.10), (0.26, -0.35, 0, 0.32), (0.46, 0.30, 0, 0.48)))
    shapes += [tube((0, -0.82, 0, 0.11), (0, -0.40, 0, 0.34), (0, -0.06, 0, 0.42))]
    return skin(shapes, quads=1060, seed=0, blend=0.08)


def star():
    """Five tapered arms, as a foil balloon."""
    shapes = [tube((0, 0, 0, 0.46), (0, 0.5, 0, 0.33), (0, 0.98, 0, 0.15))]
    for a in np.radians([18, -54]):
        x, y = np.cos(a), np.sin(a)
        shapes += pair(tube((0, 0, 0, 0.46), (0.5 * x, 0.5 * y, 0, 0.33),
                            (0.98 * x, 0.98 * y, 0, 0.15)))
    return skin(shapes, quads=1000, seed=2, blend=0.04)


def dog():
    """The balloon-modeller's dog: sausages with a pinch between each and the next."""
    shapes = [tube((0, 0.02, 0.36, 0.27), (0, 0.04, -0.36, 0.27)),
              tube((0, 0.24, 0.64, 0.22), (0, 0.50, 0.74, 0.22)),
              tube((0, 0.80, 0.94, 0.24), (0, 0.76, 1.22, 0.22)),
              egg((0, 0.76, 1.48), (0.11, 0.11, 0.11)),
              tube((0, 0.18, -0.68, 0.14), (0, 0.58, -0.90, 0.18), (0, 0.92, -0.96, 0.13))]
    shapes += pair(tube((0.22, 0.92, 0.70, 0.18), (0.34, 1.20, 0.56, 0.19)))
    shapes += pair(tube((0.27, -0.22, 0.54, 0.22), (0.31, -0.62, 0.60, 0.22)))
    shapes += pair(tube((0.27, -0.22, -0.54, 0.22), (0.31, -0.62, -0.60, 0.22)))
    return skin(shapes, quads=2400, seed=0, cell=0.042, blend=0.025)


def bird():
    """In flight: wings out, a fan for a tail, a beak."""
    shapes = [egg((0, 0.0, 0.0), (0.34, 0.34, 0.62), tilt=-8),
              egg((0, 0.24, 0.66), (0.27, 0.26, 0.27)),
              tube((0, 0.22, 0.86, 0.11), (0, 0.19, 1.06, 0.035)),
              tube((0, 0.06, -0.50, 0.17), (0, 0.10, -0.80, 0.10))]
    shapes += pair(tube((0.20, 0.10, 0.16, 0.15), (0.62, 0.26, 0.22, 0.14),
                        (1.02, 0.34, 0.02, 0.12), (1.38, 0.30, -0.26, 0.07)))
    shapes += pair(egg((0.58, 0.20, -0.04), (0.46, 0.08, 0.34), roll=18))
    shapes += pair(egg((0.98, 0.29, -0.18), (0.34, 0.065, 0.28), roll=4))
    shapes += [egg((0, 0.12, -1.02), (0.14, 0.07, 0.34))]
    shapes += pair(tube((0.05, 0.11, -0.80, 0.085), (0.22, 0.12, -1.24, 0.075)))
    shapes += pair(egg((0.15, 0.33, 0.82), (0.055, 0.06, 0.055)))
    return skin(shapes, quads=9725, seed=3, cell=0.026, blend=0.035)


def holes():
    """A ball with three handles, as a jug has them: genus 3."""
    shapes = [egg((0, 0, 0), (0.52, 0.58, 0.46)),
              tube((-0.30, 0.42, 0, 0.15), (-0.30, 0.80, 0, 0.14), (0, 0.98, 0, 0.14),
                   (0.30, 0.80, 0, 0.14), (0.30, 0.42, 0, 0.15))]
    shapes += pair(tube((0.38, 0.28, 0, 0.15), (0.78, 0.26, 0, 0.14), (0.95, -0.04, 0, 0.14),
                        (0.78, -0.34, 0, 0.14), (0.38, -0.34, 0, 0.15)))
    return skin(shapes, quads=5888, seed=3, cell=0.032, blend=0.03)


def vase():
    """Rough: a fluted belly, ringed neck, a foot, and a lip around the mouth."""
    belly = tube((0, -0.72, 0, 0.32), (0, -0.42, 0, 0.50), (0, 0.02, 0, 0.56), (0, 0.40, 0, 0.36),
                 (0, 0.66, 0, 0.25), (0, 0.92, 0, 0.29))
    shapes = [fluted(belly, 18, 0.022, -0.12, 0.46),
              disc(-1.08, -0.92, 0.46, 0.06), disc(-0.80, -0.72, 0.46, 0.035),
              disc(0.50, 0.56, 0.345, 0.03), disc(0.64, 0.70, 0.315, 0.03),
              disc(0.96, 1.10, 0.42, 0.06)]
    mouth = tube((0, 1.40, 0, 0.26), (0, 0.96, 0, 0.20))
    field = union(shapes, 0.02)
    return skin([carve(field, mouth)], quads=14624, seed=2, cell=0.02, blend=0.02)


def cube_cylinder():
    """A cube and a cylinder on it, with edges."""
    shapes = [box((-0.62, -1, -0.62), (0.62, 0.24, 0.62), 0.05), disc(0.10, 1.1, 0.40, 0.05)]
    return skin(shapes, quads=15560, seed=2, cell=0.02, blend=0.015)


MODELS = {"squirrel": squirrel, "turtle": turtle, "balloon": balloon, "bowl": bowl,
          "pillow": pillow, "teddy": teddy, "heart": heart, "star": star, "dog": dog,
          "vase": vase, "bird": bird, "holes": holes, "cube-cylinder": cube_cylinder}


# --- out --------------------------------------------------------------------------------------

def stand(points):
    """Puts a model on its floor, its middle over the origin."""
    low, high = points.min(axis=0), points.max(axis=0)
    return points - [0, low[1] - FLOOR, (low[2] + high[2]) / 2]


def write_obj(path, name, points, quads):
    """OBJ of positions and quads, vertices numbered by first use by a face."""
    used, first = np.unique(quads.ravel(), return_index=True)
    order = used[np.argsort(first)]
    number = np.zeros(len(points), int)
    number[order] = np.arange(len(order)) + 1
    lines = [f"# {name}: {len(order)} vertices, {len(quads)} quads, made by make_models.py"]
    lines += ["v %.6f %.6f %.6f" % tuple(p) for p in points[order] + 0.0]
    lines += ["f %d %d %d %d" % tuple(f) for f in number[quads]]
    with open(path, "w", encoding="ascii") as out:
        out.write("\n".join(lines) + "\n")


def main():
    asked = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    for name in asked or MODELS:
        points, quads = MODELS[name]()
        here = os.path.dirname(os.path.abspath(__file__))
        write_obj(os.path.join(here, name + ".obj"), name, stand(points), quads)


main()
