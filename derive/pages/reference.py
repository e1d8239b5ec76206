"""The reference of boresight.derive.mechanics, made from signatures and docstrings.

python -m boresight.derive.pages.reference > docs/reference/mechanics.md
"""

import inspect
import re
import textwrap
from types import ModuleType
from typing import Any

from boresight.derive.constant import Constant
from boresight.derive.mechanics import earth, error_models, mechanization, rotation

MODULES = (rotation, earth, mechanization, error_models)
WIDTH = 100
ROW = re.compile(r"^Row: mechanics (.+)\.$", re.MULTILINE)  # of a docstring: where the ledger judges the function
HEAD = """# Reference: the pieces that models are made of

Functions of `boresight.mechanics`, which take and return SymPy expressions: `from
boresight.mechanics import skew`. Every number is in SI units, every angle in rad. `frame` is `NED`
or `ENU`; what has no other frame named is resolved in that level. [Mechanics](../mechanics.md) says
what holds them, and
[compose](../how-to/compose.md) shows how a model is made of them. A row is one of
`boresight equations mechanics`; `boresight show mechanics ROW` derives it.

This page is made from the docstrings; `python -m boresight.derive.pages.reference` prints it.
"""


def public(module: ModuleType) -> list[tuple[str, Any]]:
    """The functions and classes that the module defines, in its order."""
    own = [(name, value) for name, value in vars(module).items() if getattr(value, "__module__", "") == module.__name__]
    return [(name, value) for name, value in own if not name.startswith("_") and callable(value)]


def constants(module: ModuleType) -> list[tuple[str, Constant]]:
    """The named constants that the module defines, in its order."""
    source = inspect.getsource(module)
    own = [(name, value) for name, value in vars(module).items() if isinstance(value, Constant)]
    return [(name, value) for name, value in own if re.search(rf"^{name} = ", source, re.MULTILINE)]


def number(one: Constant) -> str:
    """Its number, or what it is made of."""
    return repr(float(one.value)).removesuffix(".0") if one.value.is_Rational else f"`{one.value}`"


def signature(name: str, function: Any) -> str:
    """As a caller writes it: names, and what is left out by default."""
    parameters = []
    for one in inspect.signature(function).parameters.values():
        default = "" if one.default is one.empty else f"={getattr(one.default, 'name', one.default)}"
        parameters += [one.name + default] if one.name != "self" else []
    return f"{name}({', '.join(parameters)})"


def prose(text: str, indent: str = "") -> str:
    """A docstring as Markdown: its paragraphs filled, what stands in columns of its own kept by the line."""
    paragraphs = []
    for paragraph in re.split(r"\n\s*\n", inspect.cleandoc(text)):
        parts = re.split(r"\n(?=\w+(?:, \w+)*: |\w+ \(\w+\), )", paragraph)  # one line begins what each name means
        paragraphs += [re.sub(r"\s+", " ", part).replace("*", r"\*") for part in parts]
    return "\n\n".join(
        textwrap.fill(part, WIDTH, initial_indent=indent, subsequent_indent=indent) for part in paragraphs
    )


def documented(name: str, value: Any, level: str) -> str:
    """Heading, docstring and ledger rows of one function."""
    text = inspect.cleandoc(value.__doc__ or "")
    rows = ROW.search(text)
    described = prose(ROW.sub("", text).strip())
    if rows:
        described += "\n\nDerived in " + " and ".join(f"`{row}`" for row in rows[1].split(", ")) + "."
    return f"{level} `{signature(name, value)}`\n\n{described}\n"


def page() -> str:
    """The whole page."""
    parts = [HEAD]
    for module in MODULES:
        name = module.__name__.rsplit(".", 1)[1]
        parts.append(f"## {name}\n\n{prose(module.__doc__ or '')}\n")
        if constants(module):
            lines = [f"| `{key}` | {one.meaning} | {number(one)} | {one.unit} |" for key, one in constants(module)]
            parts.append("\n".join(["| constant | meaning | value | unit |", "|---|---|---|---|", *lines]) + "\n")
        for key, value in public(module):
            parts.append(documented(key, value, "###"))
            if inspect.isclass(value):
                own = [(k, v) for k, v in vars(value).items() if inspect.isfunction(v) and not k.startswith("_")]
                parts += [documented(f"{key}.{k}", v, "####") for k, v in own]
    return "\n".join(parts)


if __name__ == "__main__":
    print(page(), end="")
