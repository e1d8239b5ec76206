"""No call, hostile or not, breaks the sentence of a filter's header; and what would break it is seen."""

import shutil

import pytest
from committed import committed, folder_of

from boresight.codegen.folder import folders
from boresight.evidence.attack import FORMS, SANITIZERS, attacked, calls_h, driver, functions
from boresight.evidence.targets import HARNESS
from boresight.runtime.compiler import PRECISIONS, run

FILTERS = [folder.name for folder in folders() if folder.manifest.get("filter")]
FEW = {"joseph": 300_000, "sanitized": 50_000}  # a null pointer to init comes up once in some 60 000 calls
TREASONS = (
    "correct: a null pointer is taken",
    "correct: OK, and nav is not finite",
    "correct: OK, and nav is out of its box",
    "correct: OK, and x is not finite",
    "correct: OK, and P is not finite",
    "correct: OK, and a variance is negative",
    "correct: refused, and nav is written",
    "correct: refused, and x is written",
    "correct: refused, and P is written",
    "correct: a status that there is not",
    "covariance: OK, and an output is not finite",
    "measure_euler: refused, and the innovation is written",
)


@pytest.mark.parametrize("name", FILTERS)
def test_no_call_of_the_committed_attack_breaks_the_sentence(name):
    found = committed(name, "attack")
    assert set(found) == {f"{p} {form}{part}" for p in PRECISIONS for form in FORMS for part in ("", " sanitized")}
    assert {build: of["breaks"] for build, of in found.items() if of["breaks"]} == {}
    assert {build: of["spoilt"] for build, of in found.items() if of["spoilt"]} == {}


def test_the_committed_attack_is_of_a_hundred_million_calls():
    assert sum(of["calls"] for name in FILTERS for of in committed(name, "attack").values()) >= 100_000_000


@pytest.fixture(scope="module")
def joseph(tmp_path_factory):
    return driver(folder_of("euler_matching"), "double", "Joseph", tmp_path_factory.mktemp("joseph"), ("-O0",))


@pytest.fixture(scope="module")
def sanitized(tmp_path_factory):
    out = tmp_path_factory.mktemp("sanitized")
    return driver(folder_of("euler_matching"), "float", "UD", out, (*SANITIZERS, "-O0"))


@pytest.mark.parametrize("build", FEW)
def test_a_live_attack_breaks_nothing(build, request):
    """Both precisions and both forms; all eight builds, at -O2, are those of the committed attack."""
    of = attacked(request.getfixturevalue(build), FEW[build])
    assert (of["breaks"], of["spoilt"]) == ({}, {})
    assert of["answers"]["0"] > FEW[build] / 2


def test_an_attack_is_repeated_by_its_seed(joseph):
    assert attacked(joseph, 5000, 1) == attacked(joseph, 5000, 1) != attacked(joseph, 5000, 2)


@pytest.fixture(scope="module")
def traitors(joseph, tmp_path_factory):
    """The attack's objects, of which three functions of the filter are called sound."""
    out = tmp_path_factory.mktemp("traitors")
    for path in joseph.parent.glob("*.o"):
        shutil.copy(path, out)
    betrayed = ("correct", "covariance", "measure_euler")
    run(["objcopy", *(f"--redefine-sym=em_filter_{name}=sound_{name}" for name in betrayed), out / "em_filter.o"])
    return out


@pytest.mark.parametrize("treason", range(len(TREASONS)), ids=TREASONS)
def test_each_break_of_the_sentence_is_seen(treason, traitors, tmp_path):
    include = folder_of("euler_matching").include
    flags = ("-std=c99", "-O0", "-DBORESIGHT_UD=0", f"-DTRAITOR={treason}", "-I", include)
    run(["gcc", *flags, HARNESS / "traitor.c", *traitors.glob("*.o"), "-lm", "-o", tmp_path / "attack"])
    assert TREASONS[treason] in attacked(tmp_path / "attack", 60_000)["breaks"]


@pytest.mark.parametrize("name", FILTERS)
def test_every_function_of_the_header_is_called(name):
    text, listed = calls_h(folder_of(name)), functions(folder_of(name))
    called = [function for function in listed if f"return {function.symbol}(" in text]
    assert called == listed
    measurements = folder_of(name).manifest["measurements"]
    assert {"init", "propagate", *(f"measure_{one}" for one in measurements)} <= {one.name for one in listed}
