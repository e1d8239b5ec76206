"""One flight, one hash: the same flight by every compiler and machine, whose digests must be equal.

The flight is harness/flight.c: inputs from integers, strapdown at each sample, propagate and digest at each hundredth,
messages that are late or lost.  Beside the C, the same flight by the compiled filter from Python.
"""

import hashlib
import shutil
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from boresight.codegen.folder import Folder
from boresight.evidence.machine import Machine
from boresight.evidence.targets import CLANG, GCC, HARNESS, M4F, M7, RV32, WARNINGS, Build, Target
from boresight.runtime.compiler import PRECISIONS, compile_sources, run

MODEL = "azimuth_hold"  # what is flown
SAMPLES, EVERY = 1_000_000, 10_000  # of the flight; from digest to digest
V3 = "-march=x86-64-v3"
CPU = Path("/proc/cpuinfo")


@dataclass(frozen=True)
class Flown:
    """What one build flew.  digests: one each 10 000 samples, of all up to there.

    refused: calls whose status was not BS_OK.  flushed: whether results, or inputs, below the normal numbers are
    taken for zero.  control: what the floating-point unit's control register says, 0 where there is none.
    """

    digests: tuple[str, ...]
    taken: int = 0
    rows: int = 0
    refused: int = 0
    flushed: tuple[bool, bool] = (False, False)
    control: int = 0


@dataclass(frozen=True)
class Machinery:
    """A target with its level of optimisation, and the program that runs what is built for it."""

    target: Target
    flags: tuple[str, ...] = ("-O2",)
    runs: str = ""
    precisions: tuple[str, ...] = tuple(PRECISIONS)

    @property
    def name(self) -> str:
        return " ".join((self.target.name, *self.flags))

    @property
    def missing(self) -> str:
        """Why it cannot be flown here, or nothing."""
        if V3 in self.flags and "avx2" not in (CPU.read_text() if CPU.is_file() else ""):
            return "this machine is no x86-64-v3"
        return self.target.missing or ("" if not self.runs or shutil.which(self.runs) else f"no {self.runs}")


X86 = tuple(
    Machinery(replace(target, flags=()), (f"-O{level}", *more))
    for target in (replace(GCC, name="x86-64 gcc"), CLANG)
    for level in range(4)
    for more in ((), (V3,))
)
OTHERS = (
    Machinery(Target("AArch64", "aarch64-linux-gnu-gcc", ("-static",)), runs="qemu-aarch64"),
    Machinery(Target("Armv7", "arm-linux-gnueabihf-gcc", ("-static",)), runs="qemu-arm"),
    # In double the M4F adds by libgcc's own software, which rounds some sums wrongly.
    Machinery(M4F, precisions=("float",)),
    Machinery(M7),
    Machinery(RV32),
)
MACHINES = X86 + OTHERS
NOT_FLOWN = {"cortex-m4f -O2 double": "not flown: the soft-float addition of libgcc rounds some sums wrongly"}
MISSING = "; ".join(sorted({machine.missing for machine in MACHINES if machine.missing and V3 not in machine.flags}))


def bits(folder: Folder, out: Path, samples: int = SAMPLES) -> dict[str, dict[str, Any]]:
    """By build: what it flew, and after how many samples it differed first from the first build of its precision."""
    found: dict[str, dict[str, Any]] = {}
    for precision in PRECISIONS:
        flights = {f"{machine.name} {precision}": flown(folder, machine, precision, samples, out)
                   for machine in MACHINES if precision in machine.precisions and not machine.missing}  # fmt: skip
        if precision == "double":
            flights["Python"] = in_python(samples)
        first = next(iter(flights.values()))
        found |= {name: compared(flight, first) for name, flight in flights.items()}
    return found


def compared(flight: Flown, first: Flown) -> dict[str, Any]:
    """A flight as it is kept."""
    return {
        "sha256": flight.digests[-1],
        "differs": differs(flight, first),
        "samples": len(flight.digests) * EVERY,
        **{name: getattr(flight, name) for name in ("taken", "rows", "refused", "control")},
        "flushed": list(flight.flushed),
    }


