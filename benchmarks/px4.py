"""examples/autopilot.py beside the headers of PX4's ekf2: python -m benchmarks.px4 DIR, or PX4=DIR in the environment

DIR is a checkout of PX4.  Its generated headers are compiled aside, with a matrix class of a few lines, and called at
random points; nothing of them is copied.  Errors are true - nominal there, but for the attitude's, which has one sign
in both: x_PX4 = S x, so that H_PX4 = -H S and A_PX4 = S Phi S.  Of `predict_covariance` A P A' is compared, with no
noise: what each adds as noise is another formula.
"""

import os
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.autopilot import EQUAL, POINTS, points, sides
from boresight import BoresightError, generate, load
from boresight.examples import autopilot

HEADERS = Path("src/modules/ekf2/EKF/python/ekf_derivation/generated")
SIGN = np.array([1.0] * 3 + [-1.0] * 21)  # of each error, beside ours
SIDE = {"sideslip": 0, "flow": 1, "antennas": 2, "declination": 3}  # which small number epsilon keeps off zero

# Each row of ours: which header has it, under any of the names that it had, and the number that epsilon stands for.
ROWS = {
    ("mag", 0): ("compute_mag_innov_innov_var_and_hx", 0.0),
    ("mag", 1): ("compute_mag_y_innov_var_and_h", 0.0),
    ("mag", 2): ("compute_mag_z_innov_var_and_h", 0.0),
    ("airspeed", 0): ("compute_airspeed_h", 1e-6),
    ("sideslip", 0): ("compute_sideslip_h", 1e-3),
    ("flow", 0): ("compute_flow_xy_innov_var_and_hx", 0.1),
    ("flow", 1): ("compute_flow_y_innov_var_and_h", 0.1),
    ("antennas", 0): ("compute_gnss_yaw_(pred|innon)_innov_var_and_h", 1e-6),
    ("declination", 0): ("compute_mag_declination_(pred|innov)_innov_var_and_h", 1e-6),
    ("height", 0): ("compute_hagl_h", 0.0),
}
MATRIX = """#pragma once
#include <cmath>
#include <algorithm>
namespace matrix {
template <typename S, int M, int N> struct Matrix {
    S v[M * N] = {};
    S &operator()(int i, int j) { return v[i * N + j]; }
    const S &operator()(int i, int j) const { return v[i * N + j]; }
    void setZero() { for (S &one : v) one = 0; }
};
}
namespace math {
template <typename S> S min(S a, S b) { return a < b ? a : b; }
template <typename S> S max(S a, S b) { return a < b ? b : a; }
}
"""


@dataclass(frozen=True)
class Header:
    """A generated function: its name, what it reads and what it gives, each with its size."""

    path: Path
    text: str
    name: str
    reads: tuple[tuple[str, tuple[int, int]], ...]
    gives: tuple[tuple[str, tuple[int, int]], ...]

    @property
    def program(self) -> str:
        """Reads numbers and writes numbers, point after point."""
        lines, given = [], []
        for name, (m, n) in (*self.reads, *self.gives):
            kind = "double" if m * n == 1 else f"matrix::Matrix<double, {m}, {n}>"
            lines.append(f"{kind} {name}{{}};")
        for name, (m, n) in self.reads:
            into = f"&{name}" if m * n == 1 else f"{name}.v"
            lines.append(f"if (std::fread({into}, 8, {m * n}, stdin) != {m * n}) return 0;")
            given.append(name)
        returned = not re.search(rf"void {self.name}\(", self.text)
        call = f"sym::{self.name}<double>({', '.join(given + ([] if returned else ['&' + g for g, _ in self.gives]))});"
        lines.append(f"{self.gives[0][0]} = {call}" if returned else call)
        for name, (m, n) in self.gives:
            lines.append(f"std::fwrite({f'&{name}' if m * n == 1 else f'{name}.v'}, 8, {m * n}, stdout);")
        body = f"for (int point = 0; point < {POINTS}; ++point) {{ {' '.join(lines)} }}"
        return f'#include "{self.path}"\n#include <cstdio>\nint main() {{ {body} }}\n'

    def call(self, folder: Path, given: dict[str, Any]) -> dict[str, Any]:
        """What it gives for the points given, by name, (POINTS, m, n) each."""
        (folder / "matrix").mkdir(exist_ok=True)
        (folder / "matrix" / "math.hpp").write_text(MATRIX)
        (folder / f"{self.name}.cpp").write_text(self.program)
        built = folder / self.name
        command = ["g++", "-std=c++17", "-O1", f"-I{folder}", f"{built}.cpp", "-o", f"{built}"]
        made = subprocess.run(command, capture_output=True, text=True, check=False)
        if made.returncode:
            why = next((line for line in made.stderr.splitlines() if "error:" in line), made.stderr.strip())
            raise BoresightError(f"{self.path.name} does not compile: {why}")
        nothing = np.zeros((POINTS, 0))
        read = [nothing, *(np.broadcast_to(given[name], (POINTS, m * n)) for name, (m, n) in self.reads)]
        done = subprocess.run([built], input=np.concatenate(read, -1).tobytes(), capture_output=True, check=True)
        wide = np.frombuffer(done.stdout).reshape(POINTS, -1)
        ends = np.cumsum([m * n for _, (m, n) in self.gives])[:-1]
        parts = np.split(wide, ends, axis=-1)
        return {name: part.reshape(POINTS, m, n) for (name, (m, n)), part in zip(self.gives, parts, strict=True)}


