"""Other people's solvers on mechanisms in space and on motions that follow from forces: `python3 benches/peers/space_forces.py [rounds]`.

In: nothing. Out: `space_forces.json` beside this file, then tables and pictures (`cargo run --bin peers`). Makes an environment under the target
folder with the packages pinned in `requirements_space.txt`, and takes the mechanisms and their exact motion from our programs, which run as
processes of their own and have their turn in each round before the others. Times are medians of the rounds, and so are ratios to the first
contender, which are of times of the same round. After the number of rounds parts can be named: `space`, `dynamics`, `motion`.
"""

import ctypes
import json
import statistics
import subprocess
import sys
import time

sys.dont_write_bytecode = True

import environment
from environment import HERE, TARGET, WORKSPACE

FLAGS = {"-O3": ["-O3"], "-O3 -march=native": ["-O3", "-march=native"]}
TURN = 4e6
"""How long a contender may take in one round, in ns; a slower one goes through fewer steps, or has its turn in fewer rounds."""
RARE = 10
"""In how many rounds a motion has its turn that takes longer."""
TOLERANCES = [1e-3, 1e-8]
"""Of corrections in Newton's method."""
FOLLOWED = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14]
"""Tolerances of integrators."""
MANY = 30
"""Mechanisms of more bodies are left out: their C takes minutes to compile."""
EVALUATIONS = 2048
"""Of accelerations in a turn, if there is time."""
BINARIES = ("space", "dynamics", "motion")
LINES = 13
"""Of larger systems the solution is not printed as straight lines: its elimination fills in."""


class Ours:
    """A program of ours that measures when it is told to."""

    def __init__(self, binary):
        command = [TARGET.parent / "release" / binary, "turns"]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def turn(self, problem):
        self.process.stdin.write(problem + "\n")
        self.process.stdin.flush()
        return dict(json.loads(self.process.stdout.readline()))


def data(binary):
    return json.loads(subprocess.run([TARGET.parent / "release" / binary, "data"], check=True, capture_output=True).stdout)


def array(values):
    import numpy

    return numpy.ascontiguousarray(values, dtype=float)


def pointer(values):
    return None if values is None else ctypes.c_void_p(values.ctypes.data)


def affordable(run, most):
    """How many steps take about a turn's time."""
    few = min(20, most)
    run(few)
    return max(few, min(most, int(TURN / max(run(few), 1e-3))))


def folder_of(name):
    folder = TARGET / "".join(letter if letter.isalnum() else "_" for letter in name)
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def medians(ours, problems, rounds):
    """Times and ratios to the first of ours, by name, for each problem; all problems have their turn in each round. Ways are functions of the
    number of the round, which may pass."""
    times = {problem: {} for problem in problems}
    for turn in range(rounds):
        for problem, ways in problems.items():
            found = ours.turn(problem)
            for name, way in ways.items():
                # The first call warms the caches, as it does in our programs.
                if way(turn) is not None:
                    found[name] = way(turn)
            first = next(iter(found.values()))
            for name, took in found.items():
                times[problem].setdefault(name, []).append((took, took / first))
    middle = lambda pairs: tuple(statistics.median(pair[k] for pair in pairs) for k in range(2))
    return {problem: {name: middle(pairs) for name, pairs in found.items()} for problem, found in times.items()}


# In space.


def compiled(folder, sources):
    """A library for each set of flags."""
    path = lambda flags: folder / f"{''.join(flags)}.so"
    return {words: environment.library(path(flags), flags, ["-I", folder, *sources]) for words, flags in FLAGS.items()}


