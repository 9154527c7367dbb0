"""A linkage of points and links as bodies with x, y and angle, and its equations for whatever package has sines and cosines."""

import math
from dataclasses import dataclass


@dataclass
class Body:
    """A link: its points in its own frame, and where that frame is at t = 0."""

    points: dict
    start: tuple


def bodies(linkage):
    """The crank first, then the links, at last the slider."""
    places = linkage["points"]
    a, b = linkage["crank"]["ends"]
    links = [[[a, [0.0, 0.0]], [b, [linkage["crank"]["length"], 0.0]]], *linkage["links"]]
    made = []
    for link in links:
        (p, q) = (places[link[0][0]], places[link[1][0]])
        made.append(Body({point: tuple(local) for point, local in link}, (*p, math.atan2(q[1] - p[1], q[0] - p[0]))))
    if linkage["slider"] is not None:
        made.append(Body({linkage["slider"]: (0.0, 0.0)}, (*places[linkage["slider"]], 0.0)))
    return made


def angle(linkage, t, sin, pi):
    """The crank's angle at t."""
    return 2 * pi * t if linkage["crank"]["law"] == "turning" else pi / 2 + 0.8 * sin(2 * pi * t)


def place(body, q, point, sin, cos):
    """A point of a body with coordinates q."""
    x, y = body.points[point]
    sine, cosine = sin(q[2]), cos(q[2])
    # A product with zero would stay in the code.
    across = lambda a, b: (a * x if x else 0) + (b * y if y else 0)
    return q[0] + across(cosine, -sine), q[1] + across(sine, cosine)


def equations(linkage, made, q, t, sin, cos, pi):
    """The residuals, 3 for each body: `q` is the list of all coordinates."""
    of = lambda index: q[3 * index : 3 * index + 3]
    rows, first = [], {}
    for index, body in enumerate(made):
        for point in body.points:
            here = place(body, of(index), point, sin, cos)
            if point < linkage["fixed"]:
                rows += [here[i] - linkage["points"][point][i] for i in range(2)]
            elif point in first:
                there = place(made[first[point]], of(first[point]), point, sin, cos)
                rows += [there[i] - here[i] for i in range(2)]
            else:
                first[point] = index
    if linkage["slider"] is not None:
        rows += [of(len(made) - 1)[1], of(len(made) - 1)[2]]
    return [*rows, q[2] - angle(linkage, t, sin, pi)]


def dyads(linkage):
    """For each point that follows from two others: those, both distances, and the side; None where points follow together."""
    known = {*range(linkage["fixed"]), linkage["crank"]["ends"][1]}
    found = []
    for points in linkage["order"]:
        if len(points) > 1:
            return None
        known |= {points[0]}
        found.append(dyad(linkage, points[0], known))
    return found


def dyad(linkage, point, known):
    """The two bars that hold a point."""
    ends = [(a if b == point else b, length) for a, b, length in linkage["bars"] if point in (a, b) and {a, b} <= known]
    if len(ends) == 1:
        return (*ends[0], None, 0.0, 0.0, point)
    (a, ra), (b, rb) = ends
    (ax, ay), (bx, by), (px, py) = (linkage["points"][p] for p in (a, b, point))
    side = math.copysign(1.0, (bx - ax) * (py - ay) - (by - ay) * (px - ax))
    return a, ra, b, rb, side, point