def differs(one: Flown, other: Flown) -> int:
    """The number of samples, in steps of 10 000, within which two flights differed first; 0 if they never did."""
    pairs = zip(one.digests, other.digests, strict=True)
    return next(((i + 1) * EVERY for i, (a, b) in enumerate(pairs) if a != b), 0)


def flown(folder: Folder, machine: Machinery, precision: str, samples: int, out: Path) -> Flown:
    """The flight by one build."""
    target = machine.target
    out = out / f"{machine.name.replace(' ', '')}-{precision}"
    out.mkdir(parents=True, exist_ok=True)
    flags = (*machine.flags, *PRECISIONS[precision], f"-DFLIGHT_SAMPLES={samples}")
    flags += () if target.emulated else ("-DFLIGHT_MAIN",)
    common = [target.compiler, *WARNINGS, *target.flags, *flags, "-I", folder.include]
    sources = [*(unit.path for unit in folder.units), HARNESS / "flight.c"]
    objects = compile_sources(common, dict.fromkeys(sources, ()), out)
    image = out / "flight.elf"
    link = [*target.link, "-Wl,-e,flight", "-Wl,--gc-sections", "-Wl,--no-warnings"] if target.emulated else []
    run([target.compiler, *target.flags, *machine.flags, *link, *objects.values(), "-lm", "-o", image])
    if target.emulated:
        return on_core(Build(folder, target, precision, objects, image), samples)
    return read([line.split() for line in run([*([machine.runs] if machine.runs else []), image]).splitlines()])


def read(lines: list[list[str]]) -> Flown:
    """What the program printed."""
    _, taken, rows, refused, _, results, inputs, control = map(int, lines[0])
    return Flown(tuple(line[0] for line in lines[1:]), taken, rows, refused, (bool(results), bool(inputs)), control)


def on_core(made: Build, samples: int) -> Flown:
    """The same on an emulated core."""
    core = Machine(made, made.image)
    core.call("flight")
    count = samples // EVERY
    digests = core.read("flight_digests", np.uint8, 32 * count).reshape(count, 32)
    _, taken, rows, refused, _ = core.read("flight_counts", np.int32, 5).tolist()
    results, inputs = core.read("flight_flush", np.int32, 2).tolist()
    (control,) = core.read("flight_control", np.uint32, 1).tolist()
    shown = tuple(row.tobytes().hex() for row in digests)
    return Flown(shown, taken, rows, refused, (bool(results), bool(inputs)), control)


# ---------------------------------------------------------------- the same flight from Python


class Luck:
    """The integers of harness/flight.c."""

    def __init__(self) -> None:
        self.state = 20261123

    def drawn(self) -> int:
        self.state = (self.state * 1664525 + 1013904223) & 0xFFFFFFFF
        return self.state >> 8

    def noise(self) -> float:
        return (self.drawn() % 131072 - 65536) * 2.0**-16


