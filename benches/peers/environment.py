"""Where peers live: an environment with pinned packages under the target folder, and the compilers."""

import ctypes
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
WORKSPACE = HERE.parent.parent
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", WORKSPACE / "target")) / "peers"


def enter(requirements, environment):
    """Starts the program again with the packages of `requirements`, unless it has them."""
    python = TARGET / environment / "bin/python"
    if pathlib.Path(sys.prefix).resolve() == python.parent.parent.resolve():
        return
    if not python.exists():
        subprocess.run([sys.executable, "-m", "venv", TARGET / environment], check=True)
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--requirement", HERE / requirements], check=True)
    os.execv(python, [python, *sys.argv])


def library(path, flags, sources):
    """C sources as a library."""
    compiler = os.environ.get("CC", "cc")
    subprocess.run([compiler, *flags, "-shared", "-fPIC", "-Wl,-Bsymbolic", *sources, "-lm", "-o", path], check=True)
    return ctypes.CDLL(str(path))
