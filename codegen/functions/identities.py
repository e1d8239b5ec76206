"""Values of an instruction list that algebra makes zero, one or one another: each is kept once, and those that have a
name get it.

Jacobians, products of rotations and symmetric matrices hold them: sin^2 + cos^2, a product less itself, the mirrored
half of a covariance.  Printed, they would be operations for nothing and sums of pure rounding.

The list is evaluated once, exactly, at a point drawn at random from the numbers modulo a prime of 256 bits.  Values
that agree there are the same expression in the inputs, in sines and cosines (with sin^2 + cos^2 = 1), in roots (with
their squares) and in choices and all other functions, each of which counts as a free number: two that differ would
agree by chance once in 10^70.  So they agree wherever both are defined, also where the norm of a quaternion is not one.
A value that is defined at fewer points, or whose rounding errors are larger, takes the place of none.
"""

import hashlib
from collections import Counter
from dataclasses import replace
from functools import reduce
from operator import or_
from typing import Any

import casadi as ca
import numpy as np

from boresight.codegen.functions.tape import BUILD, FREE, Tape, computed, rounding, tape

PRIME = 0xCD6F72B4267D1138C06C2406056E4046E66D3A72764B5AF4B5B8B9AA26EB43BD  # no power of two is near a small number
TERMS = 256  # beyond so many products of roots in one multiplication its result counts as a free number

# A number: for each set of roots, as bits, the factor of their product; none for zero.  Two are one number only if they
# are so for either sign of every root, so that sqrt(x^2) is neither x nor -x.
Number = tuple[tuple[int, int], ...]
ONE: Number = ((0, 1),)


def numbers(program: Tape) -> list[Number]:
    """The value of each step at the random point."""
    radicands: list[Number] = []

    def number(factors: dict[int, int]) -> Number:
        return tuple(sorted((roots, factor % PRIME) for roots, factor in factors.items() if factor % PRIME))

    def free(*words: Any) -> Number:
        return number({0: int.from_bytes(hashlib.sha256(repr(words).encode()).digest(), "big")})

    def plus(a: Number, b: Number, sign: int = 1) -> Number:
        total = dict(a)
        for roots, factor in b:
            total[roots] = total.get(roots, 0) + sign * factor
        return number(total)

    def times(a: Number, b: Number) -> Number:
        if len(a) * len(b) > TERMS:
            return free("mul", *sorted((a, b)))
        total: dict[int, int] = {}
        for left, u in a:
            for right, v in b:
                part: Number = ((left ^ right, u * v),)
                for k, radicand in enumerate(radicands):
                    part = times(part, radicand) if left & right & 1 << k else part
                for roots, factor in part:
                    total[roots] = total.get(roots, 0) + factor
        return number(total)

    def inverse(a: Number) -> Number:
        highest = max((roots for roots, _ in a), default=0)
        if not highest:
            return number({0: pow(a[0][1], -1, PRIME)}) if a else free("inv", a)
        root = 1 << highest.bit_length() - 1
        conjugate = number({roots: -factor if roots & root else factor for roots, factor in a})
        rational = times(a, conjugate)
        if not rational or max(rational)[0] >= root:
            return free("inv", a)
        return times(conjugate, inverse(rational))

    def value(op: str, a: Number, b: Number) -> Number:
        if op in ("add", "sub"):
            return plus(a, b, 1 if op == "add" else -1)
        if op in ("mul", "sq"):
            return times(a, b)
        if op in ("div", "inv"):
            return times(a, inverse(b)) if op == "div" else inverse(a)
        if op in ("neg", "twice"):
            return plus((), a, -1) if op == "neg" else plus(a, a)
        if op == "sqrt":
            if a not in radicands:
                radicands.append(a)
            return ((1 << radicands.index(a), 1),)
        size = min(a, plus((), a, -1))  # of a and -a, which share a cosine
        if op in ("sin", "cos"):
            t = free("half angle", size)
            square = times(t, t)
            over = plus(ONE, square, -1) if op == "cos" else plus((), plus(t, t), 1 if size == a else -1)
            return times(over, inverse(plus(ONE, square)))
        if op == "if_else_zero" and b in (ONE, plus((), ONE, -1)):
            return times(a, b)  # of a truth value, which is 0 or 1
        return free(op, size) if op == "fabs" else free(op, a, b)

    values: list[Number] = []
    for step in program.steps:
        if step.op == "const":
            over, under = step.constant.as_integer_ratio()
            values.append(number({0: over * pow(under, -1, PRIME)}))
        elif step.op == "input":
            values.append(free("input", step.source))
        else:
            a, b = (values[i] for i in (step.args + step.args)[:2])
            values.append(value(step.op, a, b))
    return values