def header(folder: Path, pattern: str) -> Header | None:
    """The header of that name, if there is one.  Raises BoresightError where it is no function of SymForce's."""
    path = next((p for p in sorted(folder.glob("*.h")) if re.fullmatch(pattern, p.stem)), None)
    if path is None:
        return None
    text = path.read_text()
    parts = re.search(r"Args:\n(.*?) \*\n \* Outputs:\n(.*?) \*/\n.*?(\w+)\(", text, re.DOTALL)
    if parts is None:
        raise BoresightError(f"{path} does not say what it reads and gives; this script reads SymForce's headers")

    def sizes(lines: str) -> tuple[tuple[str, tuple[int, int]], ...]:
        found = re.findall(r"\* +(\w+): (?:Scalar|Matrix(\d+)_(\d+)|Matrix(\d)(\d))$", lines, re.MULTILINE)
        return tuple((name, (int(a or c or 1), int(b or d or 1))) for name, a, b, c, d in found)

    name = re.search(r"(\w+)\(\s*(?:const matrix::|matrix::Matrix)", text[parts.end(2) :])
    assert name, path
    return Header(path.resolve(), text, name[1], sizes(parts[1]), sizes(parts[2]))


def epsilon(one: Header, least: float, side: Any) -> Any:
    """What has to be given for a small number to be kept off zero by `least`; (POINTS, 1).

    Older headers add epsilon (sign + 1/2), newer ones epsilon times a sign that is never zero.
    """
    old = "Scalar(0.5)" in one.text and "::min" not in one.text
    return np.where(side > 0, least / 1.5, 2 * least) if old else np.full_like(side, least)


def differences(tree: Path, folder: Path, rng: np.random.Generator) -> dict[str, float | None]:
    """By function the largest difference as a part of the largest of its row; None where the tree lacks it."""
    place = tree / HEADERS
    if not place.is_dir():
        raise BoresightError(f"{place} is no folder; name a checkout of PX4")
    library = load(generate(autopilot.AUTOPILOT, folder / "ours").folder)
    at = points(rng)
    side = sides(at)
    found: dict[str, float | None] = {}
    at["accel"] = at["delta_vel"] / at["dt"][:, None]
    state = np.concatenate([at["q"], *(np.reshape(at[name], (POINTS, -1)) for name in autopilot.nav)], -1)
    root = rng.standard_normal((POINTS, 24, 24))
    P = root @ np.swapaxes(root, -1, -2)

    def given(one: Header, n: int) -> dict[str, Any]:
        """n: how many errors it has; without the ground there are 23."""
        zero = dict.fromkeys(("accel_var", "gyro_var", "R", "meas"), 0.0)
        return {**zero, "state": state[:, : n + 1], "P": P[:, :n, :n].reshape(POINTS, -1), "accel": at["accel"],
                "gyro": 0.0, "dt": at["dt"][:, None], "antenna_yaw_offset": at["antenna_offset"][:, None]}  # fmt: skip

    def worst(ours: Any, theirs: Any) -> float:
        off = np.abs(ours - theirs) / np.abs(theirs).max(-1, keepdims=True)
        return float(off.max()) if np.isfinite(off).all() else float("inf")

    for (name, row), (pattern, least) in ROWS.items():
        one, key = header(place, pattern), f"{name}_H row {row}"
        if one is None:
            found[key] = None
            continue
        output, (n, _) = next((g for g in one.gives if g[1][0] > 1), one.gives[-1])
        small = side[:, SIDE[name], None] if name in SIDE else np.ones((POINTS, 1))
        off_zero = epsilon(one, least, small) if name in SIDE else least
        theirs = one.call(folder, given(one, n) | {"epsilon": off_zero})[output].reshape(POINTS, n)
        unit = library.units[f"{name}_H"]
        ours = -np.asarray(unit(**{field: at[field] for field in unit.fields}))[..., row, :] * SIGN
        found[key] = worst(ours[..., :n], theirs)

    one = header(place, "predict_covariance")
    found["Phi P Phi'"] = None
    if one is not None:
        n = one.gives[0][1][0]
        unit = library.units["Phi"]
        Phi = (SIGN[:, None] * np.asarray(unit(**{field: at[field] for field in unit.fields})) * SIGN)[:, :n, :n]
        ours = np.triu(Phi @ P[:, :n, :n] @ np.swapaxes(Phi, -1, -2)).reshape(POINTS, -1)
        theirs = np.triu(one.call(folder, given(one, n))["res"]).reshape(POINTS, -1)
        found["Phi P Phi'"] = worst(ours, theirs)
    return found


def main() -> int:
    tree = sys.argv[1] if len(sys.argv) > 1 else os.environ.get("PX4", "")
    if not tree:
        print("benchmarks.px4: name a checkout of PX4, as in PX4=DIR python -m benchmarks.px4")
        return 2
    with tempfile.TemporaryDirectory() as place:
        try:
            found = differences(Path(tree), Path(place), np.random.default_rng(0))
        except BoresightError as error:
            print(f"benchmarks.px4: {error}")
            return 2
    for name, off in found.items():
        print(f"{name:18} " + ("no header" if off is None else f"{off:9.1e}  {'equal' if off <= EQUAL else 'DIFFERS'}"))
    return int(not all(off is None or off <= EQUAL for off in found.values()) or set(found.values()) == {None})


if __name__ == "__main__":
    sys.exit(main())
