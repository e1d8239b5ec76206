"""By how many units in the last place the elementary functions err: at random points against quadruple precision, and
the sine and cosine in float at every float from 0 to 2 pi.  `python -m boresight.evidence.elementary` prints the table.
"""

import tempfile
from pathlib import Path

from boresight.codegen.text.files import environment
from boresight.evidence.targets import HARNESS, PRECISIONS
from boresight.runtime.compiler import run

HEADERS = ("boresight.h", "boresight_precision.h", "boresight_math.h")
FLAGS = ("-std=gnu99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror")


def headers(out: Path) -> Path:
    """The headers alone, as they lie in each generated folder."""
    for name in HEADERS:
        (out / name).write_text(environment().get_template(f"include/{name}.j2").render(exported=""))
    return out


def ulps(out: Path, precision: str, points: int, apart: int = 0) -> dict[str, tuple[float, str]]:
    """By function and range: the largest error in ulp, and where.

    points: how many random ones of each.  apart: in float, the sine and cosine also at every so many floats.
    """
    program = out / f"ulps_{precision}"
    flags = [*FLAGS, *PRECISIONS[precision], "-I", headers(out)]
    run(["gcc", *flags, HARNESS / "ulps.c", "-lquadmath", "-lm", "-o", program])
    rows = [line.split(",") for line in run([program, points, apart]).splitlines()]
    return {name: (float(worst), at) for name, worst, at in rows}


def main() -> None:
    with tempfile.TemporaryDirectory() as out:
        found = {precision: ulps(Path(out), precision, 1_000_000, 1) for precision in PRECISIONS}
    print("| function | float | double |\n| --- | --- | --- |")
    for name, (worst, _) in found["float"].items():
        double = f"{found['double'][name][0]:.3f}" if name in found["double"] else ""
        print(f"| {name} | {worst:.3f} | {double} |")


if __name__ == "__main__":
    main()
