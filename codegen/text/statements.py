"""The kernel of a unit as C: one statement an operation, in the order of the tape."""

from boresight.codegen.functions.units import Unit
from boresight.codegen.text.names import nz_name, temporaries

BINARY = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
CALLS = {"sqrt": "BS_SQRT", "sin": "BS_SIN", "cos": "BS_COS", "atan2": "BS_ATAN2", "fabs": "BS_FABS"}
COMPARE = {"lt": "<", "le": "<=", "eq": "==", "ne": "!="}


def statements(unit: Unit, columns: tuple[str, ...]) -> list[str]:
    """One statement an operation, in the order of the tape; then the outputs, each with the element that it is."""
    tape = unit.tape
    names = temporaries(unit, tape)
    lines = []
    for position, step in enumerate(tape.steps):
        a = [names[i] for i in step.args]
        if step.op in ("const", "input"):
            continue
        if step.op in BINARY:
            text = f"{a[0]} {BINARY[step.op]} {a[1]}"
        elif step.op in CALLS:
            text = f"{CALLS[step.op]}({', '.join(a)})"
        elif step.op in COMPARE:
            text = f"BS_TRUTH({a[0]} {COMPARE[step.op]} {a[1]})"
        else:
            text = {
                "neg": lambda a: f"-{a[0]}",
                "sq": lambda a: f"{a[0]} * {a[0]}",
                "twice": lambda a: f"BS_REAL(2.0) * {a[0]}",
                "inv": lambda a: f"BS_REAL(1.0) / {a[0]}",
                "not": lambda a: f"BS_REAL(1.0) - {a[0]}",
                "and": lambda a: f"{a[0]} * {a[1]}",
                "or": lambda a: f"BS_TRUTH(({a[0]} + {a[1]}) > BS_REAL(0.0))",
                "if_else_zero": lambda a: f"BS_SELECT({a[0]}, {a[1]})",
            }[step.op](a)
        lines.append(f"const bs_real {names[position]} = {text};")
    for output, k, position in sorted(tape.results):
        result = unit.results[output]
        row, column = result.nonzeros[k]
        where = (
            f"{row}"
            if result.shape[1] == 1
            else f"{row}, {columns[column] if result.shape[1] == len(columns) else column}"
        )
        lines.append(f"{nz_name(result)}[{k}] = {names[position]}; /* {where} */")
    return lines
