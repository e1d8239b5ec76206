"""What the commands print for a person: each function takes results and returns parts for `terminal.page`."""

from collections import Counter
from collections.abc import Iterable, Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any

from rich.console import RenderableType

from boresight.derive.letters import is_number, number_label
from boresight.terminal import bullets, indented, table

if TYPE_CHECKING:
    from boresight.codegen.verify import Check

Parts = list[RenderableType]
STATUSES = ("exact", "first-order", "definition", "erratum")

# ---------------------------------------------------------------- models


def models(manifests: Iterable[dict[str, Any]]) -> Parts:
    """One line each."""
    rows = table("model", "n", "what it is", prose="what it is", right=("n",))
    for m in manifests:
        states = len(m["states"])
        rows.add_row(m["model"], str(states or ""), m["title"].removesuffix(f", {states} states"))
    return [rows, "", "n is the number of states; 'boresight models NAME' prints these, inputs and functions."]


def model(m: dict[str, Any]) -> Parts:
    """Everything that a caller of the model's C needs to know."""
    parts: Parts = [f"{m['model']}: {m['title']}", f"frame {m['frame']}; C prefix {m['c_prefix']}_"]
    if m["blocks"]:
        parts += ["", "States", indented(variables(m["blocks"], singly=True))]
    for name, fields in m["structs"].items():
        if [field["name"] for field in fields] != ["x"]:  # the states themselves
            parts += ["", f"Inputs in {m['c_prefix']}_{name}", indented(variables(fields))]
    if m["measurements"]:
        rows = table("name", "unit", "rows", "what z is", prose="what z is")
        for name, measurement in m["measurements"].items():
            rows.add_row(name, measurement["unit"], " ".join(measurement["rows"]), measurement["meaning"])
        parts += ["", "Measurements", indented(rows)]
    rows = table("C function", "operations", "inputs -> results", prose="inputs -> results", right=("operations",))
    for unit in m["units"].values():
        results = (r["name"] + "".join(f"[{n}]" for n in sizes(r["shape"])) for r in unit["results"])
        rows.add_row(unit["c_name"], str(unit["operations"]), " ".join([*unit["fields"], "->", *results]))
    return [*parts, "", "Functions", indented(rows)]


def sizes(shape: Sequence[int]) -> Sequence[int]:
    """Of a matrix rows and columns, of a vector its length, of a scalar none."""
    rows, columns = shape
    return shape if columns > 1 else [rows] if rows > 1 else []


def variables(fields: Iterable[dict[str, Any]], singly: bool = False) -> RenderableType:
    """A line for each field, and for each component where they differ or are asked for `singly`."""
    rows = table("name", "unit", "box", "meaning", prose="meaning")
    for field in fields:
        size, unit = field["size"], field["unit"].split(", ")
        units = unit if len(unit) == size else unit * size
        if field["norm"]:
            boxes = ["norm {:g} to {:g}".format(*field["norm"])] * size
        else:
            boxes = [f"{low:.6g} to {high:.6g}" for low, high in zip(field["low"], field["high"], strict=True)]
        meaning = field["meaning"] + (f" ({field['frame']})" if field["frame"] else "")
        lines = list(zip(field["components"], units, boxes, strict=True))
        if not singly:
            alike = len({line[1:] for line in lines}) == 1
            lines = [(field["name"], *lines[0][1:])] if alike else [(field["name"], "", ""), *lines]
        for i, line in enumerate(lines):
            rows.add_row(*line, "" if i else meaning)
    return rows


# ---------------------------------------------------------------- equations


def equations(ledgers: dict[str, list[dict[str, str]]]) -> Parts:
    """How many equations of each paper have which status, and which are errata."""
    rows = table("paper", "equations", *STATUSES, right=("equations", *STATUSES))
    errata = table("errata of", "kinds and equations", prose="kinds and equations")
    for paper, entries in ledgers.items():
        numbered = [entry for entry in entries if is_number(entry["number"])]
        counts = Counter(entry["status"] for entry in numbered)
        rows.add_row(paper, str(len(numbered)), *(str(counts[status]) for status in STATUSES))
        kinds = dict.fromkeys(entry["kind"] for entry in entries if entry["kind"])
        named = (
            f"{kind} " + " ".join(number_label(e["number"]) for e in entries if e["kind"] == kind) for kind in kinds
        )
        errata.add_row(paper, ", ".join(named))
    return [rows, "", errata, "'boresight equations PAPER' prints what was found about each equation."]


