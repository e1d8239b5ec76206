"""Gappa on one output: a bound on its rounding error over the whole box, or why there is none."""

import re
import resource
import shutil
import subprocess
from fractions import Fraction
from math import inf, isfinite, nextafter

from boresight.codegen.functions.tape import Tape
from boresight.derive.model import Variable
from boresight.evidence.proofs.script import Range, Script, cone, script, unknown

MISSING = "" if shutil.which("gappa") else "gappa is not installed"
SECONDS, MEMORY = 15, 3 * 2**30
QUIET = ("-Wno-null-denominator", "-Wno-hint-difference")  # what is said of a hint, which Coq proves or refuses
NUMBER = r"(-?\d+(?:b-?\d+)?)"
ENCLOSED = re.compile(rf"in \[{NUMBER}(?: \{{[^}}]*\}})?, {NUMBER}(?: \{{[^}}]*\}})?\]")


class Unproved(Exception):
    """Why an output has no bound."""


def version() -> str:
    if MISSING:
        return MISSING
    return subprocess.run(["gappa", "--version"], capture_output=True, text=True).stdout.strip()


def bound(tape: Tape, position: int, args: tuple[Variable, ...], seconds: float = SECONDS) -> float:
    """What the value at `position`, computed in float, differs at most by from the exact one over the whole box.

    Rounded up to three digits.  Raises Unproved with the reason.
    """
    made = written(tape, position, args, seconds)
    computed, exact = made.pairs[position]
    if computed == exact:
        return 0.0
    ((low, high),) = ask(made, [f"{computed} - {exact}"], seconds)
    return upward(max(-low, high))


def holds(tape: Tape, position: int, args: tuple[Variable, ...], claimed: float, seconds: float = SECONDS) -> bool:
    """Whether Gappa proves the claimed bound."""
    made = written(tape, position, args, seconds)
    computed, exact = made.pairs[position]
    if computed == exact:
        return claimed >= 0
    asked = f"{computed} - {exact} in [{(-claimed).hex()}, {claimed.hex()}]"
    done = gappa(made.question(asked), seconds)
    return done.returncode == 0 and "Error" not in done.stderr


def written(tape: Tape, position: int, args: tuple[Variable, ...], seconds: float) -> Script:
    """The script of one output, with what its sines of computed values need."""
    ops = unknown(tape, position)
    if "atan2" in ops:
        raise Unproved("an arctangent: it jumps by a turn, and has no value where both operands vanish")
    if ops:
        raise Unproved(f"a choice that rounding may decide otherwise ({ops})")
    moved: dict[int, tuple[Range, float]] = {}
    for k in cone(tape, position):
        step = tape.steps[k]
        if step.op not in ("sin", "cos") or tape.steps[step.args[0]].op == "input" or step.args[0] in moved:
            continue
        made = script(tape, step.args[0], args, moved)
        computed, exact = made.pairs[step.args[0]]
        asked = [exact] if computed == exact else [exact, f"{computed} - {exact}"]
        within, *off = ask(made, asked, seconds)
        moved[step.args[0]] = within, upward(max(map(abs, off[0]))) if off else 0.0
    return script(tape, position, args, moved)


def ask(made: Script, expressions: list[str], seconds: float) -> list[Range]:
    """What Gappa encloses each expression in."""
    asked = " /\\ ".join(f"{expression} in ?" for expression in expressions)
    printed = gappa(made.question(asked), seconds).stderr
    found = [(number(low), number(high)) for low, high in ENCLOSED.findall(printed)]
    if len(found) != len(expressions) or not all(isfinite(v) for pair in found for v in pair):
        raise Unproved("Gappa finds none: as far as it can tell a divisor or the operand of a root may vanish")
    return found


def gappa(text: str, seconds: float) -> subprocess.CompletedProcess[str]:
    def limited() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    try:
        return subprocess.run(
            ["gappa", *QUIET], input=text, capture_output=True, text=True, timeout=seconds, preexec_fn=limited
        )
    except subprocess.TimeoutExpired:
        raise Unproved(f"Gappa takes more than {seconds:g} s") from None


def number(text: str) -> float:
    """A dyadic number of Gappa's, rounded away from zero."""
    mantissa, _, exponent = text.partition("b")
    exact = Fraction(int(mantissa)) * Fraction(2) ** int(exponent or 0)
    value = float(exact)
    return value if Fraction(value) == exact else nextafter(value, inf if exact > 0 else -inf)


def upward(value: float) -> float:
    """Rounded up to three digits."""
    short = float(f"{value:.3g}")
    return short if short >= value else float(f"{value * 1.005:.3g}")
