"""How numbers, files, temporaries and boxes are written in C."""

import math
import re
from collections.abc import Callable
from itertools import count
from typing import Any

from boresight import BoresightError
from boresight.codegen.functions.dynamics import LARGEST
from boresight.codegen.functions.samples import BEYOND
from boresight.codegen.functions.tape import LIBRARY, Tape
from boresight.codegen.functions.unit import Result, Unit
from boresight.derive.checks import KEYWORDS
from boresight.derive.model import Model, Variable


def snake(name: str) -> str:
    return name.replace("-", "_")


def file_stem(model: Model, unit: str) -> str:
    """H and h, F and f are two functions; their files must not be one where a file system ignores case."""
    return f"{model.c_prefix}_{unit}x" if unit == "f" or unit.endswith("_h") else f"{model.c_prefix}_{unit}"


def number(value: float) -> str:
    """A literal that reads back as the same double."""
    if not math.isfinite(value):
        raise BoresightError(f"the constant {value} cannot be printed; a printed unit holds finite numbers only")
    return f"BS_REAL({float(value)!r})"


def temporaries(unit: Unit, tape: Tape) -> list[str]:
    """What each value of the tape is called: inputs and constants as they are, quantities by their names, sines by
    their angle, others counted from t1 on.  A name that is taken gets a number behind it."""
    taken = {*KEYWORDS.split(), *LIBRARY, *["sqrt", "fabs", "atan2", "shared"]}
    taken |= {*(a.name for a in unit.args), *map(nz_name, unit.results)}
    reserved = re.compile(rf"(bs|{unit.function.name().partition('_')[0]})_.*|t\d+", re.IGNORECASE)

    def free(name: str) -> str:
        name = f"named_{name}" if reserved.fullmatch(name) else name
        names = (name if i == 1 else f"{name}_{i}" for i in count(1))
        found = next(one for one in names if one not in taken)
        taken.add(found)
        return found

    called = {position: free(name) for position, name in unit.called.items()}
    counted = count(1)
    names: list[str] = []
    for position, step in enumerate(tape.steps):
        if step.op == "const":
            name = number(step.constant)
        elif step.op == "input":
            name = f"{unit.args[step.source[0]].name}[{step.source[1]}]"
        elif position in called:
            name = called[position]
        else:
            angle = angle_of(unit, tape, position)
            name = free(angle) if angle else f"t{next(counted)}"
        names.append(name)
    return names


def angle_of(unit: Unit, tape: Tape, position: int) -> str:
    """sin_lat of the sine of an input, and so for its cosine and its tangent; nothing for others."""
    step = tape.steps[position]
    of = [tape.steps[i] for i in step.args]
    if step.op == "div" and [one.op for one in of] == ["sin", "cos"] and of[0].args == of[1].args:
        return angle_of(unit, tape, step.args[0]).replace("sin_", "tan_", 1)
    if step.op not in ("sin", "cos") or of[0].op != "input":
        return ""
    index, component = of[0].source
    return f"{step.op}_{unit.args[index].symbols[component].name}"


def nz_name(result: Result) -> str:
    return f"{result.name}_nz"


def span(low: tuple[float, ...], high: tuple[float, ...]) -> str:
    def one(a: float, b: float) -> str:
        return "finite" if (a, b) == (-LARGEST, LARGEST) else f"{a:.6g} to {b:.6g}"

    if len(set(low)) == 1 and len(set(high)) == 1:
        return one(low[0], high[0])
    return ", ".join(one(a, b) for a, b in zip(low, high, strict=True))


def beyond(a: Variable) -> tuple[str, str]:
    """Numbers of the self-test just below and just above the box."""
    bounds = list(zip(a.low, a.high, strict=True))
    return (
        ", ".join(repr(lo - BEYOND * (abs(lo) or hi - lo)) for lo, hi in bounds),
        ", ".join(repr(hi + BEYOND * (abs(hi) or hi - lo)) for lo, hi in bounds),
    )


def rows_of(rows: Any, printed: Callable[[float], str] = float.hex) -> str:
    """The rows of a table of numbers in C."""
    return ",\n".join("    { " + ", ".join(printed(float(v)) for v in row) + " }" for row in rows)


def three_digits(value: float) -> str:
    """A float in C: where it is a normal one not smaller, and larger by 1.5 % at most."""
    return f"{value * 1.01:.2e}F" if value > 1e-45 else "0.0F"


def norms_beyond(a: Variable) -> str:
    """What all components are so that the norm lies just below its range, and just above."""
    ends = zip(a.norm or (), (-1, 1), strict=False)
    return ", ".join(repr(norm * (1 + sign * BEYOND / 2) / math.sqrt(a.size)) for norm, sign in ends)


def norms_near(a: Variable) -> str:
    """Squares of a norm just below its range, just in it at either end, and just above."""
    if not a.norm:
        return ""
    low, high = (end * end for end in a.norm)
    off = min(BEYOND / 2 * high, (high - low) / 4)
    return ", ".join(map(repr, (low - off if low > off else high + off, low + off, high - off, high + off)))


def with_nulls(name: str, arguments: list[str]) -> list[str]:
    """Calls with one pointer null, each in turn."""
    places = range(len(arguments))
    return [f"{name}({', '.join('0' if j == i else arguments[j] for j in places)})" for i in places]


def null_test(pointers: list[str]) -> str:
    return " || ".join(f"({p} == NULL)" for p in pointers) if len(pointers) > 1 else f"{pointers[0]} == NULL"


def ranges(variable: Variable) -> str:
    norm = f", norm {variable.norm[0]:.6g} to {variable.norm[1]:.6g}" if variable.norm else ""
    return span(variable.low, variable.high) + norm


def shared_tables(tables: dict[str, tuple[float, ...]]) -> tuple[list[str], dict[str, str]]:
    """Each table of numbers in C, equal ones once; and under what name each is found."""
    names: dict[tuple[float, ...], list[str]] = {}
    for name, values in tables.items():
        names.setdefault(values, []).append(name)
    lines = []
    for values, (first, *others) in names.items():
        also = f" /* {', '.join(others)} too */" if others else ""
        lines.append(f"static const bs_real {first}[{len(values)}] = {{ {', '.join(map(number, values))} }};{also}")
    return lines, {name: same[0] for same in names.values() for name in same}
