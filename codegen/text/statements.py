"""The kernel of a unit as C: one statement an operation, in the order of the tape; a long one in several functions."""

from dataclasses import dataclass
from itertools import accumulate, pairwise
from math import inf

from boresight.codegen.functions.tape import FREE, LIBRARY, Tape
from boresight.codegen.functions.unit import Result, Unit
from boresight.codegen.text.names import nz_name, temporaries
from boresight.derive.model import Model

SHORTEST, LONGEST = 50, 200  # statements of one function, where a kernel has several
CALL = 30  # values shared more that one function less is worth
BINARY = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
CALLS = {name: f"BS_{name.upper()}" for name in ("sqrt", "atan2", "fabs", "sign", "fmin", "fmax", *LIBRARY)}
PAIR = {"sin": "cos", "cos": "sin"}
COMPARE = {"lt": "<", "le": "<=", "eq": "==", "ne": "!="}


@dataclass(frozen=True)
class Part:
    """A range of the tape as one function.

    reads, writes: numbers of the arguments and of the results that it needs.  takes, leaves: whether it reads what an
    earlier part left, and whether it leaves values to a later one.
    """

    lines: list[str]
    reads: list[int]
    writes: list[int]
    takes: bool
    leaves: bool


def parts(model: Model, unit: Unit) -> tuple[list[Part], list[str]]:
    """The functions of the kernel, and the names of the values that one leaves to a later one.

    Each output is written where its value is known, with a comment that names the element, and one that names the
    blocks before those of a state.
    """
    tape = unit.tape
    ranges = ranges_of(tape)
    part_of = {position: number for number, positions in enumerate(ranges) for position in positions}
    kept = {
        position
        for user, number in part_of.items()
        for position in tape.steps[user].args
        if part_of.get(position, number) != number
    }
    plain = temporaries(unit, tape)
    where = [elements(model, unit, result) for result in unit.results]
    block = [blocks(model, unit, result) for result in unit.results]
    names = [f"shared->{name}" if position in kept else name for position, name in enumerate(plain)]
    made = []
    for number, positions in enumerate(ranges):
        read = [a for position in positions for a in tape.steps[position].args]
        # what is no operation is written last
        outputs = [r for r in sorted(tape.results) if part_of.get(r[2], len(ranges) - 1) == number]
        read += [position for _, _, position in outputs]
        lines = [line for p in positions for line in statement(tape, p, names, kept, positions)]
        before = ""
        for o, k, position in outputs:
            lines += [f"/* {block[o][k]} */"] * (block[o][k] not in ("", before))
            before = block[o][k]
            lines.append(f"{nz_name(unit.results[o])}[{k}] = {names[position]}; /* {where[o][k]} */")
        made.append(
            Part(
                lines,
                sorted({tape.steps[p].source[0] for p in read if tape.steps[p].op == "input"}),
                sorted({o for o, _, _ in outputs}),
                any(p in kept for p in read),
                any(p in kept for p in positions),
            )
        )
    return made, [plain[position] for position in sorted(kept)]


def ranges_of(tape: Tape) -> list[list[int]]:
    """The operations of the tape as ranges of SHORTEST to LONGEST, cut where the fewest values are still to be used."""
    work = [position for position, step in enumerate(tape.steps) if step.op not in FREE]
    if len(work) <= LONGEST:
        return [work]
    last = {position: i for i, user in enumerate(work) for position in tape.steps[user].args}
    change = [0] * (len(work) + 1)  # in how many values are alive before each operation
    for i, position in enumerate(work):
        if position in last:
            change[i + 1] += 1
            change[last[position] + 1] -= 1
    alive = list(accumulate(change))
    # of the best cuts up to each operation, and where the last range of these begins
    costs, before = [0.0, *[inf] * (SHORTEST - 1)], [0] * SHORTEST
    for end in range(SHORTEST, len(work) + 1):
        before.append(min(range(max(0, end - LONGEST), end - SHORTEST + 1), key=costs.__getitem__))
        costs.append(costs[before[end]] + alive[end] + CALL)
    cuts = [len(work)]
    while cuts[-1] > 0:
        cuts.append(before[cuts[-1]])
    return [work[start:end] for end, start in pairwise(cuts)][::-1]


