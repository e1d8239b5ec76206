"""The figures of a study, as the command line draws them."""

from pathlib import Path
from unittest.mock import patch

from matplotlib.backends.backend_agg import FigureCanvasAgg

from boresight.analysis.figures import Sheets


def drawn(study, result, folder, svg=False, unprinted="nothing"):
    """The files that the study's figures are written to.

    unprinted: a pattern of names of figures that differ from another one in their numbers alone; they are built, which
    is quick, and their files are empty.
    """
    print_png = FigureCanvasAgg.print_png

    def few(canvas, path, **more):
        if Path(path).match(unprinted):
            Path(path).touch()
        else:
            print_png(canvas, path, **more)

    sheets = Sheets(folder, "made from what the test says", svg)
    with patch.object(FigureCanvasAgg, "print_png", few):
        study.figures(result, sheets)
    return sheets.written
