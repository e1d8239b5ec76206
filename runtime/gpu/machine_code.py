"""Machine code of a text for a kind of GPU, by NVRTC, which needs no GPU; kept in the cache of libraries.

Each operation rounds once, as on the host: nothing is fused, nothing small becomes zero, division and square root are
exact.  The options say so, and what comes out is read: PTX, the text of which NVRTC makes the machine code, has a
rounding on each sum and product, which the last step may then not fuse.
"""

import hashlib
import os
import re
import tempfile
from collections import Counter
from typing import Any

from boresight import BoresightError
from boresight.errors import need
from boresight.runtime.manifest import cache_folder

OPTIONS = ("-std=c++17", "-default-device", "-fmad=false", "-prec-div=true", "-prec-sqrt=true", "-ftz=false", "-w")
ROUNDED = {"add", "sub", "mul", "div", "sqrt", "rcp"}
FLOATING = {"f16", "f16x2", "bf16", "bf16x2", "f32", "f32x2", "f64"}
LOOSE = {"ftz", "approx", "full"}
INSTRUCTION = re.compile(r"^\s*(?:@!?%\w+\s+)?([a-z]\w*(?:\.[\w:]+)*)(?=[\s;])(?!:)", re.MULTILINE)
CALL = re.compile(r"\bcall(?:\.uni)?\s+(?:\([^)]*\)\s*,\s*)?([\w$%]+)")
FUNCTION = re.compile(r"\.func\s+(?:\([^)]*\)\s*)?([\w$]+)\s*\([^)]*\)\s*(?:\.\w+\s*)*\{")  # with its body


def read(ptx: str) -> tuple[Counter[str], list[str]]:
    """How often each instruction stands in PTX, and what of it may have other bits than the host."""
    counts = Counter(name for name in INSTRUCTION.findall(ptx) if not name.startswith("param"))
    faults = [name for name in sorted(counts) if _loose(*name.split("."))]
    own = set(FUNCTION.findall(ptx))
    faults += [f"call of {name}" for name in sorted({*CALL.findall(ptx)} - own)]
    return counts, faults


def _loose(kind: str, *parts: str) -> bool:
    """Whole numbers may be multiplied and added in one: that is exact."""
    if FLOATING.isdisjoint(parts):
        return False
    return kind in ("fma", "mad") or not LOOSE.isdisjoint(parts) or (kind in ROUNDED and "rn" not in parts)


def compiled(text: str, architecture: str, options: tuple[str, ...] = OPTIONS) -> tuple[str, bytes]:
    """PTX and machine code.  architecture: as "sm_90".

    Raises BoresightError where NVRTC knows no such GPU, or refuses the text.
    """
    need("gpu")
    from cuda.bindings import nvrtc

    known = sorted(_asked(nvrtc, nvrtc.nvrtcGetSupportedArchs()))
    if architecture not in [f"sm_{number}" for number in known]:
        raise BoresightError(
            f"a GPU of {architecture} is none of those that this NVRTC makes code for, sm_{known[0]} to sm_{known[-1]}"
        )
    program = _asked(nvrtc, nvrtc.nvrtcCreateProgram(text.encode(), b"flights.cu", 0, [], []))
    words = [option.encode() for option in (*options, f"-arch={architecture}")]
    (code,) = nvrtc.nvrtcCompileProgram(program, len(words), words)
    if code:
        log = b" " * _asked(nvrtc, nvrtc.nvrtcGetProgramLogSize(program))
        nvrtc.nvrtcGetProgramLog(program, log)
        report = log.decode(errors="replace").strip("\0 \n")
        first = next((line for line in report.splitlines() if "error" in line), report[:200])
        raise BoresightError(f"NVRTC refuses the text: {first}")
    ptx = b" " * _asked(nvrtc, nvrtc.nvrtcGetPTXSize(program))
    _asked(nvrtc, nvrtc.nvrtcGetPTX(program, ptx))
    machine_code = b" " * _asked(nvrtc, nvrtc.nvrtcGetCUBINSize(program))
    _asked(nvrtc, nvrtc.nvrtcGetCUBIN(program, machine_code))
    nvrtc.nvrtcDestroyProgram(program)
    return ptx.rstrip(b"\0").decode(), machine_code


def machine_code(text: str, architecture: str) -> bytes:
    """Out of the cache, or compiled, read and kept there.  Raises BoresightError as `compiled`, and where it is not
    exact."""
    need("gpu")
    from cuda.bindings import nvrtc

    key = hashlib.sha256()
    for part in (text, architecture, *OPTIONS, repr(nvrtc.nvrtcVersion()[1:])):
        key.update(part.encode() + b"\0")
    target = cache_folder() / f"flights-{architecture}-{key.hexdigest()[:32]}.cubin"
    if target.exists():
        return target.read_bytes()
    ptx, made = compiled(text, architecture)
    faults = read(ptx)[1]
    if faults:
        raise BoresightError(f"what NVRTC made for {architecture} may have other bits than the host: {faults[0]}")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=target.parent, delete=False) as aside:
            aside.write(made)
        os.replace(aside.name, target)
    except OSError as error:
        raise BoresightError(
            f"cannot write to {target.parent} ({error.strerror}); set BORESIGHT_CACHE to a folder that you can write to"
        ) from None
    return made


def _asked(nvrtc: Any, answer: tuple[Any, ...]) -> Any:
    """What a function of NVRTC gives behind its code."""
    code, *values = answer
    if code:
        raise BoresightError(f"NVRTC: {nvrtc.nvrtcGetErrorString(code)[1].decode()}")
    return values[0] if values else None
