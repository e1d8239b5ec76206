"""What Boresight and its peers answer to one question, and who is right; `make cross-checks` asks the peers."""

import dataclasses

import numpy as np
import pytest
from mpmath import mp

from boresight.evidence import results
from boresight.evidence.crossed import PEERS, exact, table
from boresight.evidence.crossed.judge import NEITHER, OURS, ROUNDING, THEIRS, Check, Numbers, verdict
from boresight.evidence.sources import CrossChecks


@pytest.mark.parametrize("peer", PEERS, ids=lambda peer: peer.name)
def test_each_committed_verdict_is_the_one_that_its_reason_explains(peer):
    kept = results.read(CrossChecks())[peer.name]["units"]
    assert kept.keys() == {check.name for check in peer.checks}
    assert not [problem for check in peer.checks if (problem := check.problem(kept[check.name]))]


def test_the_page_shows_what_is_committed():
    text = table.PAGE.read_text()
    assert table.page(text) == text, "run 'make cross-checks'"


def test_the_50_digits_say_who_is_right():
    def of(ours, peer):
        return verdict({"ours": ours, "peer": peer, "allowed": 1e-15})

    assert (of(1e-16, 1e-15), of(1e-16, 1e-9), of(1e-9, 1e-16)) == (ROUNDING, OURS, THEIRS)
    assert (of(1e-12, 1e-11), of(1e-12, 9e-12), of(np.nan, 1e-16), of(1e-16, np.nan)) == (OURS, NEITHER, THEIRS, OURS)
    assert of(np.nan, np.nan) == NEITHER


def test_a_check_fails_on_an_answer_that_is_wrong_and_on_a_reason_that_is_none():
    third = mp.mpf(1) / 3

    def asked(ours, peer, **more):
        return Check("third", "1", lambda: Numbers(ours, peer, third, 1.0, 1), (), **more).made()

    assert asked(1 / 3, 1 / 3)["apart"] == 0
    for numbers in ((1 / 3 + 1e-12, 1 / 3), (1 / 3, 1 / 3 + 1e-12), (np.nan, 1 / 3)):
        with pytest.raises(AssertionError, match=r"third: .* is right, not rounding"):
            asked(*numbers)
    asked(1 / 3, 1 / 3 + 1e-12, wanted=OURS, why="it adds a little")
    with pytest.raises(AssertionError, match="rounding is right, not ours"):
        asked(1 / 3, 1 / 3, wanted=OURS, why="it adds a little")
    with pytest.raises(AssertionError, match="needs a reason"):
        asked(1 / 3, 1 / 3 + 1e-12, wanted=OURS)
    with pytest.raises(ValueError, match="answers of 2, 1 and 1 numbers"):
        asked([1 / 3, 0], 1 / 3)


def test_another_version_and_another_check_make_a_result_stale(tmp_path):
    """And another C of the model: its hash stands in the sources."""
    peer = PEERS[0]
    before = peer.hashes(CrossChecks())
    other = tmp_path / "by.py"
    other.write_text("# nothing\n")
    assert not set(dataclasses.replace(peer, file=str(other)).hashes(CrossChecks()).values()) & set(before.values())
    moved = dataclasses.replace(peer.checks[0], of=("velocity_dcm",))
    assert dataclasses.replace(peer, checks=(moved,)).hashes(CrossChecks())[moved.name] != before[moved.name]
    assert dataclasses.replace(peer, name="numpy").tools != peer.tools


def test_the_witness_turns_and_navigates():
    """At rest on the turning Earth nothing moves: the specific force holds gravity, the rate is the Earth's."""
    with mp.workdps(30):
        lat = mp.mpf("0.6")
        begin = [mp.mpf(2), lat, mp.mpf(0), 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]
        end = exact.navigated(begin, exact.earth_rate(lat), [0, 0, exact.somigliana(lat)], 1, columns=4, steps=1)
        assert max(abs(a - b) for a, b in zip(begin, end, strict=True)) < mp.mpf(10) ** -25
        turn = exact.rotation(mp.matrix([0, 0, mp.pi / 2]))
        assert mp.mnorm(turn - mp.matrix([[0, -1, 0], [1, 0, 0], [0, 0, 1]])) < mp.mpf(10) ** -28
