"""Units and models as the templates see them."""

import hashlib
from collections.abc import Sequence
from typing import Any

from boresight.codegen.functions.samples import norm_ends
from boresight.codegen.functions.unit import Result, Unit
from boresight.codegen.text.elementary import called
from boresight.codegen.text.names import (
    beyond,
    file_stem,
    norms_beyond,
    null_test,
    number,
    nz_name,
    ranges,
    shared_tables,
    snake,
    span,
    temporaries,
    with_nulls,
)
from boresight.codegen.text.statements import Part, parts
from boresight.derive.model import Model, Variable
from boresight.derive.models import MODELS


def where_read(model: Model) -> dict[str, tuple[str, str]]:
    """Field name -> (struct, how C reaches it)."""
    return {
        field.name: (struct.name, f"{struct.name}->{field.name}") for struct in model.structs for field in struct.fields
    }


def argument(a: Variable, path: str) -> dict[str, Any]:
    """One input of a unit; path: how C reaches it."""
    local = path.replace("->", ".")
    indexed = a.size > 1 or path == "x"
    return {
        "name": a.name,
        "size": a.size,
        "access": path if indexed else f"&{path}",
        "element": f"{local}[i]" if indexed else local,
        "low": ", ".join(number(v) for v in a.low),
        "high": ", ".join(number(v) for v in a.high),
        "given": f"{path}[i]" if indexed else path,
        "beyond_low": beyond(a)[0],
        "beyond_high": beyond(a)[1],
        "beyond_norm": norms_beyond(a),
        "norm_ends": ", ".join(map(number, norm_ends(a))),
        "norm": tuple(number(v * v) for v in a.norm) if a.norm else None,
        "path": path,
        "text": f"{a.meaning} ({a.unit}{', ' + a.frame if a.frame else ''}); {ranges(a)}",
    }


def outcome(r: Result, model: Model, guarded: bool) -> dict[str, Any]:
    """One output of a unit."""
    positions = [row * r.shape[1] + column for row, column in r.nonzeros]
    total = r.shape[0] * r.shape[1]
    dense = positions == list(range(total))
    size = str(total)
    if r.shape[1] == model.n:
        states = f"{model.c_prefix.upper()}_N_STATES"
        size = states if r.shape[0] == 1 else f"{r.shape[0]} * {states}"
    shape = f"{r.shape[0]} x {r.shape[1]}, row-major" if r.shape[1] > 1 else f"{r.shape[0]}"
    if not dense:
        shape += f"; {len(positions)} of {total} {'is' if len(positions) == 1 else 'are'} not zero"
    return {
        "name": r.name,
        "nz_name": nz_name(r),
        "nnz": len(positions),
        "total": total,
        "index": "" if dense else ", ".join(map(str, positions)),
        "positions": ", ".join(map(str, positions)),
        "low": r.low,
        "checked": bool(r.low) or guarded,
        "parameter": f"bs_real {r.name}[{size}]",
        "nz_parameter": f"bs_real {nz_name(r)}[{len(positions)}]",
        "path": r.name,
        "text": f"{r.meaning} ({r.unit}); {shape}"
        + (", wrapped to [-pi, pi]" if len(r.angle) == r.shape[0] else "")
        + (f"; {span(r.low, r.high)}" if r.low else ""),
        "angles": f"{sum(1 << row for row in r.angle)}U" if r.angle else "0",
    }


def declaration(field: Variable) -> str:
    return f"bs_real {field.name}{f'[{field.size}]' if field.size > 1 else ''};"


def kernel_parameters(args: list[dict[str, Any]], results: list[dict[str, Any]]) -> list[str]:
    return [f"const bs_real {a['name']}[{a['size']}]" for a in args] + [
        f"bs_real {r['nz_name']}[{r['nnz']}]" for r in results
    ]


def part_view(
    name: str, part: Part, c_name: str, args: list[dict[str, Any]], results: list[dict[str, Any]]
) -> dict[str, Any]:
    """One function of a kernel that has several."""
    read, written = [args[i] for i in part.reads], [results[i] for i in part.writes]
    shared = [f"{'' if part.leaves else 'const '}{c_name}_shared *shared"] * (part.takes or part.leaves)
    arguments = [*(a["name"] for a in read), *["&shared"] * len(shared), *(r["nz_name"] for r in written)]
    parameters = [*kernel_parameters(read, []), *shared, *kernel_parameters([], written)]
    return {
        "name": name,
        "parameters": ", ".join(parameters),
        "call": f"{name}({', '.join(arguments)})",
        "lines": part.lines,
    }


