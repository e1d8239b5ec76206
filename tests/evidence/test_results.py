"""What is committed was computed from the C that is committed."""

import pytest
from committed import NAMES, folder_of

from boresight.evidence import results
from boresight.evidence.kinds import kinds_for, kinds_of
from boresight.evidence.sources import Examples, Flights, derivations


@pytest.mark.parametrize("name", NAMES)
def test_results_are_of_the_committed_sources(name):
    kept, wanted = results.read(folder_of(name)), results.sources_hash(folder_of(name))
    stale = [kind.name for kind in kinds_for(folder_of(name)) if kept.get(kind.name, {}).get("sources") != wanted]
    assert not stale, f"{', '.join(stale)} of {name}: run 'make evidence'"


@pytest.mark.parametrize("paper", derivations(), ids=lambda paper: paper.name)
def test_results_of_a_paper_are_of_the_derivations_here(paper):
    kept, wanted = results.read(paper), results.sources_hash(paper)
    stale = [kind.name for kind in kinds_of(paper) if kept.get(kind.name, {}).get("sources") != wanted]
    assert not stale, f"{', '.join(stale)} of {paper.name}: run 'make evidence'"


def test_no_result_is_of_a_folder_or_a_paper_that_is_gone():
    names = [*NAMES, *(paper.name for paper in derivations()), Examples().name, Flights().name]
    assert {path.stem for path in results.PLACE.glob("*.json")} <= set(names)


def test_a_changed_source_changes_the_hash(em_copy):
    from boresight.evidence.sources import Folder

    before = results.sources_hash(Folder(em_copy))
    assert before == results.sources_hash(folder_of("euler_matching"))
    header = em_copy / "src" / "em_F_kernel.h"
    header.write_text(header.read_text() + "\n")
    folder = Folder(em_copy)
    folder.__dict__["manifest"] = folder_of("euler_matching").manifest
    assert results.sources_hash(folder) != before
