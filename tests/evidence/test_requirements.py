"""Each demand of the C has a number, a statement that keeps it and a line that tries it; both ways, without gaps."""

import csv
import re

import pytest
from committed import folder_of
from faults.demanded import Tried, judge
from sympy import Matrix

from boresight import Measurement, Model, Struct, export, generate, variable
from boresight.codegen import requirements
from boresight.codegen.folder import folders


def texts(folder):
    return {path.relative_to(folder.path).as_posix(): path.read_text() for path in folder.sources}


@pytest.mark.parametrize("name", [folder.name for folder in folders()])
def test_each_requirement_is_stated_kept_and_tried_and_each_line_of_the_self_test_names_one(name):
    folder = folder_of(name)
    files = texts(folder)
    found = requirements.requirements(files, folder.manifest)
    assert len(found) > 20 and not requirements.gaps(found)
    assert not requirements.unnumbered(files)
    assert all(one.text for one in found.values())
    assert [number for number, one in found.items() if not one.tried] == ["EM-F-024"] * (name == "euler_matching")


def test_a_number_that_is_taken_out_leaves_a_gap():
    folder = folder_of("euler_matching")
    files = texts(folder)
    places = {
        "include/euler_matching_filter.h": "stated",
        "src/em_filter.c": "kept",
        "selftest/test_em_filter.c": "tried",
    }
    for path, what in places.items():
        less = files | {path: files[path].replace("[EM-F-143]", "")}
        assert less != files
        assert requirements.gaps(requirements.requirements(less, folder.manifest)) == [f"EM-F-143 is not {what}"]
    test = "selftest/test_em_digest.c"
    assert requirements.unnumbered(files | {test: re.sub(r"\[EM-D-\d+\]", "", files[test])})


def line(*measurements, **more):
    place = variable("place", "x", "m", "place on the line", -100.0, 100.0)
    dt = variable("dt", "dt", "s", "length of the step", 1e-3, 1.0)
    walk = variable("walk", "q", "m/sqrt(s)", "noise density of the place", 0.0, 1.0)
    fix = Measurement("fix", ("x",), "m", "the place that is read", h=place.vector)
    twice = Measurement("a_fix_twice", ("x",), "m", "twice the place", h=2 * place.vector)
    return Model(
        name="line-of-numbers", c_prefix="ln", title="a walk on a line, 1 state", frame="none",
        states=(place,), structs=(Struct("step", "one step", (dt, walk)),),
        f=Matrix([0]), G=Matrix([1]), noise=walk.vector, dt=dt.scalar,
        measurements=(twice, fix)[1 - bool(more.get("twice")) :],
    )  # fmt: skip


def test_what_is_added_moves_no_number(tmp_path):
    """A measurement before the one that there was, in name and in place."""
    found = []
    for more in (False, True):
        path = tmp_path / str(more)
        generate(line(twice=more), path)
        files = {p.relative_to(path).as_posix(): p.read_text() for p in path.rglob("*.[ch]")}
        found.append(requirements.requirements(files, {"units": {}, "measurements": {}}))
    before, after = found
    assert before.keys() < after.keys()
    assert {number: one.text for number, one in before.items()}.items() <= {n: o.text for n, o in after.items()}.items()
    assert all("a_fix_twice" in number for number in after.keys() - before.keys())


def test_an_export_traces_both_ways(tmp_path):
    export("strapdown", tmp_path / "out")
    there = list(csv.DictReader((tmp_path / "out" / "trace.csv").open()))
    back = list(csv.DictReader((tmp_path / "out" / "trace-back.csv").open()))
    forth, behind = set(), set()
    for row in there:
        forth |= {(row["requirement"], place) for what in ("kept", "tried") for place in row[what].split("; ") if place}
    for row in back:
        place = f"{row['function']} {row['file']}:{row['line']}".strip()
        behind |= {(number, place) for number in row["requirements"].split("; ")}
    assert forth == behind
    assert all(row["result"] for row in there)
    value = next(row for row in there if row["requirement"] == "SD-U-001.rates")
    assert value["equation"] == "; ".join(folder_of("strapdown").manifest["units"]["rates"]["equations"])
    assert value["tested by"] == "test_sd_rates"
    assert value["result"].startswith("0 failures on ")
    page = (tmp_path / "out" / "EVIDENCE.html").read_text()
    assert all(row["requirement"] in page for row in there)
    # each line that is named has what is told of it
    for number, place in forth:
        path, at = place.split(" ")[-1].rsplit(":", 1)
        lines = (tmp_path / "out" / path).read_text().splitlines()
        near = "\n".join(lines[max(0, int(at) - 4) : int(at)])
        assert f"[{number}]" in near, (number, place)


def test_without_the_code_that_keeps_it_the_line_that_the_trace_names_is_red(tmp_path):
    tried = Tried(folder_of("strapdown"), tmp_path)
    found = requirements.requirements(tried.files, tried.folder.manifest)
    assert not tried.red({})
    for number in ("SD-U-002.step", "SD-U-001.rates"):
        good, line_of_it = judge(tried, found[number])
        assert good, line_of_it
    # and a trace that names another line is not borne out
    wrong = found["SD-U-002.step"]
    wrong.tried = found["SD-U-001.rates"].tried
    assert not judge(tried, wrong)[0]
