"""The live loop in health: it says nothing, and it does where the noise is not what it was told."""

from boresight.runtime.live import Event
from boresight.studies.sea_state import hours, many

WALK = len(many.common(many.Sea())) - 6 * many.DRAWN  # where the sigmas of the samples begin


def test_a_healthy_loop_is_silent_and_a_noisy_one_says_so():
    given = hours.given(0, 300)
    (healthy,) = hours.flown(given, range(1))
    assert healthy[Event.BEGUN] == 1 and not healthy[Event.MESSAGE : hours.TAKEN].any()
    assert healthy[hours.TAKEN] == 2 * 299 and healthy[hours.TAKEN + 1] == 0
    given[WALK : WALK + 6 * many.DRAWN] *= 5.0
    (noisy,) = hours.flown(given, range(1))
    assert noisy[Event.LARGE] > 0
