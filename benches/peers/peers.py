"""Other people's solvers on the same linkages: `python3 benches/peers/peers.py [rounds]`, with any Python from 3.10.

In: nothing. Out: `results.json` beside this file. Makes an environment under the target folder with the packages pinned in
`requirements.txt`, takes the linkages and their exact motion from `cargo run --bin linkages`, generates and compiles C, and goes
through all contenders in turn in each round: medians of times, and of the ratios to the closed form in C of the same round.
"""

import ctypes
import json
import os
import pathlib
import statistics
import subprocess
import sys

sys.dont_write_bytecode = True

import environment
from environment import HERE, TARGET, WORKSPACE

LONGEST = int(os.environ.get("LONGEST", "320"))
"""Linkages of more links than this are left out: their C takes minutes to compile."""
FLAGS = {"-O3": ["-O3"], "-O3 -march=native": ["-O3", "-march=native"]}
METHODS = {
    "dyads in closed form, C": 0,
    "SymPy C, dense LU, predictor": 1,
    "SymPy C, KLU, predictor": 2,
    "CasADi fast_newton, predictor": 3,
    "CasADi fast_newton": 4,
}
TURN = 0.005
"""How long a contender may take in one round, in s; a slower one goes through the beginning of the period only."""


def linkages():
    """All linkages, with the motion of their tracked points."""
    command = ["cargo", "run", "--quiet", "--release", "-p", "reuleaux-benches", "--bin", "linkages"]
    found = json.loads(subprocess.run(command, cwd=WORKSPACE, check=True, capture_output=True).stdout)
    found["linkages"] = [linkage for linkage in found["linkages"] if len(linkage["links"]) <= LONGEST]
    return found


def compiled(folder, flags):
    """The C code of a linkage as a library."""
    import kvxopt

    beside = pathlib.Path(kvxopt.__file__).parent.parent / "kvxopt.libs"
    (klu,) = beside.glob("libklu*")
    sources = ["-I", folder, "-I", HERE, HERE / "harness.c", folder / "step.c", klu, f"-Wl,-rpath,{beside}"]
    return environment.library(folder / f"{''.join(flags)}.so", flags, sources)


class Compiled:
    """A method of the C library."""

    def __init__(self, library, method, times):
        self.library, self.method, self.times = library, method, times
        self.library.sweep.restype = ctypes.c_double
        self.steps = 10
        self.exists = self.sweep()[0] > 0
        self.steps = max(10, min(len(times), int(TURN * 1e9 / max(self.sweep()[0], 1.0))))

    def sweep(self):
        """ns per step; what was seen is asked for by `seen`."""
        pointer = ctypes.c_void_p(self.times.ctypes.data)
        return self.library.sweep(self.method, pointer, self.steps, None), None, None

    def seen(self):
        import numpy

        seen = numpy.zeros((len(self.times), 4))
        pointer = ctypes.c_void_p(seen.ctypes.data)
        self.library.sweep(self.method, ctypes.c_void_p(self.times.ctypes.data), len(self.times), pointer)
        return seen[:, :2], seen[:, 2:]


def contenders(linkage, times):
    """Contenders by name."""
    from bodies import dyads
    from exudyn_peer import Exudyn
    from generate import write
    from pylinkage_peer import Pylinkage

    folder = TARGET / "".join(letter if letter.isalnum() else "_" for letter in linkage["name"])
    folder.mkdir(parents=True, exist_ok=True)
    write(linkage, folder)
    found = {}
    for words, flags in FLAGS.items():
        library = compiled(folder, flags)
        made = {f"{name}, {words}": Compiled(library, method, times) for name, method in METHODS.items()}
        found |= {name: contender for name, contender in made.items() if contender.exists}
    if dyads(linkage) and linkage["crank"]["law"] == "turning":
        found["pylinkage, numba"] = Pylinkage(linkage, len(times))
    if len(linkage["links"]) < 50:
        found["Exudyn"] = Exudyn(linkage, len(times))
    return found


def measure(linkage, times, rounds):
    """A line for each contender."""
    import numpy

    made = contenders(linkage, times)
    nanoseconds = {name: [] for name in made}
    seen = {name: contender.seen() if isinstance(contender, Compiled) else contender.sweep()[1:] for name, contender in made.items()}
    for turn in range(rounds):
        for name, contender in made.items():
            # The slowest has fewer turns.
            if name != "Exudyn" or turn % 20 == 0:
                nanoseconds[name].append(contender.sweep()[0])
    first = nanoseconds.get("dyads in closed form, C, -O3")
    lines = []
    for name in made:
        places, accelerations = seen[name]
        exact = numpy.array(linkage["places"]), numpy.array(linkage["accelerations"])
        distance = lambda of, reference: float(numpy.hypot(*(of - reference).T).max())
        ratios = [time / base for time, base in zip(nanoseconds[name], first)] if first else []
        lines.append({
            "name": name,
            "time": statistics.median(nanoseconds[name]),
            "ratio": statistics.median(ratios) if ratios else None,
            "position": distance(places, exact[0]) / linkage["size"],
            "acceleration": distance(accelerations, exact[1]) / float(numpy.hypot(*exact[1].T).max()),
        })
        print(linkage["name"], lines[-1], flush=True)
    return lines


def main():
    import numpy

    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    os.environ["NUMBA_CACHE_DIR"] = str(TARGET / "numba")
    data = linkages()
    times = numpy.array(data["times"])
    results = {linkage["name"]: measure(linkage, times, rounds) for linkage in data["linkages"]}
    (HERE / "results.json").write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    environment.enter("requirements.txt", "environment")
    main()