def statement(tape: Tape, position: int, names: list[str], kept: set[int], positions: list[int]) -> list[str]:
    """One operation as lines of C: one statement, or for a sine and a cosine of one angle in this range a single call
    where the first of them stands, and nothing at the other."""
    step = tape.steps[position]
    other = [p for p in positions if tape.steps[p].op == PAIR.get(step.op) and tape.steps[p].args == step.args]
    if not other:
        left = names[position] if position in kept else f"const bs_real {names[position]}"
        return [f"{left} = {expression(tape, position, names)};"]
    if other[0] < position:
        return []
    sine, cosine = (position, other[0]) if step.op == "sin" else (other[0], position)
    declared = [f"bs_real {names[p]};" for p in (sine, cosine) if p not in kept]
    return [*declared, f"BS_SINCOS({names[step.args[0]]}, &{names[sine]}, &{names[cosine]});"]


def expression(tape: Tape, position: int, names: list[str]) -> str:
    """One operation as C."""
    step = tape.steps[position]
    a = [names[i] for i in step.args]
    if step.op in BINARY:
        return f"{a[0]} {BINARY[step.op]} {a[1]}"
    if step.op in CALLS:
        return f"{CALLS[step.op]}({', '.join(a)})"
    if step.op in COMPARE:
        return f"BS_TRUTH({a[0]} {COMPARE[step.op]} {a[1]})"
    return {
        "neg": lambda: f"-{a[0]}",
        "sq": lambda: f"{a[0]} * {a[0]}",
        "twice": lambda: f"BS_REAL(2.0) * {a[0]}",
        "inv": lambda: f"BS_REAL(1.0) / {a[0]}",
        "not": lambda: f"BS_REAL(1.0) - {a[0]}",
        "and": lambda: f"{a[0]} * {a[1]}",
        "or": lambda: f"BS_TRUTH(({a[0]} + {a[1]}) > BS_REAL(0.0))",
        "if_else_zero": lambda: f"BS_SELECT({a[0]}, {a[1]})",
    }[step.op]()


def blocks(model: Model, unit: Unit, result: Result) -> list[str]:
    """For each non-zero the states that its row belongs to and by which it stands, as `phi by dv_n, d_gyro_bias`, or
    the result of several; nothing where there is one alone."""
    states = [v.name for v in model.states for _ in v.symbols]
    rows, columns = result.shape
    if columns == model.n > 1:
        left = states if rows == model.n else rows_named(model, unit, result)
    elif rows == model.n > 1 and unit.name in ("next", "f"):
        left = states
    else:
        return [result.name * (len(unit.results) > 1)] * len(result.nonzeros)
    by: dict[str, dict[str, None]] = {}
    for i, j in result.nonzeros:
        by.setdefault(left[i], {}).setdefault(states[j] if columns == model.n else "")
    ordered = {row: [name for name in dict.fromkeys(states) if name in found] for row, found in by.items()}
    return [
        f"{left[i]} by {', '.join(ordered[left[i]])}" if columns == model.n else left[i] for i, _ in result.nonzeros
    ]


def elements(model: Model, unit: Unit, result: Result) -> list[str]:
    """Row and column of each non-zero, by name if they have one: a state, a row of the measurement, a component."""
    states = [symbol.name for symbol in model.x]
    left, columns = rows_named(model, unit, result), result.shape[1]
    if columns == 1:
        return [left[i] for i, _ in result.nonzeros]
    right = states if columns == model.n else [str(j) for j in range(columns)]
    return [f"{left[i]}, {right[j]}" for i, j in result.nonzeros]


def rows_named(model: Model, unit: Unit, result: Result) -> list[str]:
    """The rows by name if they have one, otherwise by number."""
    of_units = {f"{m.name}_{suffix}": list(m.rows) for m in model.measurements for suffix in ("z", "h", "H")}
    states = [symbol.name for symbol in model.x]
    of_units |= {name: states for name in ("F", "f", "Phi", "Qc", "Q", "next")}
    fields = {field.name: [symbol.name for symbol in field.symbols] for field in model.inputs}
    named = of_units.get(unit.name) or fields.get(result.name, [])
    return named if len(named) == result.shape[0] else [str(i) for i in range(result.shape[0])]
