"""The text of each filter for GPUs of two kinds: what NVRTC makes of it is read, without a card; see docs/decisions.

The run that is flown is printed from the manifest, harness/run.c.j2, and calls every function of the plain filter.
"""

import hashlib
import re
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from jinja2 import Environment, StrictUndefined

from boresight import BoresightError
from boresight.codegen.folder import Folder
from boresight.codegen.reach import pieces
from boresight.codegen.stamp import hashed
from boresight.errors import need
from boresight.evidence.targets import HARNESS, PRECISIONS
from boresight.runtime.array import Array
from boresight.runtime.gpu import machine_code, text
from boresight.runtime.units import STANDARD_GRAVITY

ARCHITECTURES = ("sm_80", "sm_90")  # A100, H100
DT_S = 0.01  # of a sample
BEFORE = "_before"  # what a field of the sample before ends with


@dataclass(frozen=True)
class Run:
    """A run of a filter: its C, the numbers that it is given, and how many columns it returns."""

    source: str
    given: Array
    columns: int


def run_of(folder: Folder, measurements: Collection[str] | None = None, cycles: int = 60, samples: int = 100) -> Run:
    """So many propagations, each after so many samples of the strapdown and before these measurements, or all."""
    manifest, described = folder.manifest, folder.manifest["filter"]
    states, structs = len(manifest["states"]), manifest["structs"]
    sizes = {name: sum(field["size"] for field in fields) for name, fields in structs.items()}
    ceiling = np.array([high for field in structs["x"] for high in field["high"]])
    given: list[Any] = [cycles, samples, *(0.01 * ceiling)]

    def call(of: dict[str, Any], what: str, dt: float, **more: Any) -> dict[str, Any]:
        """A call's structs: `drawn` anew for each call, or `fixed` where no field that it reads is spread."""
        uses: dict[str, list[dict[str, Any]]] = {"drawn": [], "fixed": []}
        for struct in of["structs"]:
            fields = [field for field in structs[struct] if not field["name"].endswith(BEFORE)]
            pairs = [about(field, dt, manifest["frame"]) for field in fields]
            read = [spread.any() for field, (_, spread) in zip(fields, pairs, strict=True)
                    if field["name"] in of.get("fields", [field["name"]])]  # fmt: skip
            size = sum(field["size"] for field in fields)
            use = {"struct": struct, "variable": f"{what}_{struct}", "at": len(given), "size": size}
            uses["drawn" if any(read) else "fixed"].append(use)
            for part in zip(*pairs, strict=True):
                given.extend(np.concatenate(part))
        return {**uses, "variables": [f"{what}_{struct}" for struct in of["structs"]], **more}

    every = described["measurements"]
    chosen = {name: every[name] for name in (every if measurements is None else measurements)}
    strapdown = described["strapdown"]
    views: dict[str, Any] = {
        "begin": call({"structs": described["carried"]}, "begin", DT_S),
        "strapdown": strapdown and call(strapdown, "strapdown", DT_S, before=befores(strapdown, structs)),
        "propagate": call(described["propagate"], "propagate", DT_S * samples),
        "measurements": [call(of, name, DT_S, name=name) for name, of in chosen.items()],
    }
    calls = [views["begin"], views["propagate"], *views["measurements"], *([views["strapdown"]] if strapdown else [])]
    environment = Environment(trim_blocks=True, lstrip_blocks=True, undefined=StrictUndefined, autoescape=False)
    source = environment.from_string((HARNESS / "run.c.j2").read_text()).render(
        model=manifest["model"], name=folder.name, p=manifest["c_prefix"], states=states, most=max(sizes.values()),
        calls=calls, carried=described["carried"],
        correct=bool(described["correct"]), **views,
    )  # fmt: skip
    columns = sum(sizes[name] for name in described["carried"]) + states + states * (states + 1) // 2 + 1
    return Run(source, np.array(given, float), columns)


def befores(strapdown: dict[str, Any], structs: dict[str, Any]) -> list[dict[str, Any]]:
    """Fields of the sample before, which are those of the last call; of the first call its own."""
    found = []
    for struct in strapdown["structs"]:
        sizes = {field["name"]: field["size"] for field in structs[struct]}
        for name in sizes:
            if name.endswith(BEFORE):
                (of,) = (n for n in sizes if n.startswith(name.removesuffix(BEFORE) + "_") and n != name)
                found.append({"variable": f"strapdown_{struct}", "name": name, "of": of, "size": sizes[name]})
    return found


def about(field: dict[str, Any], dt: float, frame: str) -> tuple[Array, Array]:
    """What a field is about, and how far it is spread: at rest, inside its box."""
    low, high, name = np.array(field["low"]), np.array(field["high"]), field["name"]
    spread = 1e-4 * (high - low)
    value = np.clip(np.zeros(len(low)), low + 10 * spread, high - 10 * spread)
    if field["norm"]:
        value[0], spread[0] = 1.0, 0.0
    if name == "dt":
        value, spread = np.array([dt]), np.zeros(1)
    if "noise" in name:
        value, spread = 1e-4 * high, 0 * high
    if name.startswith(("dv", "f_b")):
        up = 1.0 if "ENU" in frame else -1.0
        value[2] = up * STANDARD_GRAVITY * (dt if name.startswith("dv") else 1.0)
    return value, spread


# ---- evidence


def missing() -> str:
    try:
        need("gpu")
    except BoresightError as error:
        return str(error)
    return ""


MISSING = missing()


def version() -> str:
    from cuda.bindings import nvrtc

    _, major, minor = nvrtc.nvrtcVersion()
    return f"NVRTC {major}.{minor}"


def texts(folder: Folder, out: Path) -> dict[str, str]:
    """By precision."""
    file = out / "run.c"
    file.write_text(run_of(folder).source)
    return {precision: text.device(folder.path, file, precision) for precision in PRECISIONS}


def hashes(folder: Folder) -> dict[str, str]:
    """Of all that the text is made of, but for comments, and of what reads it."""
    left_out = re.compile(r"_(live|digest|identity)\.[ch]$")
    model = sorted(path for pattern in ("src/*.[ch]", "include/*.h") for path in folder.files(pattern))
    parts = [one.text for path in model if not left_out.search(path.name) for one in pieces(path)]
    judges = {*text.OWN, *text.HERE.glob("*.h"), *(text.HERE / f"{name}.py" for name in ("text", "machine_code"))}
    parts += [run_of(folder).source, hashed({*judges, Path(__file__).resolve()})]
    return {folder.name: hashlib.sha256("\n".join(parts).encode()).hexdigest()}


def gpu(folder: Folder, out: Path) -> dict[str, dict[str, Any]]:
    """By precision and kind of GPU: floating operations by name, what may have other bits, bytes of machine code."""
    found = {}
    for precision, source in texts(folder, out).items():
        for architecture in ARCHITECTURES:
            ptx, code = machine_code.compiled(source, architecture)
            counts, faults = machine_code.read(ptx)
            floating = {name: n for name, n in sorted(counts.items()) if name.split(".")[0] in machine_code.ROUNDED and
                        not machine_code.FLOATING.isdisjoint(name.split("."))}  # fmt: skip
            found[f"{precision} {architecture}"] = {"operations": floating, "faults": faults, "bytes": len(code)}
    return found
