"""What a change of an exported folder costs, as a page for a change request."""

import hashlib
import json
import shutil

import pytest

from boresight import BoresightError, export
from boresight.evidence.against import against
from boresight.evidence.targets import GCC


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """psi-error as it is; and before, with a table of 64 numbers in one of its units."""
    place = tmp_path_factory.mktemp("against")
    export("psi-error", place / "new")
    shutil.copytree(place / "new", place / "old")
    unit = place / "old" / "src" / "psi_F.c"
    unit.write_text(unit.read_text() + "\nextern const double psi_table[64];\nconst double psi_table[64] = { 1.0 };\n")
    manifest = place / "old" / "manifest.json"
    kept = json.loads(manifest.read_text())
    kept["files"]["src/psi_F.c"] = hashlib.sha256(unit.read_bytes()).hexdigest()
    manifest.write_text(json.dumps(kept))
    return place / "old", place / "new"


def test_flash_and_stack_that_differ_are_named_with_what_they_were(folders):
    page = against(*folders, GCC)
    (row,) = [line for line in page.splitlines() if line.startswith("| psi_F |")]
    before, after, change = (cell.strip() for cell in row.split("|")[2:5])
    assert int(before) - int(after) == 512 and change == "-512"
    assert "No stack of a function changes." in page and "No flash" in against(folders[1], folders[1], GCC)


def test_what_cannot_be_compared_is_one_line(folders, tmp_path):
    with pytest.raises(BoresightError, match=r"is no exported folder: it has no manifest\.json"):
        against(tmp_path, folders[1])
    export("phi-error", tmp_path / "phi")
    with pytest.raises(BoresightError, match=r"is of another model than .*, phi-error and not psi-error"):
        against(tmp_path / "phi", folders[1])
