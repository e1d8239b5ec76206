"""The figures of a study, as the command line draws them."""

from boresight.studies.figures import Sheets


def drawn(study, result, folder, svg=False):
    """The files that the study's figures are written to."""
    sheets = Sheets(folder, "made from what the test says", svg)
    study.figures(result, sheets)
    return sheets.written
