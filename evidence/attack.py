"""Hostile calls: the functions of a filter in random order, with numbers in their box, at its corners and beyond it,
no numbers, null pointers and spoilt memory; after each call the sentence of the filter's header is judged.

The driver is harness/attack.c. What it calls is printed here from the prototypes of the filter's header and from the
boxes of the manifest, so that it serves every model, and a new function of the filter is called without a change.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from boresight import BoresightError
from boresight.codegen.folder import Folder
from boresight.evidence.targets import HARNESS, PRECISIONS
from boresight.runtime.compiler import compile_sources, run

FORMS = {"Joseph": 0, "UD": 1}
CALLS, SANITIZED = 5_000_000, 100_000  # of each precision and form
LARGE, LARGE_CALLS = 20, 1_000_000  # states beyond which a call is dear, and how many there are then
SEED = 13
SANITIZERS = ("-fsanitize=address,undefined,float-cast-overflow", "-fno-sanitize-recover=all", "-g")
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
PROTOTYPE = re.compile(r"^bs_status (\w+)\(([^;]*)\);", re.MULTILINE | re.DOTALL)
PARAMETER = re.compile(r"(const )?((?:unsigned )?\w+) (\*?)(\w+)(?:\[(.*)\])?")
STATUS = re.compile(r"\b(BS_\w+) = (\d+)")
WEIGHTS = {"strapdown": 30, "propagate": 30, "correct": 5, "consider": 1, "disable": 1}
MEASURE, OTHER = 10, 2  # weights of the other functions
ROUNDING = {"float": 1e-5, "double": 1e-13}  # of a sum of squares


@dataclass(frozen=True)
class Parameter:
    """One argument.  size: the text between its brackets, empty of a scalar or a pointer to a struct."""

    const: bool
    type: str
    pointer: bool
    name: str
    size: str

    @property
    def nullable(self) -> bool:
        """Whether it is a pointer that must not be null."""
        return (self.pointer or bool(self.size)) and not self.optional

    @property
    def optional(self) -> bool:
        return self.type == "bs_gates"


@dataclass(frozen=True)
class Function:
    """name: behind PREFIX_filter_."""

    symbol: str
    name: str
    parameters: tuple[Parameter, ...]

    @property
    def measurement(self) -> str:
        return self.name.removeprefix("measure_") if self.name.startswith("measure_") else ""

    @property
    def begins(self) -> bool:
        """Whether the filter is a new one afterwards."""
        return self.name.startswith("init") or self.name == "restore"

    @property
    def reads(self) -> bool:
        """Whether it leaves the filter as it is."""
        return any(parameter.const and parameter.name == "filter" for parameter in self.parameters)

    @property
    def navigates(self) -> bool:
        """Whether it leaves x and P alone, as the header says; of what is spoilt there it says nothing."""
        return self.name == "strapdown"

    @property
    def weight(self) -> int:
        return 1 if self.begins else WEIGHTS.get(self.name, MEASURE if self.measurement else OTHER)


def functions(folder: Folder) -> list[Function]:
    """The functions that the filter's header offers."""
    prefix = folder.manifest["c_prefix"]
    text = COMMENT.sub("", header(folder).read_text())
    found = []
    for symbol, listed in PROTOTYPE.findall(text):
        if not symbol.startswith(f"{prefix}_filter_"):
            continue
        parameters = []
        for parameter in (" ".join(word.split()) for word in listed.split(",")):
            match = PARAMETER.fullmatch(parameter)
            if match is None:
                raise BoresightError(f"{symbol}: {parameter!r} is no parameter that can be drawn")
            const, type_, star, name, size = match.groups()
            if const and star and type_ == "bs_real":  # as many numbers as the caller says
                size = "ATTACK_N * ATTACK_N"
            parameters.append(Parameter(bool(const), type_, bool(star), name, size or ""))
        found.append(Function(symbol, symbol.removeprefix(f"{prefix}_filter_"), tuple(parameters)))
    return found


def header(folder: Folder) -> Path:
    return folder.include / f"{folder.manifest['model'].replace('-', '_')}_filter.h"


# ---------------------------------------------------------------- what the driver is told


