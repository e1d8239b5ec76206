"""Generated C as it is read: its width, its tables, what its comments name."""

import re

import pytest
from conftest import ROOT

from boresight.codegen.folder import Folder
from boresight.codegen.functions.units import units
from boresight.codegen.generate import load_model
from boresight.codegen.text import files
from boresight.codegen.text.layout import WIDTH, laid_out
from boresight.codegen.text.statements import LONGEST, SHORTEST
from boresight.codegen.text.views import view
from boresight.evidence.trace import STATEMENT, single

FOLDERS = [Folder(path.parent) for path in sorted((ROOT / "generated").glob("*/manifest.json"))]
PRINTED = [unit for folder in FOLDERS for unit in folder.units if unit.described is not None]
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
TABLE = re.compile(r"static const bs_real (\w+)\[\d+\] = (\{[^}]*\});")
OUTPUT = re.compile(r"^    (\w+)_nz\[(\d+)\] = .*; /\* (.*) \*/$", re.MULTILINE)
PLACES = re.compile(r"at_(\w+)\[\d+\] = \{([^}]*)\};")


def kernel(unit):
    return unit.path.with_name(f"{unit.name}_kernel.h").read_text()


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_no_line_ends_beyond_the_width_but_rows_of_numbers(folder):
    texts = [path for path in folder.manifest["files"] if path.endswith((".h", ".c")) and "_casadi.c" not in path]
    assert any(path.startswith("include/") for path in texts)
    for path in texts:
        for number, line in enumerate((folder.path / path).read_text().splitlines(), 1):
            row = not path.startswith("include/") and re.fullmatch(r"    \{ [-+\w., ]* \},?", line)
            assert len(line) <= WIDTH or row, f"{path}:{number} has {len(line)} columns"


def words(text):
    """Code without white space and with strings in one, and the words of all comments, wherever they stand."""
    inside = " ".join(
        re.sub(r"^ *\*(?!/)", " ", comment[2:-2], flags=re.MULTILINE) for comment in COMMENT.findall(text)
    )
    return "".join(COMMENT.sub("", text).split()).replace('""', ""), sorted(inside.split())


def test_layout_changes_nothing_but_white_space(monkeypatch):
    model = load_model("euler-matching")
    made = units(model)
    views = [view(model, unit) for unit in made]

    def texts():
        found = files.model_files(model, made, views) | files.detector_files()[1]
        for unit, u in zip(made, views, strict=True):
            found |= files.unit_files(model, unit, u)
        shown = {path: text for path, text in found.items() if re.search(r"(?<!_casadi)\.[ch]$", path)}
        # a hash is one of white space too
        return {path: re.sub('"[0-9a-f]{64}"', '""', text) for path, text in shown.items()}

    after = texts()
    monkeypatch.setattr(files, "laid_out", lambda text: text)
    before = texts()
    assert sum(text != after[path] for path, text in before.items()) > 20
    for path, text in before.items():
        assert words(text) == words(after[path]), path
        assert laid_out(after[path]) == after[path], path


@pytest.mark.parametrize(
    ("line", "word"),
    [
        ("bs_status va_euler_z(" + ", ".join(f"const bs_real {c * 20}[3]" for c in "abcd") + ");", "const"),
        ("    if (" + " || ".join(f"({c * 20} == NULL)" for c in "abcd") + ") {", r"\(a"),
        ("    (void)printf(" + f'"{"a, b || " * 8}", {"c" * 20}, {"d" * 20});', '"a'),
        (" * in   a->b  " + "word " * 30 + "end", "word"),
        ("    bs_real a;  /* " + "word " * 30 + "*/", "word"),
    ],
)
def test_a_long_line_goes_on_below_where_it_began(line, word):
    first, *more = laid_out(line).split("\n")
    assert [word for part in (first, *more) for word in part.lstrip(" *").split()] == line.lstrip(" *").split()
    assert max(len(part) for part in (first, *more)) <= WIDTH
    assert {len(part) - len(part.lstrip(" *")) for part in more} == {re.search(word, line).start()}


def test_a_string_that_does_not_fit_becomes_two():
    line = f'        selftest_print("{"words " * 16}end\\n", last);'
    lines = laid_out(line).split("\n")
    assert len(lines) == 2 and max(map(len, lines)) <= WIDTH
    assert "".join(part.strip() for part in lines).replace('""', "") == line.strip()
    assert lines[0].index('"') == lines[1].index('"')


@pytest.mark.parametrize("whole", ["z = H x + noise,", "H = d z / d x;", "C_hat = (I - [e x]) C_b2n", "-1 to 1 */"])
def test_a_formula_and_the_end_of_a_comment_are_not_torn(whole):
    for before in range(WIDTH - len(whole) - 10, WIDTH):
        lines = laid_out(f"/* {'a' * before} with {whole}" + " word." * (not whole.endswith("*/"))).split("\n")
        assert sum(whole in line for line in lines) == 1, lines


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_equal_tables_of_numbers_stand_once_in_a_file(folder):
    for unit in folder.units:
        tables = TABLE.findall(COMMENT.sub("", unit.path.read_text()))
        contents = ["".join(values.split()) for _, values in tables]
        assert len(contents) == len(set(contents)), f"{unit.name}: {[name for name, _ in tables]}"


def test_no_function_of_a_kernel_is_longer_than_the_longest():
    split = 0
    for unit in PRINTED:
        bodies = re.findall(r"^\{\n(.*?)^\}$", kernel(unit), re.MULTILINE | re.DOTALL)
        counts = [sum(STATEMENT.match(line) is not None for line in single(body)) for body in bodies]
        assert sum(counts) == unit.operations
        assert max(counts) <= LONGEST, unit.name
        assert len(bodies) == 1 or min(counts[:-1]) >= SHORTEST, unit.name
        assert (len(bodies) > 1) == (unit.operations > LONGEST), unit.name
        split += len(bodies) > 1
    assert split > 10


@pytest.mark.parametrize("folder", [folder for folder in FOLDERS if "states" in folder.manifest], ids=lambda f: f.name)
def test_each_entry_is_named_by_its_row_and_column(folder):
    states, measured = folder.manifest["states"], folder.manifest["measurements"]
    for unit in folder.units:
        name = unit.described["name"] if unit.described else ""
        rows = states if name in ("F", "Phi", "Qc", "Q") else measured.get(name[:-2], {}).get("rows")
        if name[-2:] != "_H" and rows is not states:
            continue
        (_, places), *_ = PLACES.findall(unit.test.read_text())
        named = [comment for _, _, comment in sorted(OUTPUT.findall(kernel(unit)), key=lambda found: int(found[1]))]
        at = [divmod(int(place), len(states)) for place in places.split(",")]
        assert named == [f"{rows[i]}, {states[j]}" for i, j in at], unit.name


def test_each_file_cites_its_equations():
    cited = 0
    for unit in PRINTED:
        for text in (unit.path.read_text(), kernel(unit)):
            head = " ".join(COMMENT.search(text)[0].replace("\n *", " ").split())
            assert all(equation in head for equation in unit.described["equations"]), unit.name
        cited += bool(unit.described["equations"])
    assert cited > 20
