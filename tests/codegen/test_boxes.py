"""A box that is chosen for an export: the C refuses and answers by it, and says that it is other C."""

import json

import pytest
from building import c_files, program, run
from conftest import PENDULUM

from boresight import BoresightError, cli
from boresight.codegen.boxes import with_boxes
from boresight.codegen.export import export
from boresight.codegen.generate import load_model

USER = """
#include <stdio.h>
#include "pendulum_filter.h"

static pd_filter filter;

int main(void)
{
    static const double angle[4] = { -1.1, -0.9, 1.9, 2.1 };
    const bs_real sigma[2] = { 1e-3, 1e-3 };
    for (int i = 0; i < 4; ++i) {
        const pd_plant plant = { { 1.0, 0.1 } }, longer = { { 2.0 + angle[i], 0.1 } };
        const bs_real x[2] = { angle[i], 0.0 }, still[2] = { 0.0, 0.0 };
        double h;
        printf("%d%d%d ", pd_tip_h(x, &plant, &h), pd_tip_h(still, &longer, &h),
               pd_filter_init_sigmas(&filter, x, sigma));
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
        ("angel=-1:1", "no component 'angel' .did you mean"),
        ("rate", "write NAME=LOW:HIGH"),
        ("rate=1", "write NAME=LOW:HIGH"),
        ("rate=low:high", "write NAME=LOW:HIGH"),
        ("rate=2:1", "the lower one below"),
        ("rate=1:1", "the lower one below"),
        ("rate=nan:1", "must be finite"),
        ("rate=-inf:inf", "must be finite"),
        ("dt=0:1", "above 0"),
        ("length=-1:1", "no value inside the boxes"),
    ],
)
def test_nonsense_is_refused_in_one_line(box, said, tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        cli.main(["export", PENDULUM, "-o", str(tmp_path / "out"), "--box", box])
    error = capsys.readouterr().err
    assert ended.value.code == 1 and len(error.splitlines()) == 1 and not (tmp_path / "out").exists()
    with pytest.raises(BoresightError, match=said):
        export(PENDULUM, tmp_path / "out", "double", boxes=(box,))


def test_the_exported_c_keeps_the_chosen_box_and_has_no_evidence(pendulum_folder, tmp_path):
    """A unit and the filter's beginning, by a state and by an input; built-in models are exported by the same lines."""
    export(PENDULUM, tmp_path / "plain", "double", pendulum_folder)
    export(PENDULUM, tmp_path / "boxed", "double", boxes=("angle=-1:2", "length=1:4"))
    plain, boxed = (json.loads((tmp_path / name / "manifest.json").read_text()) for name in ("plain", "boxed"))
    assert plain["hash"] != boxed["hash"]
    said = json.loads((tmp_path / "boxed" / "evidence.json").read_text())
    assert said["evidence"] == "none" and "angle=-1:2, length=1:4" in said["why"] and said["hash"] == boxed["hash"]
    done = run("make", "-s", "-C", tmp_path / "boxed", "CFLAGS=-O0", "hash", "test")
    assert done.returncode == 0 and ", 0 failed" in done.stdout
    answers = []
    for name in ("plain", "boxed"):
        (tmp_path / name / "main.c").write_text(USER)
        sources = [tmp_path / name / "main.c", *c_files(tmp_path / name, "src")]
        answers.append(run(program(tmp_path / name, sources, "-I", tmp_path / name / "include")).stdout.split())
    assert answers == [["000"] * 4, ["333", "000", "000", "333"]]
