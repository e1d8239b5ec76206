"""Each plain filter's text for a GPU: what NVRTC made of it is committed, and by g++ it has the bits of scalar C."""

import numpy as np
import pytest
from committed import NAMES, committed, folder_of
from tools import needs

from benchmarks.gpu import by_host
from boresight.evidence.gpu import ARCHITECTURES, run_of
from boresight.runtime.compiler import PRECISIONS
from boresight.runtime.gpu import text

FILTERS = [name for name in NAMES if folder_of(name).manifest.get("filter")]


@pytest.mark.parametrize("name", FILTERS)
def test_each_operation_of_the_committed_text_rounds_once(name):
    found = committed(name, "gpu")
    assert set(found) == {f"{precision} {of}" for precision in PRECISIONS for of in ARCHITECTURES}
    for build, of in found.items():
        assert of["faults"] == [] and of["bytes"] > 0, build
        assert all(".rn." in operation for operation in of["operations"])
        assert {operation.split(".")[0] for operation in of["operations"]} >= {"add", "sub", "mul", "div", "sqrt"}


@needs("g++")
@pytest.mark.digits
@pytest.mark.parametrize("precision", ["double"])
def test_by_g_plus_plus_it_has_the_bits_of_scalar_c(precision, tmp_path):
    """Of the smallest filter; of all of them, in both precisions: `python -m benchmarks.gpu --texts`."""
    folder, file = folder_of("euler_matching"), tmp_path / "run.c"
    run = run_of(folder, cycles=5, samples=20)
    file.write_text(run.source)
    apart = text.fly(text.host(folder.path, file, precision), run.given, 3, range(200), run.columns)
    whole = text.fly(
        by_host(text.device(folder.path, file, precision), tmp_path), run.given, 3, range(200), run.columns
    )
    for one, other in zip(whole, apart, strict=True):
        np.testing.assert_array_equal(one, other)
    rows, status = apart
    assert not status.any() and not rows[:, -1].any()  # no call was refused
    assert len(np.unique(rows, axis=0)) == 200
