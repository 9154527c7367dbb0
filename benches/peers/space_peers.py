"""The C code that follows a mechanism in space by CasADi: straight lines for a correction and for all bodies, and its `fast_newton`."""

import casadi
from casadi import SX

import trees


def equations(model):
    """Functions of the unknowns, time and samples: residuals, and with given rates and accelerations those of the residuals."""
    size = len(trees.unknowns(model))
    t, given = SX.sym("t"), SX.sym("given", 3 * sum(1 for cut in model["cuts"] if cut[0] != "meet" and cut[-1][0] == "samples"))
    u, ud, udd = (SX.sym(name, size) for name in ("u", "ud", "udd"))
    listed = lambda: [given[k] for k in range(given.numel())]
    q, rates, accelerations = trees.placed(model, t, listed(), (u, ud, udd))
    made = trees.frames(model, q, rates, accelerations)
    phi, moved, changed = trees.rows(model, made, t, listed())
    bodies = casadi.vertcat(*(frame.numbers(body["center"]) for frame, body in zip(made, model["bodies"])))
    return (u, ud, udd, t, given), (phi, moved, changed, bodies)


def functions(model):
    """What is printed: `correction`, `state` and `whole`, CasADi's own Newton's method with everything after it."""
    (u, ud, udd, t, given), (phi, moved, changed, bodies) = equations(model)
    jacobian = casadi.jacobian(phi, u)
    at_rest = casadi.substitute(moved, ud, SX.zeros(ud.shape[0]))
    bias = casadi.substitute(changed, udd, SX.zeros(udd.shape[0]))
    solved = lambda right: -blockwise(jacobian, right) if phi.shape[0] else SX(0, 1)
    # Straight lines from values to rates to accelerations, each with its own symbols replaced.
    rate = solved(at_rest)
    values = casadi.Function("values", [u, t, given], [rate])
    names = [u, t, given]
    of_rate = casadi.Function("of_rate", [*names, ud], [solved(bias)])
    of_all = casadi.Function("of_all", [*names, ud, udd], [bodies])
    found = values(*names)
    second = of_rate(*names, found)
    state = casadi.Function("state", names, [found, second, of_all(*names, found, second)])
    correction = casadi.Function("correction", names, [solved(phi)])
    made = [correction, state]
    if phi.shape[0]:
        made.append(whole(names, phi, jacobian, at_rest, (bias, ud), (bodies, ud, udd)))
    return made


def blockwise(matrix, right):
    """The solution of a linear system, block after block where it falls into such: loop after loop of a chain."""
    count, rows, columns, row_blocks, column_blocks, _, _ = matrix.sparsity().btf()
    found = SX.zeros(right.shape[0])
    for block in range(count):
        own, places = rows[row_blocks[block] : row_blocks[block + 1]], columns[column_blocks[block] : column_blocks[block + 1]]
        # What was not found yet is zero.
        rest = right[own] - casadi.mtimes(matrix[own, :], found)
        found[places] = casadi.solve(matrix[own, places], rest)
    return found


def whole(names, phi, jacobian, at_rest, of_bias, of_bodies):
    u, t, given = names
    size = u.shape[0]
    guess, at, samples = casadi.MX.sym("guess", size), casadi.MX.sym("t"), casadi.MX.sym("given", given.shape[0])
    parameters = casadi.vertcat(t, given)
    find = casadi.rootfinder("find", "fast_newton", {"x": u, "p": parameters, "g": phi}, {"abstol": 1e-12})
    found = find(x0=guess, p=casadi.vertcat(at, samples))["x"]
    inputs = [found, at, samples]
    matrix = casadi.Function("jacobian", names, [jacobian])(*inputs)
    first = -casadi.solve(matrix, casadi.Function("rest", names, [at_rest])(*inputs), "qr")
    bias, ud = of_bias
    second = -casadi.solve(matrix, casadi.Function("bias", [*names, ud], [bias])(*inputs, first), "qr")
    bodies = casadi.Function("bodies", [*names, *of_bodies[1:]], [of_bodies[0]])(*inputs, first, second)
    return casadi.Function("whole", [guess, at, samples], [found, first, second, bodies])


def write(model, folder):
    """All C files of a mechanism but the harness."""
    free = trees.unknowns(model)
    start = [model["start"][k] for k in free] or [0.0]
    given = 3 * sum(1 for cut in model["cuts"] if cut[0] != "meet" and cut[-1][0] == "samples")
    lines = [
        f"enum {{ UNKNOWNS = {len(free)}, BODIES = {len(model['bodies'])}, GIVEN = {given} }};",
        f"static const double start[] = {{{', '.join(map(repr, start))}}};",
        *(["#define HAS_WHOLE"] if free else []),
    ]
    trees.printed(functions(model), folder, lines)
