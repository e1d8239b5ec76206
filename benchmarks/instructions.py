"""Instructions of the covariance on an emulated Cortex-M4F in float, counted while the shipped self-test runs.

python -m benchmarks.instructions [generated/azimuth_hold [-Os]]
"""

import sys
import tempfile
from pathlib import Path

from boresight.evidence.machine import Machine
from boresight.evidence.sources import Folder
from boresight.evidence.targets import M4F, build

WATCHED = ("discretize", "joseph_predict", "ud_predict", "predict_state", "joseph_update", "ud_update", "ud_add",
           "filter_propagate", "F_nz", "Qc_nz")  # fmt: skip


def main(path: str = "generated/azimuth_hold", flag: str = "-Os") -> None:
    """Least and most of each function with what it calls; the most is that of a covariance with every correlation."""
    folder = Folder(Path(path).resolve())
    prefix = folder.manifest["c_prefix"]
    with tempfile.TemporaryDirectory() as out:
        made = build(folder, M4F, "float", Path(out), flag, "-ffunction-sections", "-fdata-sections")
        machine = Machine(made, made.image, tuple(f"{prefix}_{name}_f32" for name in WATCHED))
        machine.run_tests([f"{prefix}_covariance", f"{prefix}_filter"])
    print(f"{folder.name}, {flag}: {'least':>8} {'most':>8} {'stack, B':>9}")
    for name, cost in sorted(machine.costs.items()):
        print(f"{name:28} {cost.least:8} {cost.most:8} {cost.stack:9}")


if __name__ == "__main__":
    main(*sys.argv[1:])
