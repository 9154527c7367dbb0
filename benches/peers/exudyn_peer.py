"""Exudyn's dynamic solver with the crank's angle prescribed: bodies of unit mass and inertia, generalised alpha."""

import time

import exudyn
import exudyn.itemInterface as item
import numpy

from bodies import angle, bodies, equations

SPARSE_FROM = 60
"""Coordinates from which on the sparse solver is the faster one."""


class Exudyn:
    """A linkage as a multibody system; `sweep` goes through a period."""

    def __init__(self, linkage, steps):
        self.linkage, self.steps = linkage, steps
        self.made = bodies(linkage)

    def system(self):
        """The system, and the sensor numbers of the tracked point's place and acceleration."""
        linkage, made = self.linkage, self.made
        container = exudyn.SystemContainer()
        mbs = container.AddSystem()
        q, qd = consistent(linkage, made)
        ground = mbs.AddObject(item.ObjectGround())
        nodes, objects, first = [], [], {}
        for index in range(len(made)):
            own = slice(3 * index, 3 * index + 3)
            nodes.append(mbs.AddNode(item.NodeRigidBody2D(referenceCoordinates=list(q[own]), initialVelocities=list(qd[own]))))
            objects.append(mbs.AddObject(item.ObjectRigidBody2D(physicsMass=1.0, physicsInertia=1.0, nodeNumber=nodes[-1])))
        marker = lambda body, local: mbs.AddMarker(item.MarkerBodyRigid(bodyNumber=body, localPosition=[*local, 0.0]))
        joint = lambda a, b: mbs.AddObject(item.ObjectJointRevolute2D(markerNumbers=[a, b]))
        for index, body in enumerate(made):
            for point, local in body.points.items():
                if point < linkage["fixed"]:
                    joint(marker(ground, linkage["points"][point]), marker(objects[index], local))
                elif point in first:
                    joint(first[point], marker(objects[index], local))
                else:
                    first[point] = marker(objects[index], local)
        still = mbs.AddMarker(item.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(item.NodePointGround()), coordinate=0))
        held = lambda node, index: mbs.AddMarker(item.MarkerNodeCoordinate(nodeNumber=node, coordinate=index))
        if linkage["slider"] is not None:
            for index in (1, 2):
                mbs.AddObject(item.ObjectConnectorCoordinate(markerNumbers=[still, held(nodes[-1], index)]))
        begin = q[2]
        law = lambda mbs, t, number, offset: angle(linkage, t, numpy.sin, numpy.pi) - begin
        mbs.AddObject(item.ObjectConnectorCoordinate(markerNumbers=[still, held(nodes[0], 2)], offsetUserFunction=law))
        body, local = next((i, b.points[linkage["tracked"]]) for i, b in enumerate(made) if linkage["tracked"] in b.points)
        kinds = (exudyn.OutputVariableType.Position, exudyn.OutputVariableType.Acceleration)
        sensed = [
            mbs.AddSensor(item.SensorBody(bodyNumber=objects[body], localPosition=[*local, 0.0], storeInternal=True, outputVariableType=kind))
            for kind in kinds
        ]
        mbs.Assemble()
        # A system lives no longer than its container.
        return container, mbs, sensed

    def sweep(self):
        """ns per step, places and accelerations of the tracked point."""
        _container, mbs, sensed = self.system()
        settings = exudyn.SimulationSettings()
        settings.timeIntegration.numberOfSteps = self.steps
        settings.timeIntegration.endTime = self.steps / (self.steps + 1)
        settings.timeIntegration.verboseMode = settings.timeIntegration.verboseModeFile = 0
        settings.timeIntegration.newton.relativeTolerance = settings.timeIntegration.newton.absoluteTolerance = 1e-12
        settings.solutionSettings.writeSolutionToFile = False
        settings.solutionSettings.sensorsWritePeriod = 1 / (self.steps + 1)
        if 3 * len(self.made) > SPARSE_FROM:
            settings.linearSolverType = exudyn.LinearSolverType.EigenSparse
        begin = time.perf_counter()
        mbs.SolveDynamic(settings)
        seconds = time.perf_counter() - begin
        places, accelerations = (mbs.GetSensorStoredData(sensor)[-self.steps :, 1:3] for sensor in sensed)
        return seconds * 1e9 / self.steps, places, accelerations


def consistent(linkage, made):
    """Places and velocities at t = 0."""
    import casadi

    n = 3 * len(made)
    q, t = casadi.SX.sym("q", n), casadi.SX.sym("t")
    phi = casadi.vertcat(*equations(linkage, made, [q[i] for i in range(n)], t, casadi.sin, casadi.cos, casadi.pi))
    at = casadi.Function("at", [q, t], [phi, casadi.jacobian(phi, q), -casadi.jacobian(phi, t)])
    place = numpy.array([x for body in made for x in body.start])
    for _ in range(10):
        residual, jacobian, nu = (numpy.array(value.full()) for value in at(place, 0.0))
        place = place - numpy.linalg.solve(jacobian, residual).ravel()
    return place, numpy.linalg.solve(jacobian, nu).ravel()
