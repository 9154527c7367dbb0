"""The C code for what follows from forces: equations of motion with multipliers, formed by CasADi from the same mechanisms."""

import math

import casadi
from casadi import SX

import trees


def motion(model, q, v):
    """Mass matrix, forces, and rows on the accelerations with their right side."""
    zero = SX(q.shape[0], 1)
    made = trees.frames(model, [q[k] for k in range(q.shape[0])], *([of[k] for k in range(q.shape[0])] for of in (v, zero)))
    mass, forces = SX(q.shape[0], q.shape[0]), SX(q.shape[0], 1)
    for frame, body in zip(made, model["bodies"]):
        _, velocity, acceleration = frame.point(body["center"])
        inertia = casadi.mtimes([frame.rotation, casadi.diag(trees.column(body["inertia"])), frame.rotation.T])
        way, turn = casadi.jacobian(velocity, v), casadi.jacobian(frame.omega, v)
        mass += body["mass"] * casadi.mtimes(way.T, way) + casadi.mtimes([turn.T, inertia, turn])
        spin = casadi.mtimes(inertia, frame.alpha) + casadi.cross(frame.omega, casadi.mtimes(inertia, frame.omega))
        forces -= casadi.mtimes(way.T, body["mass"] * (acceleration - trees.column(model["gravity"]))) + casadi.mtimes(turn.T, spin)
    for coordinate, torque in model.get("torques", []):
        forces[coordinate] += torque
    for a, b, stiffness, rest in model.get("springs", []):
        way = trees.point_of(made, a)[0] - trees.point_of(made, b)[0]
        length = casadi.sqrt(casadi.dot(way, way))
        forces -= stiffness * (length - rest) * casadi.jacobian(length, q).T
    return (mass, forces, *held(model, made, q, v))


def held(model, made, q, v):
    """Rows of the cuts and their right side; rows that nothing moves are left out, and those of `aligned` added."""
    phi, moved, changed = trees.rows(model, made, None, None)
    for (one, i), (other, j) in model.get("aligned", []):
        # Two axes at right angles: the derivatives of their product.
        a, b = ((made[body] if body is not None else trees.GROUND, axis) for body, axis in ((one, i), (other, j)))
        levels = [spun(frame, trees.AXES[axis]) for frame, axis in (a, b)]
        (x, x1, x2), (y, y1, y2) = levels
        dot = casadi.dot
        moved = casadi.vertcat(moved, dot(x1, y) + dot(x, y1))
        changed = casadi.vertcat(changed, dot(x2, y) + 2 * dot(x1, y1) + dot(x, y2))
    jacobian = casadi.sparsify(casadi.simplify(casadi.jacobian(moved, v)))
    rows = [k for k in range(jacobian.shape[0]) if jacobian[k, :].nnz()]
    rows = [k for k in rows if k not in model.get("dependent", [])]
    return jacobian[rows, :], -changed[rows]


def spun(frame, local):
    arm = frame.arm(local)
    swing = casadi.cross(frame.omega, arm)
    return arm, swing, casadi.cross(frame.alpha, arm) + casadi.cross(frame.omega, swing)


def accelerations(model, way, start=None):
    """Coordinates and rates to accelerations and multipliers, one vector to one vector: by straight lines, or by CasADi's sparse QR.

    Multipliers are in a unit in which rows are about as large as masses at `start`: CasADi's straight lines lose digits without."""
    size = len(model["start"])
    both = SX.sym("both", 2 * size)
    mass, forces, rows, right = motion(model, both[:size], both[size:])
    sizes = casadi.Function("sizes", [both], [casadi.norm_inf(mass), casadi.norm_inf(rows)])
    masses, slopes = map(float, sizes(casadi.vertcat(model["start"] if start is None else start, casadi.DM.zeros(size))))
    rows, right = (2.0 ** round(math.log2(masses / slopes)) * of for of in (rows, right))
    count = rows.shape[0]
    matrix = casadi.vertcat(casadi.horzcat(mass, rows.T), casadi.horzcat(rows, SX(count, count)))
    vector = casadi.vertcat(forces, right)
    if way == "lines":
        return casadi.Function("answer_lines", [both], [casadi.densify(casadi.solve(matrix, vector))])
    given = casadi.MX.sym("both", 2 * size)
    of = casadi.Function("system", [both], [matrix, vector])(given)
    return casadi.Function(f"answer_{way}", [given], [casadi.densify(casadi.solve(*of, way))])


def derivative(model, start):
    """The derivative of coordinates and rates."""
    size = len(model["start"])
    both = SX.sym("both", 2 * size)
    found = accelerations(model, "lines", start)(both)
    return casadi.Function("derive", [both], [casadi.vertcat(both[size:], found[:size])])


def top(numbers, entries):
    """Rates of a quaternion and of the angular velocity in the axes of a top whose axis is y: Euler's equations."""
    across, about, weight = numbers
    w, x, y, z, a, b, c = entries
    up_x, up_z = 2 * (x * z - w * y), w * w - x * x - y * y + z * z
    turn = [-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a]
    spin = [((about - across) * b * c - weight * up_z) / across, 0.0, (weight * up_x - (about - across) * a * b) / across]
    return [*(0.5 * entry for entry in turn), *spin]


def of_top(numbers):
    """The same as a function."""
    entries = SX.sym("entries", 7)
    return casadi.Function("derive", [entries], [casadi.vertcat(*top(numbers, casadi.vertsplit(entries)))])
