"""Pinocchio on an arm: its templates printed as C through CasADi, and its own algorithms called from C++."""

import ctypes
import os
import pathlib
import subprocess

from environment import HERE, TARGET

DEFINED = [
    "BOOST_MPL_LIMIT_LIST_SIZE=30",
    "BOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
    "BOOST_FUSION_INVOKE_MAX_ARITY=12",
]
"""What the package of Pinocchio asks of whoever includes its headers."""


def built(source, flags, name):
    """A C++ source compiled against the wheels, if it is not there yet; it takes a minute."""
    import casadi
    import cmeel

    out = TARGET / name
    sources = [HERE / source, HERE / "arm.hpp"]
    if out.exists() and all(out.stat().st_mtime > source.stat().st_mtime for source in sources):
        return out
    of_casadi = pathlib.Path(casadi.__file__).parent
    (library,) = of_casadi.glob("libcasadi.so.*")
    prefix = pathlib.Path(cmeel.__file__).parent.parent / "cmeel.prefix"
    includes = [f"-I{of_casadi}/include", f"-I{prefix}/include", f"-I{prefix}/include/eigen3"]
    libraries = [library, f"-L{prefix}/lib", "-lpinocchio_default", f"-Wl,-rpath,{of_casadi}", f"-Wl,-rpath,{prefix}/lib"]
    command = [os.environ.get("CXX", "c++"), "-std=c++17", "-w", *flags, *(f"-D{name}" for name in DEFINED), *includes]
    subprocess.run([*command, sources[0], *libraries, "-o", out], check=True)
    return out


def described(model):
    """An arm in the order of `arm.hpp`."""
    laws = dict(model["drives"])
    lines = [str(len(model["bodies"]))]
    for k, body in enumerate(model["bodies"]):
        law = laws[k][1:] if k in laws else [0.0] * 4
        entries = [*body["place"], *sum(body["turned"], []), body["mass"], *body["center"], *body["inertia"], *law]
        lines.append(" ".join(map(repr, map(float, entries))))
    return "\n".join(lines) + "\n"


def print_c(model, folder):
    """`tree.c` and `answers.c`; returns the largest sizes of work arrays."""
    program = built("arm_printed.cpp", ["-O1"], "arm_printed")
    output = subprocess.run([program], cwd=folder, input=described(model), text=True, capture_output=True, check=True).stdout
    sizes = [list(map(int, line.split())) for line in output.splitlines()]
    return dict(zip(("ARG", "RES", "IW", "W"), map(max, zip(*sizes))))


def called(model):
    """The library with Pinocchio's own algorithms, with an arm of its own."""
    library = ctypes.CDLL(str(built("arm_called.cpp", ["-O3", "-DNDEBUG", "-shared", "-fPIC"], "arm_called.so")))
    library.sweep.restype = library.evaluate.restype = ctypes.c_double
    library.load(described(model).encode())
    return library