def calls_h(folder: Folder) -> str:
    """attack_calls.h: boxes, and each function's arguments and call."""
    manifest, listed = folder.manifest, functions(folder)
    prefix = manifest["c_prefix"]
    upper = prefix.upper()
    statuses = dict(STATUS.findall((folder.include / "boresight.h").read_text()))
    lines = [
        f'#include "{header(folder).name}"',
        f"typedef {prefix}_filter attack_filter;",
        f"#define ATTACK_N {upper}_N_STATES",
        f"#define ATTACK_PACKED {upper}_N_PACKED",
        f"#define ATTACK_FUNCTIONS {len(listed)}",
        f"#define ATTACK_INIT {[function.name for function in listed].index('init')}",
        f"#define ATTACK_LAST_STATUS {max(map(int, statuses.values()))}",
        f"#define ATTACK_AT_CEILING {statuses.get('BS_AT_CEILING', -1)}",
        f"#define ATTACK_CARRIED {len(manifest['filter']['carried'])}",
        "#ifdef BORESIGHT_FLOAT",
        f"#define ATTACK_ROUNDING {ROUNDING['float']}",
        "#else",
        f"#define ATTACK_ROUNDING {ROUNDING['double']}",
        "#endif",
        *boxes(manifest),
        *state_box(manifest),
    ]
    for function in listed:
        lines += storage(function, manifest)
    lines += table("names", "const char *const", [f'"{function.name}"' for function in listed])
    lines += table("weights", "const int", [str(function.weight) for function in listed])
    lines += table("coasts", "const int", [str(int(function.name == "propagate")) for function in listed])
    lines += table("begins", "const int", [str(int(function.begins)) for function in listed])
    lines += table("reads", "const int", [str(int(function.reads)) for function in listed])
    lines += table("navigates", "const int", [str(int(function.navigates)) for function in listed])
    lines += table("pointers", "const int", [str(sum(p.nullable for p in f.parameters)) for f in listed])
    for signature, body, otherwise in (
        ("static void prepare(int function)", drawing, ""),
        ("static bs_status called(int function, attack_filter *flown, int null)", calling, "return BS_OK;"),
        ("static int outputs_finite(int function)", outputs, "return 1;"),
        ("static int rows_stay(int function)", staying, "return 0;"),
    ):
        lines += chosen(signature, {function.name: body(function, manifest) for function in listed}, otherwise)
    return "\n".join(lines) + "\n"


def table(name: str, type_: str, values: list[str]) -> list[str]:
    return [f"static {type_} {name}[] = {{ {', '.join(values)} }};"]


def chosen(signature: str, bodies: dict[str, list[str]], otherwise: str) -> list[str]:
    """A function of C with a case for each function of the filter whose body has lines, by its name."""
    lines = [signature, "{", "    switch (function) {"]
    for i, (name, body) in enumerate(bodies.items()):
        if body:
            end = [] if body[-1].startswith("return") else ["break;"]
            lines += [f"    case {i}: /* {name} */", *(f"        {line}" for line in [*body, *end])]
    return [*lines, "    default:", "        break;", "    }", *([f"    {otherwise}"] if otherwise else []), "}"]


def boxes(manifest: dict[str, Any]) -> Iterator[str]:
    """Each struct of inputs with its box, and those that the filter carries, at their place in it."""
    prefix, carried = manifest["c_prefix"], manifest["filter"]["carried"]
    at = []
    for name, fields in manifest["structs"].items():
        if name == "x":
            continue
        size = sum(field["size"] for field in fields)
        for end in ("low", "high"):
            values = ", ".join(repr(float(v)) for field in fields for v in field[end])
            yield f"static const double {name}_{end}[{size}] = {{ {values} }};"
        starts = [sum(field["size"] for field in fields[:i]) for i in range(len(fields))]
        ranges = [field["norm"] or (0.0, 0.0) for field in fields]
        rows = [f"{{ {s}, {f['size']}, {a!r}, {b!r} }}" for s, f, (a, b) in zip(starts, fields, ranges, strict=True)]
        yield f"static const attack_field {name}_fields[] = {{ {', '.join(rows)} }};"
        where = f"{size}, {name}_low, {name}_high, {name}_fields, {len(fields)}"
        yield f"static {prefix}_{name} given_{name};"
        yield f"static const attack_struct box_{name} = {{ (bs_real *)&given_{name}, {where} }};"
        if name in carried:
            at.append(f"{{ (bs_real *)&filter.{name}, {where} }}")
    yield "static attack_filter filter;"
    yield f"static const attack_struct carried[] = {{ {', '.join(at) or '{ NULL, 0, NULL, NULL, NULL, 0 }'} }};"


