"""One output of an instruction list as a script for Gappa: every value twice, as C in float computes it and exactly.

Inputs are floats of their box, literals are rounded, each operation but negation and doubling rounds to nearest.  What
Gappa cannot know is assumed, and each assumption is a hypothesis of the theorem that it proves:

- A sine or cosine errs by 1 ulp: by 2^-23 of its value and by 2^-24 in all.  Of an argument that itself was rounded it
  moves by no more than the argument does, for which Gappa proves a bound first.
- A form of one quaternion or of two lies in the range that `forms` gives.

Overflow is no part of it: Gappa's floats have no largest number.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import ceil, cos, floor, pi, sin

import numpy as np

from boresight.codegen.functions.tape import Step, Tape
from boresight.derive.model import Variable
from boresight.evidence.proofs.forms import Range, ranges

ROUND = "@f = float<ieee_32, ne>;"
ROUNDED = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
KNOWN = {*ROUNDED, "sq", "inv", "sqrt", "neg", "twice", "fabs", "sin", "cos", "const", "input"}


@dataclass
class Script:
    """lines: definitions; given: hypotheses; pairs: names of (computed, exact) of each step, equal where nothing was
    rounded; rewritten: hints."""

    lines: list[str] = field(default_factory=lambda: [ROUND])
    given: list[str] = field(default_factory=list)
    pairs: dict[int, tuple[str, str]] = field(default_factory=dict)
    rewritten: list[str] = field(default_factory=list)

    def question(self, asked: str) -> str:
        """The whole script, with a goal."""
        given = " /\\\n  ".join(self.given)
        return "\n".join([*self.lines, "{", f"  {given} ->" if given else "", f"  {asked} }}", *self.rewritten, ""])


def cone(tape: Tape, position: int) -> list[int]:
    """The steps that a value depends on, itself the last, in the order of the list."""
    needed = {position}
    for k in range(position, -1, -1):
        if k in needed:
            needed |= set(tape.steps[k].args)
    return sorted(needed)


def unknown(tape: Tape, position: int) -> str:
    """Operations of the cone that no script is written for, or nothing."""
    return ", ".join(sorted({tape.steps[k].op for k in cone(tape, position)} - KNOWN))


def script(tape: Tape, position: int, args: tuple[Variable, ...], moved: Mapping[int, tuple[Range, float]]) -> Script:
    """moved: of each step whose sine or cosine is taken and that was itself computed, its range and error."""
    made = Script()
    within = ranges(tape, args)
    for k in cone(tape, position):
        step = tape.steps[k]
        if step.op == "input":
            variable, i = args[step.source[0]], step.source[1]
            made.lines.append(f"x{k} = f(X{k});")
            made.given.append(f"X{k} in {box(variable.low[i], variable.high[i])}")
            made.pairs[k] = (f"x{k}", f"x{k}")
        elif step.op == "const":
            literal(made, k, step.constant)
        elif step.op in ("sin", "cos"):
            turned(made, k, step, reach(tape, step.args[0], args, moved), moved.get(step.args[0], ((0, 0), 0.0))[1])
        else:
            operation(made, k, step)
        if k in within:
            made.given.append(f"{made.pairs[k][1]} in {box(*within[k])}")
    return made


def literal(made: Script, k: int, constant: float) -> None:
    """A literal is printed in decimal and read as a float."""
    single = float(np.float32(constant))
    made.pairs[k] = (f"({single.hex()})", f"({decimal(constant)})")
    if single == constant:
        made.pairs[k] = (made.pairs[k][0],) * 2
        return
    made.lines += [f"r{k} = {single.hex()};", f"e{k} = {decimal(constant)};"]
    made.pairs[k] = (f"r{k}", f"e{k}")


def operation(made: Script, k: int, step: Step) -> None:
    def line(which: int) -> str:
        names = [made.pairs[a][which] for a in step.args]
        if step.op in ROUNDED:
            return f"{names[0]} {ROUNDED[step.op]} {names[1]}"
        return {
            "sq": f"{names[0]} * {names[0]}",
            "inv": f"1 / {names[0]}",
            "sqrt": f"sqrt({names[0]})",
            "neg": f"-{names[0]}",
            "twice": f"2 * {names[0]}",
            "fabs": f"|{names[0]}|",
        }[step.op]

    computed, exact = line(0), line(1)
    made.lines.append(f"e{k} = {exact};")
    if step.op in ("neg", "twice", "fabs") and computed == exact:  # rounds nothing
        made.pairs[k] = (f"e{k}", f"e{k}")
        return
    if step.op in ("neg", "twice", "fabs"):
        made.lines.append(f"r{k} = {computed};")
    else:
        made.lines.append(f"r{k} = f({computed});")
        if step.op == "div" and computed != exact:
            quotient(made, step)
    made.pairs[k] = (f"r{k}", f"e{k}")


def quotient(made: Script, step: Step) -> None:
    """Of a quotient whose dividend may vanish no relative error is known: its error in terms of absolute ones."""
    (a, c), (b, d) = (made.pairs[k] for k in step.args)
    first = f"({a} - {c}) / {b}" if a != c else ""
    second = f"({c} / {b}) * (({b} - {d}) / {d})" if b != d else ""
    line = f"{first} - {second}" if first and second else first or f"-({second})"
    needs = f"{b} <> 0, {d} <> 0" if b != d else f"{b} <> 0"
    made.rewritten.append(f"{a} / {b} - {c} / {d} -> {line} {{ {needs} }};")


def turned(made: Script, k: int, step: Step, argument: Range, error: float) -> None:
    low, high = extremes(step.op, *argument)
    made.lines.append(f"r{k} = f(S{k});")
    off = (2.0**-24 + error) * (1 + 1e-9)
    made.given += [f"e{k} in {box(low, high)}", f"r{k} - e{k} in {box(-off, off)}"]
    made.given.append(f"r{k} in {box(*extremes(step.op, argument[0] - error, argument[1] + error, 2.0**-24))}")
    if error == 0:
        made.given.append(f"r{k} -/ e{k} in {box(-(2.0**-23), 2.0**-23)}")
    made.pairs[k] = (f"r{k}", f"e{k}")


def reach(tape: Tape, k: int, args: tuple[Variable, ...], moved: Mapping[int, tuple[Range, float]]) -> Range:
    """What the exact argument of a sine lies in."""
    step = tape.steps[k]
    if step.op == "input":
        variable, i = args[step.source[0]], step.source[1]
        return float(np.float32(variable.low[i])), float(np.float32(variable.high[i]))
    return moved[k][0]


def extremes(op: str, low: float, high: float, slack: float = 0.0) -> Range:
    """The range of a sine or cosine over an interval, a little wider, within [-1, 1]."""
    shift = 0.0 if op == "sin" else pi / 2  # cos a = sin(a + pi/2)
    ends = [sin(low), sin(high)] if op == "sin" else [cos(low), cos(high)]
    a, b = low + shift, high + shift
    most = 1.0 if floor((b - pi / 2) / (2 * pi)) >= ceil((a - pi / 2) / (2 * pi)) else max(ends)
    least = -1.0 if floor((b + pi / 2) / (2 * pi)) >= ceil((a + pi / 2) / (2 * pi)) else min(ends)
    wider = slack + 1e-12
    return max(-1.0, least - wider), min(1.0, most + wider)


def box(low: float, high: float) -> str:
    return f"[{float(low).hex()}, {float(high).hex()}]"


def decimal(value: float) -> str:
    return repr(float(value))