def in_python(samples: int) -> Flown:
    """The flight by `CompiledFilter`, in double."""
    from boresight.runtime.filter import CompiledFilter
    from boresight.runtime.library import load

    model = load("azimuth-hold")
    n, rate, dt, step = len(model.states), 128.0, 1 / 128, 100
    sigma = [1e-6, 1e-6, 5, 0.1, 0.1, 0.1, 0.01, 0.01, 0.02, 1e-5, 1e-5, 1e-5, 0.01, 0.01, 0.01]
    nav = {"lon_lat_height": [0.5, 0.75, 100.0], "v_n": [0.05, -0.03, 0.01], "q_b2n_wxyz": [1.0, 0.001, -0.002, 0.005],
           "gyro_bias": [0.0, 0.0, 0.0], "accel_bias": [0.0, 0.0, 0.0]}  # fmt: skip
    loop = CompiledFilter(model, {k: np.array(v) for k, v in nav.items()}, np.diag(np.array(sigma) * np.array(sigma)))
    luck, digest = Luck(), hashlib.sha256()
    noises = {"gyro_noise": [1e-4] * 3, "accel_noise": [5e-3] * 3, "gyro_bias_noise": [1e-7] * 3,
              "accel_bias_noise": [1e-5] * 3}  # fmt: skip
    strapdown = model.units["strapdown"].bind()
    before = dtheta = dv = np.zeros(3)
    still: tuple[int, Any] = (-1, None)
    azimuth: tuple[int, Any] = (-1, None)
    columns = np.tril_indices(n)
    taken = rows = refused = 0
    digests = []

    def sense(turning: float) -> tuple[np.ndarray, np.ndarray]:
        angle, velocity = np.zeros(3), np.zeros(3)
        for i, (turn, force) in enumerate(((1e-5, 0.002), (4.5e-5, -0.003), (5.5e-5, 9.805))):
            angle[i] = (turn + 2.0**-9 * luck.noise()) * dt
            velocity[i] = (force + 2.0**-4 * luck.noise()) * dt
        angle[2] += turning * dt
        return angle, velocity

    def send() -> tuple[bool, int, float]:
        """Whether the message is sent, how many samples it takes, and what its azimuth is off."""
        chance, late, off = luck.drawn(), luck.drawn() % 64, 2.0**-8 * luck.noise()
        return chance % 8 != 0, late, off

    def take(name: str, variance: list[float], **inputs: Any) -> None:
        nonlocal taken, rows
        answer = loop.update(name, variance, gate=5.0, **inputs)
        taken, rows = taken + 1, rows + int(answer.used.sum())
        loop.feedback()

    dtheta, dv = sense(0.0)
    for k in range(1, samples + 1):
        phase, quarter = k % 16384, k % 4096
        turns = phase >= 12288
        turning = 2.0**-5 if quarter < 1024 or quarter >= 3072 else -(2.0**-5)
        before, dv_before = dtheta, dv
        dtheta, dv = sense(turning if turns else 0.0)
        inputs = {"dtheta_ib_b": dtheta, "dv_b": dv, "dtheta_before": before, "dv_before": dv_before, "dt": dt}
        inputs |= loop.nav
        for name, value in strapdown.inputs.items():
            if name in inputs:
                value[:] = inputs[name]
        refused += strapdown() != 0
        loop.nav |= {name: np.asarray(value).reshape(-1).copy() for name, value in strapdown.outputs.items()}
        omega = dtheta * rate - loop.nav["gyro_bias"]
        if k % step == 0:
            force = dv * rate - loop.nav["accel_bias"]
            loop.predict(f_b=force, omega_ib_b=omega, dt=step * dt, **noises)
        if k % 128 == 0:
            sent, late, _ = send()
            still = (k + late, omega) if sent else still
        if k % 1024 == 0 and not turns:
            sent, late, off = send()
            azimuth = (k + late, np.array([1.0, 0.0, 0.0, off])) if sent else azimuth
        if still[0] == k:
            take("zupt", [0.0004] * 3)
            if not turns:
                take("zaru", [4e-6] * 3, omega_ib_b=still[1])
        if azimuth[0] == k:
            take("azimuth", [1e-4], q_ref_wxyz=azimuth[1])
        if k % step == 0:
            for name in nav:
                digest.update(np.ascontiguousarray(loop.nav[name], "<f8").tobytes())
            digest.update(np.ascontiguousarray(loop.x, "<f8").tobytes())
            digest.update(np.ascontiguousarray(loop.P[columns], "<f8").tobytes())
        if k % EVERY == 0:
            digests.append(digest.copy().hexdigest())
    return Flown(tuple(digests), taken, rows, int(refused))


def version() -> str:
    """Of the compilers, by machine."""
    found = {machine.target.compiler: machine.target.version for machine in MACHINES if not machine.missing}
    return "; ".join(found.values())