def state_box(manifest: dict[str, Any]) -> Iterator[str]:
    """How large a state may be, for its variance; its box too where it is total."""
    low, high = ([v for block in manifest["blocks"] for v in block[end]] for end in ("low", "high"))
    half = ", ".join(repr((b - a) / 2) for a, b in zip(low, high, strict=True))
    sizes = [str(block["size"]) for block in manifest["blocks"]]
    yield f"static const int block_sizes[{len(sizes)}] = {{ {', '.join(sizes)} }};"
    yield f"static const double state_size[ATTACK_N] = {{ {half} }};"
    yield f"static const double state_low[ATTACK_N] = {{ {', '.join(map(repr, map(float, low)))} }};"
    yield f"static const double state_high[ATTACK_N] = {{ {', '.join(map(repr, map(float, high)))} }};"


def held(function: Function, parameter: Parameter, manifest: dict[str, Any]) -> str:
    """The variable that stands for an argument; one of a type of its own is shared by all functions."""
    struct = parameter.type.removeprefix(f"{manifest['c_prefix']}_")
    if parameter.pointer and struct in manifest["structs"] and struct != "x":
        return f"given_{struct}"
    if parameter.pointer and parameter.type not in ("bs_real", "int", "unsigned char", "size_t"):
        return f"any_{parameter.type}"
    if parameter.name == "bytes":
        return "any_bytes"
    return f"{function.name}_{parameter.name}"


def is_filter(parameter: Parameter) -> bool:
    return parameter.pointer and parameter.name == "filter"


def storage(function: Function, manifest: dict[str, Any]) -> Iterator[str]:
    """The variables of a function's arguments."""
    for parameter in function.parameters:
        name = held(function, parameter, manifest)
        if is_filter(parameter) or name.startswith("given_"):
            continue
        yield f"static {parameter.type} {name}{f'[{parameter.size}]' if parameter.size else ''};"


def drawing(function: Function, manifest: dict[str, Any]) -> list[str]:
    """How the arguments are drawn."""
    lines = []
    measurement = manifest["measurements"].get(function.measurement, {})
    for parameter in function.parameters:
        name = held(function, parameter, manifest)
        count = f"(int)(sizeof({name}) / sizeof({name}[0]))"
        if parameter.optional:
            lines.append(f"draw_gates(&{name});")
        elif is_filter(parameter) or ((parameter.pointer or parameter.size) and not parameter.const):
            continue  # an output
        elif name == "any_bytes":
            lines.append(f"change_byte({name}, sizeof({name}));")
        elif name.startswith("given_"):
            lines.append(f"draw_struct(&box_{name.removeprefix('given_')});")
        elif parameter.type == "bs_real" and parameter.size:
            if parameter.name == "R":
                lines.append(f"draw_noise({name}, {len(measurement['rows'])}, {int(measurement['correlated'])});")
            elif parameter.name == "block":
                states = f"{function.name}_first, {function.name}_count"
                lines.append(f"draw_block({name}, {states}, ATTACK_N, state_size);")
            elif parameter.name == "blocks":
                lines.append(f"draw_blocks({name}, block_sizes, {len(manifest['blocks'])}, state_size);")
            elif "sigma" in parameter.name or parameter.name == "variance":
                lines.append(f"draw_sigmas({name}, ATTACK_N, state_size);")
            elif "*" in parameter.size:
                lines.append(f"draw_covariance({name}, ATTACK_N, state_size);")
            elif parameter.name == "x":
                lines += ["for (int i = 0; i < ATTACK_N; ++i) {",
                          f"    {name}[i] = (mode == ALL_HOSTILE) ? hostile() : number(state_low[i], state_high[i]);",
                          "}"]  # fmt: skip
            else:
                lines.append(f"draw_numbers({name}, {count}, 1e3, 1);")
        elif parameter.type == "unsigned char" and parameter.size:
            lines.append(f"draw_bytes({name}, sizeof({name}));")
        elif parameter.type == "int" and not parameter.pointer:
            lines.append(f"{name} = draw_int(ATTACK_N + 1) - 1;")
        elif parameter.type == "bs_beyond":
            lines.append(f"{name} = (bs_beyond)(draw_int(2) - 1);")
        else:
            raise BoresightError(f"{function.symbol}: nothing says how {parameter.type} {parameter.name} is drawn")
    name = innovation(function, manifest)
    return [*lines, f"{name}.used = 77U;"] if name else lines


