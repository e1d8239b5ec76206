"""A box that is chosen for an export: the C refuses and answers by it, and says that it is other C."""

import json

import pytest
from building import run

from boresight import BoresightError, cli
from boresight.codegen.boxes import with_boxes
from boresight.codegen.export import export
from boresight.codegen.generate import load_model

USER = """
#include <stdio.h>
#include "azimuth_hold.h"

int main(void)
{
    static const double v_e[4] = { -51, -49, 59, 61 };
    for (int i = 0; i < 4; ++i) {
        ah_nav nav = { { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
        double z[3];
        nav.v_n[0] = v_e[i];
        printf("%d ", ah_zupt_z(&nav, z));
    }
    return 0;
}
"""


@pytest.fixture(scope="module")
def model():
    return load_model("azimuth-hold")


def boxes_of(model):
    variables = [*model.states, *(field for struct in model.structs for field in struct.fields)]
    return {s.name: (low, high) for v in variables for s, low, high in zip(v.symbols, v.low, v.high, strict=True)}


@pytest.mark.parametrize("box", ["v_e=-50:60", "v_e=-2000:1500", "height=-500:60000", "dt=0.001:0.5"])
def test_a_box_is_narrower_or_wider_and_no_other_changes(model, box):
    name, ends = box.split("=")
    before, after = boxes_of(model), boxes_of(with_boxes(model, (box,)))
    assert after == before | {name: tuple(map(float, ends.split(":")))} != before


@pytest.mark.parametrize(
    ("box", "said"),
    [
        ("v_east=-1:1", "no component 'v_east' .did you mean"),
        ("v_e", "write NAME=LOW:HIGH"),
        ("v_e=1", "write NAME=LOW:HIGH"),
        ("v_e=low:high", "write NAME=LOW:HIGH"),
        ("v_e=2:1", "the lower one below"),
        ("v_e=1:1", "the lower one below"),
        ("v_e=nan:1", "must be finite"),
        ("v_e=-inf:inf", "must be finite"),
        ("dt=0:1", "above 0"),
        ("lat=-2:2", "no value inside the boxes"),
    ],
)
def test_nonsense_is_refused_in_one_line(box, said, tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        cli.main(["export", "azimuth-hold", "-o", str(tmp_path / "out"), "--box", box])
    error = capsys.readouterr().err
    assert ended.value.code == 1 and len(error.splitlines()) == 1 and not (tmp_path / "out").exists()
    with pytest.raises(BoresightError, match=said):
        export("azimuth-hold", tmp_path / "out", "double", boxes=(box,))


def test_the_exported_c_keeps_the_chosen_box_and_has_no_evidence(model, tmp_path):
    export("azimuth-hold", tmp_path / "plain", "double")
    export("azimuth-hold", tmp_path / "boxed", "double", boxes=("v_e=-50:60", "lat=-1.3:1.3"))
    plain, boxed = (json.loads((tmp_path / name / "manifest.json").read_text()) for name in ("plain", "boxed"))
    assert plain["hash"] != boxed["hash"]
    said = json.loads((tmp_path / "boxed" / "evidence.json").read_text())
    assert said["evidence"] == "none" and "v_e=-50:60, lat=-1.3:1.3" in said["why"] and said["hash"] == boxed["hash"]
    done = run("make", "-s", "-C", tmp_path / "boxed", "CFLAGS=-O0", "hash", "test")
    assert done.returncode == 0 and ", 0 failed" in done.stdout
    (tmp_path / "main.c").write_text(USER)
    answers = []
    for name in ("plain", "boxed"):
        sources = (tmp_path / name / "src").glob("*.c")
        command = ["gcc", "-std=c99", "-I", tmp_path / name / "include", tmp_path / "main.c", *sources, "-lm"]
        assert run(*command, "-o", tmp_path / f"{name}.out").returncode == 0
        answers.append(run(tmp_path / f"{name}.out").stdout.split())
    assert answers == [["0", "0", "0", "0"], ["3", "0", "0", "3"]]
