"""What a change of an exported folder costs, as a page for a change request."""

import hashlib
import json
import re
import shutil

import pytest
from committed import folder_of

from boresight import BoresightError, export, load
from boresight.codegen.folder import Folder
from boresight.evidence.against import against, counted, structs
from boresight.evidence.targets import GCC


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """psi-error as it is; and before, with a table of 64 numbers in one of its units."""
    place = tmp_path_factory.mktemp("against")
    export("psi-error", place / "new")
    shutil.copytree(place / "new", place / "old")
    unit = place / "old" / "src" / "psi_F.c"
    unit.write_text(unit.read_text() + "\nextern const double psi_table[64];\nconst double psi_table[64] = { 1.0 };\n")
    results = place / "old" / "evidence.json"
    counts = json.loads(results.read_text())
    of_unit = counts["evidence"]["golden"]["units"]["psi_F"]
    of_unit["operations"] += 5
    of_unit["cost"]["psi_F"]["cortex-m7 double"][0] += 9
    results.write_text(json.dumps(counts))
    manifest = place / "old" / "manifest.json"
    kept = json.loads(manifest.read_text())
    for path in (unit, results):
        kept["files"][str(path.relative_to(place / "old"))] = hashlib.sha256(path.read_bytes()).hexdigest()
    manifest.write_text(json.dumps(kept))
    return place / "old", place / "new"


def test_flash_and_stack_that_differ_are_named_with_what_they_were(folders):
    page = against(*folders, GCC)
    row = next(line for line in page.partition("flash of")[2].splitlines() if line.startswith("| psi_F |"))
    before, after, change = (cell.strip() for cell in row.split("|")[2:5])
    assert int(before) - int(after) == 512 and change == "-512"
    assert "No stack of a function changes." in page and "No flash" in against(folders[1], folders[1], GCC)


def test_operations_and_instructions_are_those_of_the_evidence_and_ram_that_of_the_structs(folders, tmp_path):
    page = against(*folders, GCC)
    assert re.search(r"\| operations of .*\n.*\n\| psi_F \| (\d+) \| (\d+) \| -5 \|", page)
    assert "Instructions or operations are not in the evidence of both" in page  # this machine's are not counted
    old, new = (counted(Folder(folder), "cortex-m7 double")[0]["psi_F"] for folder in folders)
    assert old == new + 9 > 100
    filter_size = load("euler-matching").dll.em_filter_size
    assert structs(folder_of("euler_matching"), GCC, "double", tmp_path)["em_filter"] == filter_size()


def test_what_cannot_be_compared_is_one_line(folders, tmp_path):
    with pytest.raises(BoresightError, match=r"is no exported folder: it has no manifest\.json"):
        against(tmp_path, folders[1])
    export("phi-error", tmp_path / "phi")
    with pytest.raises(BoresightError, match=r"is of another model than .*, phi-error and not psi-error"):
        against(tmp_path / "phi", folders[1])