def space_ways(model, times):
    """Contenders by name: functions of a number of steps and an array for what is seen."""
    import pinocchio_peers
    import space_peers
    import trees

    folder = folder_of(model["name"])
    space_peers.write(model, folder)
    sources, is_tree = [HERE / "space.c", folder / "step.c"], not trees.unknowns(model)
    if is_tree:
        sizes = pinocchio_peers.print_c(model, folder)
        with open(folder / "mechanism.h", "a") as header:
            header.write("#define HAS_TREE\n")
            header.writelines(f"#undef CASADI_{name}\n#define CASADI_{name} {size + 1000}\n" for name, size in sizes.items())
        sources.append(folder / "tree.c")
    given = array(trees.samples(model) or [0.0])
    ways = {}
    for words, library in compiled(folder, sources).items():
        library.sweep.restype = ctypes.c_double

        def way(method, tolerance, library=library):
            bound = ctypes.c_double(tolerance)
            return lambda steps, seen=None: library.sweep(method, bound, pointer(times), pointer(given), steps, pointer(seen))

        if is_tree:
            ways[f"CasADi straight lines, {words}", None] = way(0, 1e-8)
            ways[f"Pinocchio's templates printed by CasADi, {words}", None] = way(2, 1e-8)
        else:
            ways |= {(f"CasADi straight lines, {words}", tolerance): way(0, tolerance) for tolerance in TOLERANCES}
            ways[f"CasADi fast_newton, {words}", None] = way(1, 1e-8)
    if is_tree:
        library = pinocchio_peers.called(model)
        ways["Pinocchio, C++ -O3", None] = lambda steps, seen=None: library.sweep(pointer(times), steps, pointer(seen))
    return ways


def space_errors(way, times, exact, bodies):
    """Largest errors of pose, velocities and accelerations, relative to the largest entry, which counts at least 1."""
    import numpy

    seen = numpy.zeros((len(times), bodies, 24))
    way(len(times), seen)
    steps = [step for step, _ in exact]
    numbers = numpy.array([numbers for _, numbers in exact]).reshape(-1, bodies, 24)
    off = numpy.abs(seen[steps] - numbers)
    kinds = (slice(0, 12), slice(12, 18), slice(18, 24))
    return [float(off[..., kind].max() / max(1.0, numpy.abs(numbers[..., kind]).max())) for kind in kinds]


def space(rounds):
    found = data("space")
    times, errors, problems = array(found["times"]), {}, {}
    for workload in found["workloads"]:
        model = workload["model"]
        name, bodies = model["name"], len(model["bodies"])
        if bodies > MANY:
            continue
        ways = space_ways(model, times)
        of_peers = {key: space_errors(way, times, workload["exact"], bodies) for key, way in ways.items()}
        errors[name] = of_peers | {(who, None): of for who, of in workload["errors"].items()}
        problems[name] = {key: repeated(way, len(times)) for key, way in ways.items()}
    results = {}
    for problem, measured in medians(Ours("space"), problems, rounds).items():
        lines = []
        for key, (took, ratio) in measured.items():
            name, tolerance = key = key if isinstance(key, tuple) else (key, None)
            lines.append({"name": name, "tolerance": tolerance, "time": took, "ratio": ratio, "errors": errors[problem][key]})
        results[problem] = lines
    return results


def repeated(way, most):
    """As many steps as take a turn's time."""
    steps = affordable(way, most)
    return lambda turn: way(steps)


# Accelerations and torques.


def answer_ways(problem):
    """Contenders by name: functions of a number of evaluations and an array for what is seen."""
    import forces_peers
    import pinocchio_peers
    import trees

    model, name = problem["model"], problem["name"]
    folder, states = folder_of(name), array(problem["states"])
    flat, all_states = states.reshape(len(states), -1), len(states)
    more = []
    if model["cuts"]:
        functions = [forces_peers.accelerations(model, "qr")]
        if functions[0].size1_out(0) <= LINES:
            functions.insert(0, forces_peers.accelerations(model, "lines"))
        words = {"answer_lines": "CasADi straight lines", "answer_qr": "CasADi QR"}
        called = {words[function.name()]: function.name() for function in functions}
        outputs = functions[0].size1_out(0)
        trees.printed(functions, folder, [f"enum {{ INPUTS = {flat.shape[1]}, OUTPUTS = {outputs} }};", "#define OUTPUTS OUTPUTS"])
        more.append(folder / "step.c")
    else:
        sizes = pinocchio_peers.print_c(model, folder)
        outputs = len(model["bodies"])
        lines = [f"#define CASADI_{kind} {size + 1}" for kind, size in sizes.items()]
        lines += [f"enum {{ INPUTS = {flat.shape[1]}, OUTPUTS = {outputs} }};", "#define OUTPUTS OUTPUTS"]
        (folder / "mechanism.h").write_text("\n".join(lines) + "\n")
        called = {"Pinocchio's templates printed by CasADi": "torques" if states.shape[1] == 3 else "accelerations"}
        more.append(folder / "answers.c")
    ways = {}
    for words, library in compiled(folder, [HERE / "forces.c", *more]).items():
        library.evaluate.restype = ctypes.c_double
        for who, function in called.items():
            code = ctypes.cast(getattr(library, function), ctypes.c_void_p)
            ways[f"{who}, {words}"] = lambda count, seen=None, library=library, code=code: library.evaluate(
                code, pointer(flat), all_states, count, pointer(seen)
            )
    if not model["cuts"]:
        library, is_inverse = pinocchio_peers.called(model), int(states.shape[1] == 3)
        ways["Pinocchio, C++ -O3"] = lambda count, seen=None: library.evaluate(is_inverse, pointer(flat), all_states, count, pointer(seen))
    return ways, outputs