def view(model: Model, unit: Unit) -> dict[str, Any]:
    """One unit as the templates see it."""
    prefix = model.c_prefix
    c_name = f"{prefix}_{unit.name}"
    reach = where_read(model)
    structs = [s.name for s in model.structs if any(reach.get(a.name, ("",))[0] == s.name for a in unit.args)]
    reads_x = any(a.name == "x" for a in unit.args)
    reads = (["x"] if reads_x else []) + structs

    args = [argument(a, reach.get(a.name, ("", "x"))[1]) for a in unit.args]
    results = [outcome(r, model, unit.guarded) for r in unit.results]
    inputs = ([f"const bs_real x[{prefix.upper()}_N_STATES]"] if reads_x else []) + [
        f"const {prefix}_{s} *{s}" for s in structs
    ]
    pointers = reads + [r["name"] for r in results]
    functions, shared = parts(model, unit)
    boxes = {f"{a.name}_{end}": values for a in unit.args for end, values in (("low", a.low), ("high", a.high))}
    boxes |= {f"{r.name}_{end}": v for r in unit.results if r.low for end, v in (("least", r.low), ("most", r.high))}
    tables, table = shared_tables(boxes)
    call = ([*(["x"] if reads_x else []), *(f"&{s}" for s in structs)], [f"got_{r['name']}" for r in results])
    return {
        "c_name": c_name,
        "name": unit.name,
        "file": file_stem(model, unit.name),
        "guard": file_stem(model, unit.name),  # F and f, H and h are read into one file
        "meaning": unit.meaning,
        "stands_on": stands_on(model, unit),
        "pages": pages(model, file_stem(model, unit.name), unit.equations),
        "column": max(len(named["path"]) for named in args + results),
        "operations": unit.tape.operations,
        "hash": unit_hash(unit),
        "elementary": bool(called([unit])),
        "args": args,
        "results": results,
        "prototype": f"bs_status {c_name}({', '.join(inputs + [r['parameter'] for r in results])})",
        "null_test": null_test(pointers),
        "sparse": any(r["index"] for r in results),
        "nz_prototype": f"bs_status {c_name}_nz({', '.join(inputs + [r['nz_parameter'] for r in results])})",
        "checked_prototype": f"BS_INSIDE bs_status {c_name}_checked("
        + f"{', '.join(inputs + [r['nz_parameter'] for r in results])})",
        "checked_call": f"{c_name}_checked({', '.join(reads + [r['nz_name'] for r in results])})",
        "nz_null_test": null_test(reads + [r["nz_name"] for r in results]),
        "result_null_test": null_test([r["name"] for r in results]),
        "nz_call": f"{c_name}_nz({', '.join(reads + [r['nz_name'] for r in results])})",
        "tables": tables,
        "table": table,
        "kernel_parameters": ", ".join(kernel_parameters(args, results)),
        "kernel_inputs": "".join(f"{a['access']}, " for a in args),
        "parts": [
            part_view(f"{c_name}_kernel_{i}", part, c_name, args, results) for i, part in enumerate(functions, 1)
        ],
        "shared": shared,
        "casadi": {
            "arg": max(1, unit.function.sz_arg()),
            "res": max(1, unit.function.sz_res()),
            "iw": max(1, unit.function.sz_iw()),
            "w": max(1, unit.function.sz_w()),
        },
        "set_parameters": ", ".join(
            ([f"bs_real x[{prefix.upper()}_N_STATES]"] if reads_x else []) + [f"{prefix}_{s} *{s}" for s in structs]
        ),
        "structs": ([{"declaration": f"bs_real x[{prefix.upper()}_N_STATES] = {{0}}"}] if reads_x else [])
        + [{"declaration": f"{prefix}_{s} {s} = {{0}}"} for s in structs],
        "reads": reads,
        "inputs": ", ".join(call[0]),
        "call": f"{c_name}({', '.join(call[0] + call[1])})",
        "null_calls": with_nulls(c_name, call[0] + call[1])
        + (with_nulls(f"{c_name}_nz", call[0] + call[1]) if any(r["index"] for r in results) else []),
        "bound_arguments": ", ".join(
            f"({kind} *)at[{i}]"
            for i, kind in enumerate(
                (["const bs_real"] if reads_x else [])
                + [f"const {prefix}_{s}" for s in structs]
                + ["bs_real"] * len(results)
            )
        ),
        "batch_parameters": ", ".join(
            (["const bs_real *x, size_t x_stride"] if reads_x else [])
            + [f"const {prefix}_{s} *{s}, size_t {s}_stride" for s in structs]
            + [f"bs_real *{r['name']}" for r in results]
        ),
        "batch_arguments": ", ".join(
            (["&x[i * x_stride]"] if reads_x else [])
            + [f"&{s}[i * {s}_stride]" for s in structs]
            + [f"&{r['name']}[i * {r['total']}U]" for r in results]
        ),
    }  # fmt: skip


