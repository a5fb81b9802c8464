"""All faults. A row whose text has changed fails in `tests/benchmarks/test_benchmark_faults.py`."""

from benchmarks.faults import (
    rows_joints,
    rows_kernel,
    rows_linear,
    rows_motion,
    rows_programs,
    rows_rolling,
    rows_routes,
    rows_scene,
)
from benchmarks.faults.fault import Fault

FAULTS: tuple[Fault, ...] = (
    *rows_scene.ROWS,
    *rows_motion.ROWS,
    *rows_routes.ROWS,
    *rows_kernel.ROWS,
    *rows_programs.ROWS,
    *rows_joints.ROWS,
    *rows_rolling.ROWS,
    *rows_linear.ROWS,
)