def answer_error(way, outputs, problem):
    """The largest difference of what is computed: accelerations of the coordinates, or efforts."""
    import numpy

    seen = numpy.zeros((len(problem["states"]), outputs))
    way(len(seen), seen)
    kind = "efforts" if len(problem["states"][0]) == 3 else "accelerations"
    return max(float(numpy.abs(seen[exact["state"]][: len(exact[kind])] - exact[kind]).max()) for exact in problem["exact"])


def dynamics(rounds):
    errors, problems = {}, {}
    for problem in data("dynamics"):
        ways, outputs = answer_ways(problem)
        errors[problem["name"]] = {name: answer_error(way, outputs, problem) for name, way in ways.items()} | problem["errors"]
        problems[problem["name"]] = {name: repeated(way, EVALUATIONS) for name, way in ways.items()}
    line = lambda problem, name, took, ratio: {"name": name, "time": took, "ratio": ratio, "error": errors[problem][name]}
    found = medians(Ours("dynamics"), problems, rounds)
    return {problem: [line(problem, name, *pair) for name, pair in measured.items()] for problem, measured in found.items()}


# Motions.

INTEGRATORS = {"CVODE, Adams": 0, "CVODE, BDF": 1, "DOP853 of numbalsoda": 2}


def started(model):
    """Coordinates at the beginning, of which the first is exact, and its derivative rows that say nothing new left out."""
    import casadi
    import numpy

    import forces_peers
    import trees

    size = len(model["start"])
    q, v = casadi.SX.sym("q", size), casadi.SX.sym("v", size)
    zero = [casadi.SX(0)] * size
    made = trees.frames(model, casadi.vertsplit(q), zero, zero)
    residuals = casadi.Function("residuals", [q], [trees.rows(model, made, None, None)[0]])
    rows = casadi.Function("rows", [q, v], [forces_peers.motion(model, q, v)[2]])
    values = numpy.array(model["start"])
    slope = casadi.Function("slope", [q], [casadi.jacobian(residuals(q), q)])
    for _ in range(20):
        change = numpy.linalg.lstsq(numpy.array(slope(values))[:, 1:], numpy.array(residuals(values)).ravel(), rcond=None)[0]
        values[1:] -= change
    matrix = numpy.array(rows(values, numpy.zeros(size)))
    kept = []
    for row in range(len(matrix)):
        if numpy.linalg.matrix_rank(matrix[kept + [row]], tol=1e-9) > len(kept):
            kept.append(row)
    return values, [row for row in range(len(matrix)) if row not in kept]


def followed(problem):
    """The function of derivatives and the state at the beginning."""
    import numpy

    import forces_peers

    given = problem["given"]
    if "numbers" in given:
        return forces_peers.of_top(given["numbers"]), array(given["start"])
    model = given["model"]
    values, dependent = started(model)
    model["dependent"] = dependent
    return forces_peers.derivative(model, values), array(numpy.concatenate([values, numpy.zeros(len(values))]))


def motion_error(given, end):
    if "center" in given:
        w, x, y, z = end[:4]
        size = sum(end[:4] ** 2)
        center = [2 * (x * y - w * z) / size, (w * w - x * x + y * y - z * z) / size, 2 * (y * z + w * x) / size]
        return max(abs(found - exact) for found, exact in zip(center, given["center"]))
    if "relative" in given:
        return max(abs((end[k] - exact) / exact) for k, exact in given["relative"])
    return max(abs(end[k] - exact) for k, exact in given["absolute"])


