"""Robotics libraries on the same chain: Pinocchio's aba and MuJoCo's mj_forward, called from C.

Their joint angles are relative, r_i = q_i - q_(i-1), and so are their accelerations; the states are
converted before, the accelerations after what is timed.
"""

import ctypes
import importlib.util
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path

import numpy as np

from benchmarks.kernels.c_loops import FLAGS
from benchmarks.kernels.case import Array, Case
from benchmarks.kernels.race import Contender, Lap
from mechanics.errors import CompilerError

HERE = Path(__file__).parent
EIGEN = Path("/usr/include/eigen3")
# Without these Boost's lists are too short for Pinocchio's joints.
BOOST = ("-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS")
TINY = 1e-15
"""MuJoCo wants an inertia, in kg m^2; this is the least that it takes."""
MUJOCO_AGREEMENT = 1e-7

Arguments = list[Array]


def pinocchio() -> Contender:
    """Aba of the library in the package `pin`, with the settings that it was built for."""

    def prepare(case: Case) -> Lap:
        library = _pinocchio()
        library.chain_new.restype = ctypes.c_void_p
        lengths, masses = (np.ascontiguousarray(a) for a in (case.lengths, case.masses))
        chain = ctypes.c_void_p(
            library.chain_new(
                case.links, ctypes.c_double(case.p[0]), address(lengths), address(masses)
            )
        )
        return _lap(case, lambda *arrays: library.loop(chain, *arrays))

    return Contender("Pinocchio aba", no_pinocchio, prepare)


def no_pinocchio() -> str:
    """Why Pinocchio cannot run here; empty if it can."""
    if importlib.util.find_spec("pinocchio") is None:
        return "Pinocchio is not installed: pip install pin"
    if not EIGEN.exists() or not shutil.which("g++"):
        return "Pinocchio's headers need g++ and Eigen (libeigen3-dev)"
    return ""


@cache
def _pinocchio() -> ctypes.CDLL:
    import pinocchio

    prefix = Path(pinocchio.__file__).parents[4]
    where = f"-I{prefix}/include -I{EIGEN} -L{prefix}/lib -Wl,-rpath,{prefix}/lib"
    words = "-std=c++17 -O2 -DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION"
    return built("g++", HERE / "pinocchio_aba.cpp", [*words.split(), *BOOST, *where.split()],
                  ["-lpinocchio_default"])  # fmt: skip


def mujoco() -> Contender:
    """mj_forward of the package `mujoco`."""

    def absent() -> str:
        if importlib.util.find_spec("mujoco") is None:
            return "mujoco is not installed"
        return "" if shutil.which("gcc") else "no gcc"

    def prepare(case: Case) -> Lap:
        import mujoco

        folder = Path(mujoco.__file__).parent
        (shared,) = folder.glob("libmujoco.so.*")
        # Every chain has a library, and so a model, of its own.
        library = built("gcc", HERE / "mujoco_forward.c", [*FLAGS.split(), f"-I{folder}/include"],
                        [str(shared), f"-Wl,-rpath,{folder}"])  # fmt: skip
        why = ctypes.create_string_buffer(1000)
        with tempfile.TemporaryDirectory(prefix="mechanics-") as scratch:
            file = Path(scratch) / "chain.xml"
            file.write_text(mjcf(case), encoding="ascii")
            if not library.chain_load(str(file).encode(), why, len(why)):
                raise CompilerError(f"MuJoCo refuses the chain: {why.value.decode()}")
        return _lap(case, library.loop)

    return Contender("MuJoCo mj_forward", absent, prepare, MUJOCO_AGREEMENT)


def mjcf(case: Case) -> str:
    """The chain as MuJoCo's XML."""

    def inertial(mass: float, y: float) -> str:
        return (f'<inertial pos="0 {y!r} 0" mass="{mass!r}"'
                f' diaginertia="{TINY} {TINY} {TINY}"/>')  # fmt: skip

    lengths, masses = case.lengths.tolist(), case.masses.tolist()
    inner = ""
    for i in reversed(range(case.links)):
        y = lengths[i - 1] if i else 0.0
        inner = (f'<body pos="0 {y!r} 0"><joint type="hinge" axis="0 0 1"/>'
                 f"{inertial(masses[i + 1], lengths[i])}{inner}</body>")  # fmt: skip
    g = float(case.p[0])
    return (
        f'<mujoco><compiler angle="radian"/><option gravity="0 {-g!r} 0"/><worldbody>'
        f'<body><joint type="slide" axis="1 0 0"/>{inertial(masses[0], 0.0)}{inner}</body>'
        "</worldbody></mujoco>"
    )


def built(compiler: str, source: Path, before: Sequence[str], after: Sequence[str]) -> ctypes.CDLL:
    """A library of one source, compiled with words before and after its name."""
    with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
        library = Path(folder) / "peer.so"
        command = [compiler, "-shared", "-fPIC", *before, str(source), "-o", str(library), *after]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise CompilerError(f"{compiler} refused {source.name}: {done.stderr.strip()[:500]}")
        return ctypes.CDLL(str(library))


def address(array: Array) -> ctypes.c_void_p:
    """Where the numbers of an array stand."""
    return ctypes.c_void_p(array.ctypes.data)


def _lap(case: Case, call) -> Lap:
    relative = [np.ascontiguousarray(_differences(a).T) for a in (case.q, case.u)]
    forces = np.zeros_like(relative[0])
    forces[:, 0] = case.inputs[0]
    arrays = [*relative, forces, np.empty_like(forces)]
    arguments = [ctypes.c_long(case.count), *map(address, arrays)]
    return Lap(
        lambda: call(*arguments),
        case.count,
        lambda: np.vstack([arrays[-1].T[:1], np.cumsum(arrays[-1].T[1:], axis=0)]),
    )


def _differences(entries: Array) -> Array:
    """Entries of the joints: the cart's and the first link's are absolute."""
    return np.vstack([entries[:2], np.diff(entries[1:], axis=0)])