def paper(name: str, entries: Sequence[dict[str, str]], kept: dict[str, Any]) -> Parts:
    """A line for each equation, what was found beside them, and what is not held.  kept: of kept_ledger.ledger."""
    rows = table("", "status", "kind", "what was found", prose="what was found", right=("",))
    for entry in entries:
        more = f" {entry['depends']}" if entry["depends"].startswith("It depends") else ""
        rows.add_row(number_label(entry["number"]), entry["status"], entry["kind"], entry["found"] + more)
    counts = Counter(entry["status"] for entry in entries)
    numbered = sum(is_number(entry["number"]) for entry in entries)
    beside_them = f" and {len(entries) - numbered} without a number" if len(entries) > numbered else ""
    total = ", ".join(f"{counts[status]} {status}" for status in STATUSES if counts[status])
    beside: Parts = ["", "Beside the equations:", bullets(kept["findings"])] if kept["findings"] else []
    return [
        f"{name}: {numbered} equation{'s' * (numbered != 1)}{beside_them}, {total}",
        "",
        rows,
        "",
        f"The remainders hold for {kept['conditions'][0]}.",
        *beside,
        "",
        "Not held:",
        bullets(kept["unheld"]),
        "",
        f"'boresight equations {name} NUMBER' prints the evidence, 'boresight show {name} NUMBER' the derivation.",
    ]


def equation(entry: dict[str, str], conditions: Sequence[str], units: Sequence[str] = ()) -> Parts:
    """The evidence on one equation.  units: the functions in C that are made of it."""
    kind = f"; kind {entry['kind']}" * bool(entry["kind"]) + f", origin {entry['origin']}" * bool(entry["origin"])
    parts: Parts = [
        f"{entry['paper']} {number_label(entry['number'])}: {entry['status']}{kind}",
        "",
        entry["found"],
        "",
    ]
    evidence = entry["evidence"].replace(f"at {conditions[1]}: ", "").replace(f" at {conditions[0]}", "")
    parts += ["Evidence", bullets(evidence.split("; "))]
    used = [text for text in conditions if f"at {text}" in entry["evidence"]]
    parts += [text for condition in used for text in ("", "Computed at", indented(condition))]
    by_hand = [entry["decisions"]] if entry["decisions"] else []
    parts += ["", "Decided by hand", bullets([*by_hand, entry["depends"]])]
    for title, text in (("Note", entry["note"]), ("In C", ", ".join(units))):
        parts += ["", title, indented(text)] if text else []
    return parts


# ---------------------------------------------------------------- verify


def verified(checks: Sequence["Check"]) -> Parts:
    """For each model a table of its C, then what it states and flies beside exact mechanics; the verdict."""
    from boresight.codegen.mechanics import MechanicsCheck
    from boresight.codegen.verify import UnitCheck, counted

    parts: Parts = []
    for name in dict.fromkeys(check.model for check in checks):
        numbers = ("points", "outputs", "error", "bound / error")
        rows = table("function", "points", "outputs", "bits", "error", "bound / error", "", right=numbers)
        exact = table(
            "held against", "exact mechanics", "difference", "order", "", prose="exact mechanics",
            right=("difference", "order"),
        )  # fmt: skip
        orders: Parts = []
        for check in (check for check in checks if check.model == name):
            ok = "ok" if check.ok else "FAILED"
            if isinstance(check, UnitCheck):
                loose = f"{check.looseness:.1f}" if isfinite(check.looseness) else "exact"
                rows.add_row(
                    check.unit, str(check.points), str(check.outputs), "same" if check.same_bits else "DIFFER",
                    f"{check.largest_error:.1e}", loose, ok,
                )  # fmt: skip
                if not check.ok:
                    orders.append(f"{check.unit}: {check.reason}")
            elif isinstance(check, MechanicsCheck):
                if check.why:
                    word = "stated" if check.stated else "listed" if check.unheld else "not checked"
                    exact.add_row(check.unit, check.unheld or check.why, "", "", word)
                else:
                    where = f"; {check.entry}" if check.entry else ""
                    order = f"{check.order:.2f}" if check.order is not None else ""
                    # of a rule without a size, as a sign in the words, there is no difference to show
                    size = f"{check.difference:.1e}" if check.ok or check.difference else ""
                    exact.add_row(check.unit, check.against + where, size, order, ok)
            else:
                beyond = (
                    "" if check.coefficient is None
                    else f", and by {check.coefficient:.3f} per unit of what it neglects"
                )  # fmt: skip
                differs = f"{check.unit} differs from the exact Jacobian by {check.limit:.1e}{beyond}: {ok}"
                orders.append(differs if check.ok else f"{check.unit}: {check.reason}: {ok}")
        parts += [name, indented(rows), *map(indented, orders), *([indented(exact)] if exact.row_count else [])]
    parts.append(
        "The bits are compared with CasADi's C, error and bound with 50 digits; a difference from exact mechanics is a "
        "part of the largest of its row, each entry times the box of its state; its order is the power of dt with "
        "which it falls.  Listed: nothing exact is known of it, for the reason that the model gives.  Stated: "
        "nothing else knows it, so that a wrong sign in it is not found here; compare it with its source, and fly it."
    )
    count = counted(checks)
    more = [f", {count[name]} {name}" for name in ("not checked", "listed") if count[name]]
    return [*parts, f"verify: {count['passed']} passed, {count['failed']} failed{''.join(more)}"]