def motion_ways(problem):
    """Contenders by name and tolerance: functions that return time and error."""
    import pathlib

    import numbalsoda
    import sksundae

    import trees

    folder, given = folder_of(problem["name"] + " motion"), problem["given"]
    derive, start = followed(problem)
    trees.printed([derive], folder, [f"enum {{ SIZE = {len(start)} }};", "#define HAS_MOTION"])
    of_cvode = pathlib.Path(sksundae.__file__).parent.parent / "scikit_sundae.libs"
    names = ("core", "cvode", "nvecserial", "sunmatrixdense", "sunlinsoldense")
    dop853 = pathlib.Path(numbalsoda.__file__).parent / "libdop853.so"
    wheels = [*(library for name in names for library in of_cvode.glob(f"libsundials_{name}-*")), f"-Wl,-rpath,{of_cvode}", dop853]
    library = environment.library(folder / "motion.so", FLAGS["-O3"], ["-I", folder, HERE / "forces.c", folder / "step.c", *wheels])
    library.follow.restype = ctypes.c_double
    duration = ctypes.c_double(given["duration"])

    def way(method, tolerance):
        def run():
            y = start.copy()
            took = library.follow(method, duration, ctypes.c_double(tolerance), pointer(y))
            return took, motion_error(given, y)

        return run

    ways = {(name, tolerance): way(method, tolerance) for name, method in INTEGRATORS.items() for tolerance in FOLLOWED}
    return ways | (taylor_ways(given) if "numbers" in given else {})


def taylor_ways(given):
    """The same by heyoka, which compiles a stepper for each tolerance."""
    import heyoka

    import forces_peers

    names = heyoka.make_vars(*"wxyzabc")
    rates = [heyoka.expression(rate) if isinstance(rate, float) else rate for rate in forces_peers.top(given["numbers"], names)]

    def way(tolerance):
        stepper = heyoka.taylor_adaptive(list(zip(names, rates)), given["start"], tol=tolerance)

        def run():
            begin = time.perf_counter_ns()
            stepper.time, stepper.state[:] = 0.0, given["start"]
            outcome = stepper.propagate_until(given["duration"])[0]
            took = time.perf_counter_ns() - begin
            return took if outcome == heyoka.taylor_outcome.time_limit else -1, motion_error(given, stepper.state)

        return run

    return {("heyoka", tolerance): way(tolerance) for tolerance in FOLLOWED}


def motion(rounds):
    lines, problems = {}, {}
    for problem in data("motion"):
        ours = {own["name"]: {"name": own["who"], "tolerance": own["tolerance"], "error": own["error"]} for own in problem["ours"]}
        of_problem, ways = lines.setdefault(problem["name"], ours), problems.setdefault(problem["name"], {})
        for (name, tolerance), way in motion_ways(problem).items():
            way()
            took, error = way()
            # What stops on the way is no result.
            if took >= 0:
                key = f"{name}, {tolerance:e}"
                of_problem[key] = {"name": name, "tolerance": tolerance, "error": error}
                ways[key] = rarely(way, RARE if took > TURN else 1)
    for problem, measured in medians(Ours("motion"), problems, rounds).items():
        for key, (took, _) in measured.items():
            lines[problem][key]["time"] = took
    return {problem: list(of_problem.values()) for problem, of_problem in lines.items()}


def rarely(way, every):
    """The time of a way in some of the rounds."""
    return lambda turn: None if turn % every else way()[0]


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    parts = sys.argv[2:] or ["space", "dynamics", "motion"]
    cargo = ["cargo", "build", "--quiet", "--release", "-p", "reuleaux-benches"]
    subprocess.run([*cargo, *(word for binary in BINARIES for word in ("--bin", binary))], cwd=WORKSPACE, check=True)
    path = HERE / "space_forces.json"
    results = json.loads(path.read_text()) if path.exists() else {}
    for name in parts:
        found = {"space": space, "dynamics": dynamics, "motion": motion}[name](rounds)
        results[name] = [{"problem": problem, "lines": lines} for problem, lines in found.items()]
    path.write_text(json.dumps(results, indent=1) + "\n")
    subprocess.run(["cargo", "run", "--quiet", "--release", "-p", "reuleaux-benches", "--bin", "peers"], cwd=WORKSPACE, check=True)


if __name__ == "__main__":
    environment.enter("requirements_space.txt", "environment_space")
    main()
