"""The public names: one table, its stub, what `import boresight` costs, and that nobody needs to go deeper.

python tests/test_front_door.py writes boresight/__init__.pyi anew.
"""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

import boresight
from boresight import BoresightError

ROOT = Path(__file__).parent.parent
STUB = ROOT / "boresight" / "__init__.pyi"
MODULES = sorted(name for name, place in boresight.PUBLIC.items() if ":" not in place)
GATHERED = ("mechanics", "models", "simulation")  # modules of this place, from which a name can be imported as well
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
BESIDE = (
    "docs/decisions",  # what was tried, with the means of its time
    "examples/flight/ticks.py",  # counts instructions on an emulated target, by boresight.evidence
)


def stub():
    """What `__init__.pyi` holds, from the table."""
    lines = []
    for name, place in boresight.PUBLIC.items():
        module, _, own = place.partition(":")
        package, last = (module, own) if own else module.rsplit(".", 1)
        order = package, not last.isupper(), last.islower(), last  # as ruff sorts them
        lines.append((order, f"from {package} import {last} as {name}"))
    lines = [line for _, line in sorted(lines)]
    head = "# Made from the table in __init__.py by tests/test_front_door.py."
    return "\n".join([head, *lines, "", "__version__: str", "PUBLIC: dict[str, str]\n"])


def test_the_stub_repeats_the_table():
    assert STUB.read_text() == stub(), "run python tests/test_front_door.py"


def test_dir_and_all_are_the_table_and_each_name_is_there():
    assert dir(boresight) == sorted(boresight.PUBLIC) and boresight.__all__ == list(boresight.PUBLIC)
    assert 30 <= len(boresight.PUBLIC) <= 47
    for name in boresight.PUBLIC:
        assert getattr(boresight, name) is not None, name
    names: dict = {}
    exec("from boresight import *", names)
    assert set(boresight.PUBLIC) <= set(names)


def test_the_docstring_names_each_of_them():
    assert set(boresight.PUBLIC) <= set(re.findall(r"`(\w+)`", boresight.__doc__))


def test_a_name_that_is_not_there_is_an_attribute_error_and_a_submodule_is_found():
    with pytest.raises(AttributeError, match="no attribute 'Modl'"):
        boresight.Modl  # noqa: B018
    with pytest.raises(ImportError, match="cannot import name 'Modl'"):
        from boresight import Modl  # noqa: F401
    from boresight import cli

    assert cli.__name__ == "boresight.cli"


def test_import_boresight_loads_no_package_and_takes_less_than_20_ms():
    code = (
        "import sys, time\nbegin = time.process_time()\nimport boresight\nprint(time.process_time() - begin)\n"
        "print(*sorted({name.split('.')[0] for name in sys.modules} - set(sys.stdlib_module_names)))\n"
        "from boresight import rotation, load\nprint('sympy' in sys.modules)"
    )
    runs = [
        subprocess.run([sys.executable, "-S", "-c", code], env={"PYTHONPATH": path()}, capture_output=True, text=True)
        for _ in range(3)
    ]
    assert not any(run.stderr for run in runs), runs[0].stderr
    (took, loaded, heavy), *others = [run.stdout.splitlines() for run in runs]
    assert loaded == "__main__ boresight" and heavy == "False"
    assert min(float(took), *(float(other[0]) for other in others)) < 0.020


def path():
    """Where this Python finds the checkout and what is installed; -S leaves out what an installation runs at start."""
    return ":".join([str(ROOT), *filter(None, sys.path)])


def test_the_gathered_mechanics_are_all_that_the_reference_page_lists():
    page = (ROOT / "docs" / "reference" / "mechanics.md").read_text()
    listed = set(re.findall(r"^### `(\w+)\(", page, re.MULTILINE)) | set(re.findall(r"^\| `(\w+)` \|", page, re.M))
    assert listed - set(boresight.mechanics.__all__) == set()
    assert set(boresight.mechanics.__all__) - listed <= {"NED", "ENU", "FRAMES", "Frame"}


# ---------------------------------------------------------------- nobody needs to go deeper


def deep(code, where):
    """What the code imports of Boresight that is not public."""
    found = []
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
            found += [name for name in names if name.startswith("boresight.")]
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "boresight":
            parts = node.module.split(".")[1:]
            names = [alias.name for alias in node.names]
            if not parts:
                found += [f"boresight.{name}" for name in names if name not in boresight.PUBLIC]
            elif parts[0] in GATHERED and len(parts) == 1:
                known = getattr(boresight, parts[0]).__all__
                found += [f"boresight.{parts[0]}.{name}" for name in names if name not in known]
            else:
                found.append(node.module)
    return [f"{where}: {name}" for name in found]


def blocks(page):
    """The Python of a page."""
    return re.findall(r"^```python(?: \S+)?\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)


def beside(path):
    return path.relative_to(ROOT).as_posix().startswith(BESIDE)


def test_pages_and_examples_import_public_names_alone():
    examples = sorted((ROOT / "examples").rglob("*.py"))
    pages = [page for page in PAGES if not beside(page)]
    assert sum(len(blocks(page)) for page in pages) > 15 and len(examples) > 10
    found = [one for page in pages for block in blocks(page) for one in deep(block, page.name)]
    found += [one for path in examples if not beside(path) for one in deep(path.read_text(), path.name)]
    # a witness of one's own is written in the terms of those that come with Boresight
    witness = {f"your-paper.md: boresight.derive.ledger.{name}" for name in ("numbers", "paper", "witness")}
    assert not set(found) - witness, "\n".join(found)


@pytest.mark.parametrize(
    ("code", "refused"),
    [
        ("from boresight import Model, rotation", False),
        ("from boresight.mechanics import skew", False),
        ("from boresight.simulation import sensors", False),
        ("from boresight.derive.model import Model", True),
        ("import boresight.runtime.library", True),
        ("from boresight import report", True),
        ("from boresight.mechanics import Matrix", True),
    ],
)
def test_a_deep_import_is_seen(code, refused):
    assert bool(deep(code, "here")) is refused


def test_the_error_is_one_class_by_its_public_name():
    assert f"{BoresightError.__module__}.{BoresightError.__qualname__}" == "boresight.BoresightError"


if __name__ == "__main__":
    STUB.write_text(stub())
