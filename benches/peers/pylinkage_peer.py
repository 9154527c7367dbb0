"""pylinkage's kernels, compiled by numba: dyads in closed form, with velocities and accelerations, driven at constant speed."""

import math
import time

import numpy
from pylinkage.solver.simulation import simulate_with_kinematics
from pylinkage.solver.types import JOINT_CRANK, JOINT_PRISMATIC, JOINT_REVOLUTE, JOINT_STATIC, MAX_PARENTS

from bodies import dyads


class Pylinkage:
    """A linkage of dyads as pylinkage's arrays; `sweep` goes through a period."""

    def __init__(self, linkage, steps):
        self.steps, self.tracked = steps, linkage["tracked"]
        points = [list(point) for point in linkage["points"]]
        pivot, pin = linkage["crank"]["ends"]
        types, parents, constraints = [JOINT_STATIC] * len(points), [[-1] * MAX_PARENTS for _ in points], [[] for _ in points]
        types[pin], parents[pin][0], constraints[pin] = JOINT_CRANK, pivot, [linkage["crank"]["length"], 2 * math.pi]
        order = [pin]
        for a, ra, b, rb, _, p in dyads(linkage):
            order.append(p)
            if b is not None:
                types[p], parents[p][:2], constraints[p] = JOINT_REVOLUTE, [a, b], [ra, rb]
                continue
            # The slider's line goes through two points of its own.
            types[p], parents[p], constraints[p] = JOINT_PRISMATIC, [a, len(points), len(points) + 1], [ra]
            for x in (0.0, 1.0):
                points.append([x, 0.0])
                types.append(JOINT_STATIC)
                parents.append([-1] * MAX_PARENTS)
                constraints.append([])
        offsets = numpy.cumsum([0] + [len(own) for own in constraints])[:-1]
        integers = lambda values: numpy.array(values, dtype=numpy.int32)
        self.start = numpy.array(points)
        self.arrays = (numpy.array(sum(constraints, [])), integers(types), integers(parents), integers(offsets), integers(order))
        self.crank = (numpy.array([2 * math.pi]), numpy.array([0.0]), integers([pin]))

    def sweep(self):
        """ns per step, places and accelerations of the tracked point."""
        at_rest = [numpy.zeros_like(self.start) for _ in range(2)]
        places = self.start.copy()
        begin = time.perf_counter()
        motion = simulate_with_kinematics(places, *at_rest, *self.arrays, *self.crank, self.steps, 1 / (self.steps + 1))
        seconds = time.perf_counter() - begin
        return seconds * 1e9 / self.steps, motion[0][:, self.tracked], motion[2][:, self.tracked]
