"""The one look of every figure, and what it was made from at its edge.

Colours are told apart by readers who see two primaries only, and every line has its label beside it or in a legend.
What is ours, estimated or with the remedy is blue; what it is compared with, or without, is orange; axes x, y, z are
AXES, a tool has the colour of TOOLS in every panel.  A label is `quantity [unit]`.  A band that a title or a legend
names is drawn.  What is committed is SVG, the same to the byte from one run to the next.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from boresight.errors import BoresightError, need

STYLE: Any = {
    "font.family": "sans-serif",
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.labelsize": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.7,
    "axes.grid": True,
    "grid.color": "0.9",
    "grid.linewidth": 0.6,
    "axes.prop_cycle": "cycler('color', ['#0b5fa5', '#d1600a', '#2b7a3d', '#a3469b', '#8c5a2b', '#c9a227'])",
    "lines.linewidth": 1.1,
    "xtick.major.width": 0.7,
    "ytick.major.width": 0.7,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "figure.dpi": 150,
    "svg.fonttype": "none",  # text stays text
    "svg.hashsalt": "boresight",  # the same file from one run to the next
}
BLUE, ORANGE, GREY, GREEN = "#0b5fa5", "#d1600a", "0.55", "#2b7a3d"
AXES = (BLUE, ORANGE, GREEN)
TOOLS = {
    "Boresight": BLUE, "CasADi": ORANGE, "SymForce": GREEN, "wrenfold": "#a3469b", "SymPy cse": "#8c5a2b",
    "SymPy staged": "#c9a227", "Eigen, dense by hand": GREY, "Numba": "#a3469b", "JAX": "#c9a227",
    "NumPy by hand": GREY, "simdkalman": GREEN, "filterpy": "#8c5a2b", "python-ins": ORANGE,
}  # fmt: skip
FAINT = {"color": GREY, "alpha": 0.3, "linewidth": 0}  # a band that is not of one line

EDGE_IN = 0.16
MANY = 500  # points: in SVG a longer line is a picture, so that the file stays small


@contextmanager
def figure(
    path: Path, width_in: float, height_in: float, *, made_from: str = "", **subplots: Any
) -> Iterator[tuple[Any, Any]]:
    """A figure in the common style, written to `path` when the block ends.  No display, no global state.

    made_from: stands at the right edge and in the file's metadata.  Raises BoresightError where it cannot be written.
    """
    need("replay")
    import matplotlib

    with matplotlib.rc_context(STYLE):
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
        from matplotlib.layout_engine import ConstrainedLayoutEngine

        # beside the axes: below them stand legends
        edge = EDGE_IN * bool(made_from)
        part = edge / (width_in + edge)
        layout = ConstrainedLayoutEngine(rect=(0, 0, 1 - part, 1))
        drawing = Figure(figsize=(width_in + edge, height_in), layout=layout)
        svg = path.suffix == ".svg"
        canvas = FigureCanvasAgg(drawing)
        drawing.text(0.995, 0.01, made_from, ha="right", va="bottom", fontsize=6, color="0.45", rotation=90)
        axes = drawing.subplots(**subplots)
        yield drawing, axes
        # No software name or date inside: the file is the same from one run to the next.
        nothing = {"Date": None, "Creator": None} if svg else {"Software": None}
        for artist in drawing.findobj(long) if svg else ():
            artist.set_rasterized(True)
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            # `savefig` draws twice, first for the margins: one drawing finds them and makes the same picture
            write = drawing.savefig if svg else canvas.print_png
            write(path, metadata={**nothing, "Description": made_from})
        except OSError as error:
            reason = f"cannot write {path} ({error.strerror}); choose another folder with -o"
            raise BoresightError(reason) from None


def long(artist: Any) -> bool:
    """Whether a line or a band has many points."""
    paths = [artist.get_path()] if hasattr(artist, "get_xydata") else getattr(artist, "get_paths", list)()
    return sum(len(path.vertices) for path in paths) > MANY


class Sheets:
    """The figures of one result: `with sheets("name", width_in, height_in, **subplots) as (drawing, axes)`."""

    def __init__(self, folder: Path, made_from: str = "", svg: bool = False):
        self.folder, self.made_from, self.suffix = Path(folder), made_from, "svg" if svg else "png"
        self.written: list[Path] = []

    @contextmanager
    def __call__(self, stem: str, width_in: float, height_in: float, **subplots: Any) -> Iterator[tuple[Any, Any]]:
        path = self.folder / f"{stem}.{self.suffix}"
        with figure(path, width_in, height_in, made_from=self.made_from, **subplots) as drawn:
            yield drawn
        self.written.append(path)

    def text(self, name: str, content: str) -> None:
        """A file that is no figure, beside them."""
        try:
            (self.folder / name).write_text(content, encoding="utf-8")
        except OSError as error:
            reason = f"cannot write {self.folder / name} ({error.strerror}); choose another folder with -o"
            raise BoresightError(reason) from None
        self.written.append(self.folder / name)
