"""What is committed was computed from the C and the derivations that are committed, unit by unit."""

from pathlib import Path

import pytest
from committed import folder_of

from boresight.codegen.folder import Folder
from boresight.derive import models
from boresight.evidence import kind as of_kind
from boresight.evidence import results
from boresight.evidence.kind import KINDS, kinds_for, of_another_text
from boresight.evidence.kinds import all_kinds, still_open
from boresight.evidence.sources import Derivations

PAIRS = [(kind, subject) for kind, subject in all_kinds() if kind.name not in ("flown", "tried")]  # of these: elsewhere
ALL = {subject.name: [kind for kind, other in PAIRS if other.name == subject.name] for _, subject in PAIRS}
SUBJECTS = {subject.name: subject for _, subject in PAIRS}


def test_what_is_of_another_text_than_the_sources_here_is_listed_and_nothing_else():
    """`make evidence` makes it, and the list shorter; results that are not listed are of what is committed."""
    assert still_open() == results.OPEN.read_text().splitlines(), "run 'make evidence'"


@pytest.mark.parametrize("name", ALL)
def test_no_result_is_kept_of_a_unit_that_is_gone(name):
    kept, subject = results.read(SUBJECTS[name]), SUBJECTS[name]
    for kind in ALL[name]:
        of, now = kept.get(kind.name, {}), kind.hashes(subject)
        listed = of_another_text(subject, kind)
        assert of.get("sources", {}).keys() <= now.keys() or listed, kind.name
        if isinstance(subject, Folder) and not listed:
            assert of.get("folder") == subject.hash, f"{kind.name}: run 'make evidence'"


def test_no_result_is_of_a_folder_or_a_paper_that_is_gone():
    assert {path.stem for path in results.PLACE.glob("*.json")} <= {subject.name for _, subject in all_kinds()}


def vouched(path):
    """The copied folder of Euler matching, whose manifest lists what lies there now."""
    folder, manifest = Folder(path), dict(folder_of("euler_matching").manifest)
    here = (file.relative_to(path).as_posix() for file in path.rglob("*.*") if file.suffix in (".c", ".h", ".inc"))
    folder.__dict__["manifest"] = manifest | {"files": dict.fromkeys(here, "")}
    return folder


def changed(folder):
    """By kind the units whose results would be stale."""
    before = folder_of("euler_matching")
    assert kinds_for(folder) == kinds_for(before)
    found = {}
    for kind in kinds_for(folder):
        was, now = kind.hashes(before), kind.hashes(folder)
        if was != {name.replace(folder.name, before.name): digest for name, digest in now.items()}:
            found[kind.name] = {name for name in now if was.get(name) != now[name]}
    return found


def test_a_changed_statement_makes_its_unit_stale_and_what_includes_it(em_copy):
    assert changed(vouched(em_copy)) == {}
    kernel = em_copy / "src" / "em_F_kernel.h"
    kernel.write_text(kernel.read_text().replace("-omega_in_n[1]", "omega_in_n[1]"))
    found = changed(vouched(em_copy))
    of_c = {kind.name for kind in KINDS} - {"bits"}
    assert of_c == found.keys()
    assert found["rounding"] == found["eva"] == found["trace"] == {"em_F"}
    assert found["golden"] == found["guards"] == found["mutants"] == {"em_F", "em_filter", "em_live"}


@pytest.mark.parametrize(
    ("path", "old", "new", "stale"),
    [
        # of a self-test: what runs it alone
        ("selftest/test_em_F.c", "#define N_VECTORS", "#define MORE 1\n#define N_VECTORS", {"em_F"}),
        # of what another unit calls
        ("src/em_math.c", "bs_sincos", "bs_cossin", None),
        # a declaration that nothing names, and words
        ("include/euler_matching.h", "\n#endif\n", "\n#define EM_OF_NOBODY 1\n/* words */\n#endif\n", set()),
        # words in its own files, and an annotation for a prover
        ("src/em_F.c", "#include", "/* words */\n#include", set()),
        ("src/em_F.c", "#include", "/*@ admit 0 <= 1; */\n#include", {"em_F", "em_filter"}),
    ],
)
def test_a_unit_is_stale_by_what_it_names(em_copy, path, old, new, stale):
    text = (em_copy / path).read_text()
    assert old in text
    (em_copy / path).write_text(new.join(text.rsplit(old, 1)))
    folder, before = vouched(em_copy), folder_of("euler_matching")
    was, now = of_kind.tested(before), of_kind.tested(folder)
    found = {name for name in now if was[name] != now[name]}
    if stale is None:
        assert {"em_euler_H", "em_math", "em_filter"} <= found and not {"em_F", "em_covariance"} & found
    else:
        assert found == stale
    assert (of_kind.printed(folder) == of_kind.printed(before)) == (path.startswith("selftest/") or stale == set())


def test_one_more_measurement_is_one_more_result(em_copy):
    """As an odometer: the header declares it, the self-test calls it, the filter includes it."""
    for path, old, new in (
        (
            "include/euler_matching.h",
            "bs_status em_F(",
            "bs_status em_odometer_z(void);\n\nbs_status em_F(",
        ),
        ("selftest/selftest.h", "int test_em_F(void);", "int test_em_F(void);\nint test_em_odometer_z(void);"),
        ("selftest/selftest.c", "if (test_em_F() == 0) {", "(void)test_em_odometer_z();\n    if (test_em_F() == 0) {"),
        ("src/em_filter.c", '#include "em_F_kernel.h"', '#include "em_F_kernel.h"\n#include "em_odometer_z_kernel.h"'),
    ):
        text = (em_copy / path).read_text()
        assert old in text
        (em_copy / path).write_text(text.replace(old, new, 1))
    for path in ("src/em_F.c", "src/em_F_kernel.h", "selftest/test_em_F.c"):
        text = (em_copy / path).read_text().replace("em_F", "em_odometer_z").replace("EM_F", "EM_ODOMETER_Z")
        (em_copy / path.replace("em_F", "em_odometer_z")).write_text(text)
    found = changed(vouched(em_copy))
    whole, new = {em_copy.name}, {"em_odometer_z"}
    # of a new unit that the manifest does not describe nothing is printed
    assert found == dict.fromkeys(("attack", "misra", "verified", "coverage", "stack", "gpu"), whole) | dict.fromkeys(
        ("golden", "guards", "mutants", "riscv"), new | {"em_filter"}
    )


def test_a_comment_in_a_derivation_makes_nothing_stale(monkeypatch):
    paper, place = Derivations("mechanics"), Path(models.__file__).parent.parent
    before, read = (paper.hash("steps"), Derivations("kang-2025").hash("spoilt")), Path.read_bytes

    def with_comment(path):
        return read(path) + (b"\n# a comment\n" if place in path.parents else b"")

    assert {path.name for path in paper.reached("steps") if path.parent.name == "models"} <= {"__init__.py"}
    monkeypatch.setattr(Path, "read_bytes", with_comment)
    assert (paper.hash("steps"), Derivations("kang-2025").hash("spoilt")) == before
    monkeypatch.setattr(Path, "read_bytes", lambda path: read(path) + b"\nMORE = 1\n")
    assert paper.hash("steps") != before[0]