def calling(function: Function, manifest: dict[str, Any]) -> list[str]:
    """The call, the pointer whose number is `null` being none."""
    words, pointer = [], 0
    for parameter in function.parameters:
        name = held(function, parameter, manifest)
        if is_filter(parameter):
            words.append("flown")
        elif parameter.optional:
            words.append(f"(below(8) == 0) ? NULL : &{name}")
        elif parameter.nullable:
            words.append(f"(null == {pointer}) ? NULL : {'' if parameter.size else '&'}{name}")
        else:
            words.append(name)
        pointer += parameter.nullable
    return [f"return {function.symbol}({', '.join(words)});"]


def outputs(function: Function, manifest: dict[str, Any]) -> list[str]:
    """Whether the numbers that the call has given are finite."""
    tests = []
    for parameter in function.parameters:
        name = held(function, parameter, manifest)
        if parameter.const or not parameter.nullable:
            continue  # an input
        if parameter.type.endswith("_innovation"):
            tests.append(f"rows_finite({name}.nu, {name}.S, {name}.used) && finite(&{name}.nis, 1)")
        elif parameter.type == "bs_real":
            count = f"(int)(sizeof({name}) / sizeof(bs_real))"
            tests.append(f"finite({'' if parameter.size else '&'}{name}, {count})")
    return [f"return {' && '.join(tests)};"] if tests else []


def innovation(function: Function, manifest: dict[str, Any]) -> str:
    """The variable that a measurement reports in."""
    names = [held(function, p, manifest) for p in function.parameters if p.type.endswith("_innovation")]
    return names[0] if names and function.measurement else ""


def staying(function: Function, manifest: dict[str, Any]) -> list[str]:
    """Whether a measurement has written what it reports in."""
    name = innovation(function, manifest)
    return [f"return {name}.used != 77U;"] if name else []


# ---------------------------------------------------------------- the attack


def attack(folder: Folder, out: Path, calls: int | None = None) -> dict[str, dict[str, Any]]:
    """By precision and form, the sanitized part apart: calls, how often each status was answered, kinds of breaks."""
    dear = len(folder.manifest["states"]) > LARGE
    calls = calls or (LARGE_CALLS if dear else CALLS)
    found = {}
    for precision in PRECISIONS:
        for form in forms(folder):
            for flags, some in (((), calls), (SANITIZERS, max(1, calls * SANITIZED // CALLS))):
                name = f"{precision} {form}{' sanitized' if flags else ''}"
                program = driver(folder, precision, form, out / name.replace(" ", "-"), flags)
                found[name] = {"calls": some, "seed": SEED, **attacked(program, some)}
    return found


def forms(folder: Folder) -> list[str]:
    """Those of the covariance that the folder has: of an export it may be one."""
    (text,) = (path.read_text() for path in folder.files("include/*_covariance.h"))
    return [form for form in FORMS if f"{folder.manifest['c_prefix']}_{form.lower()}_predict(" in text]


def driver(folder: Folder, precision: str, form: str, out: Path, flags: tuple[str, ...] = ()) -> Path:
    """The program that attacks the folder's filter."""
    out.mkdir(parents=True, exist_ok=True)
    (out / "attack_calls.h").write_text(calls_h(folder))
    common: list[object] = ["gcc", "-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", *flags]
    common += [*PRECISIONS[precision], f"-DBORESIGHT_UD={FORMS[form]}", "-I", folder.include, "-I", out]
    sources: dict[Path, tuple[str, ...]] = {unit.path: () for unit in folder.units}
    objects = compile_sources(common, {**sources, HARNESS / "attack.c": ("-Wno-unused",)}, out)
    run(["gcc", *flags, *objects.values(), "-lm", "-o", out / "attack"])
    return out / "attack"


def attacked(program: Path, calls: int, seed: int = SEED) -> dict[str, Any]:
    """What the program counted.

    answers: by status, how many of all calls.  breaks: by kind how many, and the number of the first call, with which
    it can be repeated; spoilt: the same where a number that the filter holds was changed behind its back before.
    """
    answers: dict[str, int] = {}
    breaks: dict[str, dict[str, list[int]]] = {"breaks": {}, "spoilt": {}}
    for line in run([program, calls, seed]).splitlines():
        word, name, *numbers = line.split("\t")
        if word == "answer":
            answers[numbers[0]] = answers.get(numbers[0], 0) + int(numbers[1])
        else:
            breaks[word][name] = [int(number) for number in numbers]
    return {"answers": answers, **breaks}