def alike(program: Tape, other: Tape) -> dict[int, tuple[int, bool]]:
    """Operations of the list that are a result of the other, or minus one: its number there, and whether minus.

    A result that several operations agree with is the first of them.
    """
    count = len(program.steps)
    moved = (replace(step, args=tuple(count + i for i in step.args)) for step in other.steps)
    listed = numbers(Tape((*program.steps, *moved), ()))
    wanted: dict[Number, tuple[int, bool]] = {}
    for minus in (False, True):
        for _, k, position in sorted(other.results):
            number = listed[count + position]
            turned = tuple((roots, PRIME - factor) for roots, factor in number)
            wanted.setdefault(turned if minus else number, (k, minus))
    found: dict[int, tuple[int, bool]] = {}
    for position, step in enumerate(program.steps):
        if step.op not in FREE and listed[position] in wanted:
            found[position] = wanted.pop(listed[position])
    return found


def domains(program: Tape, listed: list[Number]) -> list[int]:
    """Of each step what it divides by and takes roots, logarithms and arcs of, itself or by its operands, as bits."""
    partial: dict[Any, int] = {}
    needs: list[int] = []

    def factors(i: int) -> int:
        """A product is zero where one of its factors is."""
        step = program.steps[i]
        if step.op in ("mul", "sq", "neg", "twice"):
            return reduce(or_, map(factors, step.args))
        return 0 if step.op == "const" else 1 << partial.setdefault(listed[i], len(partial))

    for step in program.steps:
        own = factors(step.args[-1]) if step.op in ("div", "inv", "sqrt") else 0
        if step.op in ("log", "asin", "acos"):  # not defined on all of one side, or beyond one
            own = 1 << partial.setdefault((step.op[-1], listed[step.args[0]]), len(partial))
        needs.append(reduce(or_, (needs[i] for i in step.args), own))
    return needs


def identified(inputs: list[Any], outputs: list[Any], points: list[np.ndarray]) -> list[Any]:
    """The SX outputs with every value built once: as a constant or an input where it is one, otherwise as an earlier
    one that agrees with it, or as minus that.  Without the entries that are zero.

    points: (points, size) of each input.  An earlier value is taken only if it divides by nothing and takes the root,
    the logarithm or the arc of nothing that the later one does not, so that it is defined wherever that is, and if its
    rounding errors are bounded at these points by less than twice what bounds the other's.
    """
    source = tape(ca.Function("f", inputs, outputs, {"cse": True}))
    listed, at = numbers(source), computed(source, points)
    errors: list[np.ndarray] = []  # of what is built
    known: dict[Number, Any] = {(): ca.SX(0), ONE: ca.SX(1)}
    built: list[Any] = []
    needs = domains(source, listed)
    earlier: dict[Number, list[int]] = {}
    uses = Counter([i for step in source.steps for i in step.args] + [position for _, _, position in source.results])
    for step, number in zip(source.steps, listed, strict=True):
        if step.op in FREE:
            which, component = step.source
            known.setdefault(number, ca.SX(step.constant) if step.op == "const" else inputs[which].nz[component])
    for k, (step, number) in enumerate(zip(source.steps, listed, strict=True)):
        opposite = tuple((roots, PRIME - factor) for roots, factor in number)

        own = rounding(step, at[k], [(at[i], errors[i]) for i in step.args], np.float64)

        def fits(i: int, need: int = needs[k], own: np.ndarray = own) -> bool:
            return not needs[i] & ~need and not (errors[i] > 2 * own)[np.isfinite(own)].any()

        same = next((i for i in earlier.get(number, ()) if fits(i)), None)
        minus = next((i for i in earlier.get(opposite, ()) if fits(i)), None)
        errors.append(own)
        if number in known:
            built.append(known[number])
            errors[k] = 0 * own if step.op not in FREE else own
        elif opposite in known:
            built.append(-known[opposite])
            errors[k] = 0 * own
        elif step.op == "neg" and source.steps[step.args[0]].op == "sub" and uses[step.args[0]] == 1:
            a, b = source.steps[step.args[0]].args
            built.append(built[b] - built[a])  # to the bit, and one operation less
            earlier.setdefault(number, []).append(k)
        elif same is not None or minus is not None:
            chosen = same if same is not None else minus
            assert chosen is not None
            errors[k] = errors[chosen]
            built.append(built[chosen] if same is not None else -built[chosen])
        else:
            built.append(BUILD[step.op](*(built[i] for i in step.args)))
            earlier.setdefault(number, []).append(k)
    made = [ca.SX(output.sparsity(), output.nz[:]) for output in outputs]
    for output, k, position in source.results:
        made[output].nz[k] = built[position]
    return [ca.sparsify(matrix) for matrix in made]