def stands_on(model: Model, unit: Unit) -> str:
    """The equations that the unit cites; of one without, what it is derived from."""
    if unit.equations:
        return f"Equations: {', '.join(unit.equations)}"
    of = {f"{m.name}_{part}": m for m in model.measurements for part in "zhH"}.get(unit.name)
    if of is not None and unit.name.endswith("_H") and of.H is None:
        return f"Derived from: {of.name}_h by differentiation"
    if unit.name == "feedback":
        return f"Derived from: the definition of the errors at the head of {snake(model.name)}.h, by finite rotations"
    if of is not None and (first := of.first_order):
        return f"Derived from: the exact h{f' of {first.of}' * bool(first.of)}, which the model states"
    return f"Derived from: the model {model.name}, which states it"


def pages(model: Model, file: str, equations: Sequence[str]) -> str:
    """The pages of the documentation's site of a file of C and of equations; a model of one's own has none there."""
    if model.name not in MODELS:
        return ""
    return ", ".join([f"c/{snake(model.name)}/{file}", *(f"equations/{page_of(cited)}" for cited in equations)])


def page_of(cited: str) -> str:
    """Of `kim-2018 (9)`."""
    paper, number = cited.rstrip(")").split(" (")
    return f"{paper}/{number}"


def model_view(model: Model, unit_views: list[dict[str, Any]]) -> dict[str, Any]:
    states, index = [], 0
    for block in model.states:
        components = []
        for symbol in block.symbols:
            components.append({"name": symbol.name, "index": index})
            index += 1
        states.append(
            {
                "name": block.name,
                "meaning": block.meaning,
                "unit": block.unit,
                "frame": block.frame,
                "components": components,
            }
        )
    return {
        "name": model.name,
        "snake": snake(model.name),
        "prefix": model.c_prefix,
        "page": f"models/{snake(model.name)}" if model.name in MODELS else "",
        "title": model.title,
        "frame": model.frame,
        "kind": model.kind.replace("-", " "),
        "card": list(model.conventions),
        "n": model.n,
        "states": states,
        "structs": [
            {
                "name": s.name,
                "meaning": s.meaning,
                "column": max(len(declaration(f)) for f in s.fields),
                "fields": [
                    {
                        "name": f.name,
                        "declaration": declaration(f),
                        "unit": f.unit,
                        "frame": f.frame,
                        "meaning": f.meaning,
                        "range": ranges(f),
                    }
                    for f in s.fields
                ],
            }
            for s in model.structs
        ],
        "units": unit_views,
        "parts": [],  # sources beside the units, each with a test of its own
    }


def unit_hash(unit: Unit) -> str:
    """Of the operations and of every name and number that the C of the unit takes from elsewhere."""
    words = [unit.tape.hash(), unit.name, *temporaries(unit, unit.tape)]
    for a in unit.args:
        words += [a.name, *(s.name for s in a.symbols), repr((a.low, a.high, a.norm))]
    for r in unit.results:
        words += [r.name, repr((r.shape, r.nonzeros, r.angle or False, r.low, r.high))]
    return hashlib.sha256("\n".join(words).encode()).hexdigest()
