"""Mechanisms in space, as `space data` and `dynamics data` give them, in expressions of CasADi: what bodies do, loops, forces."""

import casadi
from casadi import SX

AXES = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])


def column(values):
    return SX(casadi.DM(values))


def matrix(rows):
    return SX(casadi.sparsify(casadi.DM(rows)))


def turned(axis, angle):
    """The matrix of a turn about axis 0, 1 or 2."""
    after, last = (axis + 1) % 3, (axis + 2) % 3
    made = SX(3, 3)
    made[axis, axis] = 1
    made[after, after] = made[last, last] = casadi.cos(angle)
    made[after, last], made[last, after] = -casadi.sin(angle), casadi.sin(angle)
    return made


class Frame:
    """A frame with its motion: matrix, origin, velocities and accelerations in ground."""

    def __init__(self, rotation, place, rates=None, accelerations=None):
        self.rotation, self.place = rotation, place
        self.velocity, self.omega = rates or (SX(3, 1), SX(3, 1))
        self.acceleration, self.alpha = accelerations or (SX(3, 1), SX(3, 1))

    def arm(self, local):
        return casadi.mtimes(self.rotation, column(local))

    def point(self, local):
        """Place, velocity and acceleration of a point of it."""
        arm = self.arm(local)
        swing = casadi.cross(self.omega, arm)
        further = casadi.cross(self.alpha, arm) + casadi.cross(self.omega, swing)
        return self.place + arm, self.velocity + swing, self.acceleration + further

    def numbers(self, local):
        """Matrix by rows, then of this point place, velocity, angular velocity, acceleration, angular acceleration."""
        place, velocity, acceleration = self.point(local)
        rows = casadi.densify(casadi.reshape(self.rotation.T, 9, 1))
        return casadi.vertcat(rows, *map(casadi.densify, (place, velocity, self.omega, acceleration, self.alpha)))


GROUND = Frame(SX.eye(3), SX(3, 1))


def frames(model, q, rates=None, accelerations=None):
    """Frames of all bodies; with rates and accelerations where they are given."""
    made = []
    for body in model["bodies"]:
        before = GROUND if body["parent"] is None else made[body["parent"]]
        place, velocity, acceleration = before.point(body["place"])
        frame = Frame(casadi.mtimes(before.rotation, matrix(body["turned"])), place, (velocity, before.omega), (acceleration, before.alpha))
        for k, (kind, axis) in enumerate(body["joints"], body["first"]):
            (advance if rates is not None else place_only)(frame, kind, axis, *(of[k] for of in (q, rates, accelerations) if of is not None))
        made.append(frame)
    return made


def place_only(frame, kind, axis, value):
    if kind == "turn":
        frame.rotation = casadi.mtimes(frame.rotation, turned(axis, value))
    else:
        frame.place = frame.place + frame.arm(AXES[axis]) * value


def advance(frame, kind, axis, value, rate, acceleration):
    """A joint, with what its rates do: the axis is carried by what comes before it."""
    direction = frame.arm(AXES[axis])
    carried = casadi.cross(frame.omega, direction)
    if kind == "turn":
        frame.alpha = frame.alpha + direction * acceleration + carried * rate
        frame.omega = frame.omega + direction * rate
    else:
        shift = direction * value
        swing = casadi.cross(frame.omega, shift)
        further = casadi.cross(frame.alpha, shift) + casadi.cross(frame.omega, swing)
        frame.acceleration = frame.acceleration + further + 2 * carried * rate + direction * acceleration
        frame.velocity = frame.velocity + swing + direction * rate
    place_only(frame, kind, axis, value)


def point_of(made, place):
    body, local = place
    return (GROUND if body is None else made[body]).point(local)


def law(law, t, sample):
    """Value, rate and acceleration at t; those of samples are the next three of `sample`, which is a list."""
    if law[0] == "turning":
        return 2 * casadi.pi * t, SX(2 * casadi.pi), SX(0)
    if law[0] == "harmonic":
        _, offset, amplitude, omega, phase = law
        angle = omega * t + phase if phase else omega * t
        sine, cosine = casadi.sin(angle), casadi.cos(angle)
        return offset + amplitude * sine, amplitude * omega * cosine, -amplitude * omega * omega * sine
    return tuple(sample.pop(0) for _ in range(3))


def rows(model, made, t, sample):
    """Residuals of the cuts, their rates and accelerations."""
    found = []
    for cut in model["cuts"]:
        if cut[0] == "meet":
            difference = [a - b for a, b in zip(point_of(made, cut[1]), point_of(made, cut[2]))]
            found += [tuple(level[k] for level in difference) for k in range(3)]
        elif cut[0] == "height":
            levels = point_of(made, cut[1])
            found.append(tuple(level[2] - value for level, value in zip(levels, law(cut[2], t, sample))))
        else:
            way, rate, change = (a - b for a, b in zip(point_of(made, cut[1]), point_of(made, cut[2])))
            length, growth, bend = law(cut[3], t, sample)
            moved = casadi.dot(way, rate) - length * growth
            found.append((
                0.5 * (casadi.dot(way, way) - length * length),
                moved,
                casadi.dot(rate, rate) + casadi.dot(way, change) - growth * growth - length * bend,
            ))
    return [casadi.vertcat(*level) for level in zip(*found)] if found else [SX(0, 1)] * 3


def placed(model, t, sample, found):
    """Coordinates with rates and accelerations: driven ones by their laws, others from `found`, three vectors."""
    size = len(model["start"])
    levels = [[None] * size for _ in range(3)]
    for k, of in model["drives"]:
        for level, value in zip(levels, law(of, t, sample)):
            level[k] = value
    free = unknowns(model)
    for level, values in zip(levels, found):
        for place, k in enumerate(free):
            level[k] = values[place]
    return levels


def unknowns(model):
    driven = {k for k, _ in model["drives"]}
    return [k for k in range(len(model["start"])) if k not in driven]


def samples(model):
    """All samples of the laws of the cuts, by time, then cut, then value, rate and acceleration."""
    laws = [cut[-1][1] for cut in model["cuts"] if cut[0] != "meet" and cut[-1][0] == "samples"]
    return [[number for law in laws for number in law[step]] for step in range(len(laws[0]))] if laws else None


def printed(functions, folder, lines):
    """The C code of functions in `step.c`; sizes of their work arrays and further lines in `mechanism.h`."""
    code = casadi.CodeGenerator("step.c")
    for function in functions:
        code.add(function)
    code.generate(f"{folder}/")
    kinds = ("arg", "res", "iw", "w")
    sizes = [f"#define CASADI_{kind.upper()} {max(getattr(function, f'sz_{kind}')() for function in functions) + 1}" for kind in kinds]
    (folder / "mechanism.h").write_text("\n".join([*sizes, *lines]) + "\n")
