"""The studies that there are: each is imported when it is asked for, so that a list of them costs nothing."""

from boresight import BoresightError
from boresight.studies.study import Study

STUDIES = {
    "euler-table": "Table 1 of Song and Lee (2001), by covariance and by Monte Carlo.",
    "euler-exploration": "What decides that table, and whether its filter is consistent.",
    "azimuth-hold": "Kim (2018): an hour at rest after a transfer alignment, four ways.",
    "azimuth-shock": "The hold disturbed: what the detector and the gate notice.",
    "azimuth-exploration": "What decides the hold's covariance.",
    "sea-state": "Kang and others (2025): transfer alignment in sea states 1 to 6.",
    "sea-claims": "What the claims of that paper depend on, one change at a time.",
    "sea-exploration": "Which motions show which errors; how far a heading may be off.",
    "float-covariance": "What single precision does to a covariance.",
}


def study(name: str) -> Study:
    """The study of that name.  Raises BoresightError for a name that none has."""
    if name == "euler-table":
        from boresight.studies.euler_table.table import STUDY
    elif name == "euler-exploration":
        from boresight.studies.euler_table.exploration import STUDY
    elif name == "azimuth-hold":
        from boresight.studies.azimuth_hold.hold import STUDY
    elif name == "azimuth-shock":
        from boresight.studies.azimuth_hold.shock import STUDY
    elif name == "azimuth-exploration":
        from boresight.studies.azimuth_hold.exploration import STUDY
    elif name == "sea-state":
        from boresight.studies.sea_state.experiment import STUDY
    elif name == "sea-claims":
        from boresight.studies.sea_state.claims import STUDY
    elif name == "sea-exploration":
        from boresight.studies.sea_state.exploration import STUDY
    elif name == "float-covariance":
        from boresight.studies.float_covariance.covariance import STUDY
    else:
        raise BoresightError(f"no study {name!r}; there are {', '.join(STUDIES)}")
    return STUDY
