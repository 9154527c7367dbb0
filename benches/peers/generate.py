"""The C code for one linkage: SymPy's equations, CasADi's step, and the closed form where there is one."""

import casadi
import sympy
from sympy.printing.c import C99CodePrinter

from bodies import angle, bodies, dyads, equations, place

LARGEST_DENSE = 80
"""A dense LU of more unknowns takes all day."""


def c_lines(outputs, q, extra):
    """Assignments of expressions by name, common parts first."""
    printer = C99CodePrinter()
    shared, reduced = sympy.cse([value for _, value in outputs], symbols=sympy.numbered_symbols("w"), order="none")
    names = {symbol: f"{array}[{i}]" for array, symbols in {"q": q, **extra}.items() for i, symbol in enumerate(symbols)}
    printer._print_Symbol = lambda symbol: names.get(symbol, symbol.name)
    lines = [f"double {symbol} = {printer.doprint(value)};" for symbol, value in shared]
    return "\n    ".join(lines + [f"{name} = {printer.doprint(value)};" for (name, _), value in zip(outputs, reduced)])


def sympy_code(linkage, made):
    n = 3 * len(made)
    t = sympy.Symbol("t")
    q, qd, qdd = (sympy.symbols(f"{name}:{n}") for name in ("q", "v", "a"))
    rate = dict(zip(q, qd))
    phi = [sympy.sympify(row) for row in equations(linkage, made, list(q), t, sympy.sin, sympy.cos, sympy.pi)]
    among = lambda row: sorted(row.free_symbols & set(q), key=lambda symbol: q.index(symbol))
    follow = lambda row: sum((row.diff(s) * rate[s] for s in among(row)), sympy.S.Zero) + row.diff(t)
    jacobian = {(i, q.index(s)): row.diff(s) for i, row in enumerate(phi) for s in among(row)}
    entries = sorted(jacobian, key=lambda place: (place[1], place[0]))
    columns = [sum(1 for _, column in entries if column < j) for j in range(n + 1)]
    values = [jacobian[entry] for entry in entries]
    gamma = [-follow(follow(row)) for row in phi]
    (body,) = [i for i, body in enumerate(made) if linkage["tracked"] in body.points][:1]
    point = place(made[body], q[3 * body : 3 * body + 3], linkage["tracked"], sympy.sin, sympy.cos)
    second = [follow(follow(x)) + sum(x.diff(s) * a for s, a in zip(q, qdd)) for x in map(sympy.sympify, point)]
    listed = lambda name, values: [(f"{name}[{i}]", value) for i, value in enumerate(values)]
    arrays = {"qd": qd, "qdd": qdd}
    return f"""enum {{ N = {n}, ENTRIES = {len(entries)} }};
{"#define DENSE" if n <= LARGEST_DENSE else ""}
static int columns[] = {{{", ".join(map(str, columns))}}};
static int rows[] = {{{", ".join(str(row) for row, _ in entries)}}};
static const double start[] = {{{", ".join(repr(x) for body in made for x in body.start)}}};
static void phi(const double *q, double t, double *phi, double *values) {{
    {c_lines(listed("phi", phi) + listed("values", values), q, arrays)}
}}
static void nu(const double *q, double t, double *nu) {{
    {c_lines(listed("nu", [-row.diff(t) for row in phi]), q, arrays)}
}}
static void gamma_(const double *q, const double *qd, double t, double *gamma) {{
    {c_lines(listed("gamma", gamma), q, arrays)}
}}
static void track(const double *q, const double *qd, const double *qdd, double *at) {{
    {c_lines(listed("at", [*point, *second]), q, arrays)}
}}
{closed_code(linkage)}"""


def closed_code(linkage):
    """A call for each dyad, as one would write it."""
    found = dyads(linkage)
    if found is None:
        return ""
    t = sympy.Symbol("t")
    law = angle(linkage, t, sympy.sin, sympy.pi)
    laws = ", ".join(sympy.ccode(expression) for expression in (law, law.diff(t), law.diff(t, 2)))
    (pivot, pin), length = linkage["crank"]["ends"], linkage["crank"]["length"]
    ground = {i: "fixed({}, {})".format(*map(repr, linkage["points"][i])) for i in range(linkage["fixed"])}
    name = lambda point: ground.get(point, f"p{point}")
    x, y = linkage["points"][pivot]
    lines = [f"point p{pin} = crank({x!r}, {y!r}, {length!r}, {laws});"]
    for a, ra, b, rb, side, p in found:
        call = f"slide({name(a)}, {ra!r})" if b is None else f"dyad({name(a)}, {ra!r}, {name(b)}, {rb!r}, {side!r})"
        lines.append(f"point p{p} = {call};")
    body = "\n    ".join(lines)
    return f"#define HAS_CLOSED\nstatic point closed(double t) {{\n    {body}\n    return p{linkage['tracked']};\n}}"


def casadi_code(linkage, made, folder):
    """CasADi's code for one step, and the sizes of its work arrays."""
    n = 3 * len(made)
    q, qd, t = casadi.SX.sym("q", n), casadi.SX.sym("qd", n), casadi.SX.sym("t")
    phi = casadi.vertcat(*equations(linkage, made, [q[i] for i in range(n)], t, casadi.sin, casadi.cos, casadi.pi))
    jacobian, nu = casadi.jacobian(phi, q), -casadi.jacobian(phi, t)
    rate = lambda row: casadi.jtimes(row, q, qd) + casadi.jacobian(row, t)
    jacobian_of, nu_of = casadi.Function("j", [q, t], [jacobian]), casadi.Function("nu", [q, t], [nu])
    gamma_of = casadi.Function("gamma", [q, qd, t], [-rate(rate(phi))])
    find = casadi.rootfinder("find", "fast_newton", {"x": q, "p": t, "g": phi}, {"abstol": 1e-12})
    guess, at = casadi.MX.sym("guess", n), casadi.MX.sym("t")
    found = find(x0=guess, p=at)["x"]
    matrix = jacobian_of(found, at)
    first = casadi.solve(matrix, nu_of(found, at), "qr")
    second = casadi.solve(matrix, gamma_of(found, first, at), "qr")
    step = casadi.Function("linkage_step", [guess, at], [found, first, second])
    code = casadi.CodeGenerator("step.c")
    code.add(step)
    code.generate(f"{folder}/")
    return step


def write(linkage, folder):
    """All C files of a linkage."""
    made = bodies(linkage)
    step = casadi_code(linkage, made, folder)
    sizes = {"ARG": step.sz_arg(), "RES": step.sz_res(), "IW": step.sz_iw(), "W": step.sz_w()}
    work = "".join(f"#define CASADI_{name} {size + 1}\n" for name, size in sizes.items())
    (folder / "equations.h").write_text(work + sympy_code(linkage, made) + "\n")
