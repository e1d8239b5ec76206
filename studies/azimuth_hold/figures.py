"""Figures of the azimuth-hold study, in the place of Kim's Figures 4 to 7."""

from pathlib import Path
from typing import Any

import numpy as np

from boresight.studies.figures import BLUE, GREY, ORANGE, figure

GREEN = "#2b7a3d"
LOOK = {
    "inertial": (GREY, "-", "pure inertial"),
    "zupt": (ORANGE, "-", "zero-velocity updates"),
    "azimuth": (BLUE, "-", "with the azimuth, as in the paper"),
    "turn_plain": (ORANGE, "-", "half a degree turned, nothing notices"),
    "turn_guarded": (BLUE, "-", "the same, with detector and gate"),
    "shock_guarded": (GREEN, (0, (4, 2)), "a shock of 10 g, with detector and gate"),
    "reference": (GREEN, (0, (4, 2)), "with the azimuth and its error as a state"),
}


def panels(result: dict[str, Any], path: Path, title: str, draw: Any) -> None:
    """Three axes above each other, one line or more a mode; `draw(ax, mode, axis, look)`."""
    with figure(path, 6.4, 6.0, nrows=3, sharex=True) as (drawing, axes):
        for axis, ax in enumerate(axes):
            for mode in result["modes"]:
                draw(ax, mode, axis, LOOK[mode])
            ax.set_ylabel(rf"$\phi_{'enu'[axis]}$ [arcmin]")
        axes[0].set_title(title, loc="left")
        axes[-1].set_xlabel("time at rest [s]")
        axes[-1].set_xlim(0, result["histories"]["time_s"][-1])
        handles, labels = axes[0].get_legend_handles_labels()
        drawing.legend(handles, labels, loc="outside lower center", ncols=2)


def errors(result: dict[str, Any], path: Path) -> None:
    """The paper's Figures 4 and 6: attitude error in time, three runs in each mode."""
    history = result["histories"]

    def draw(ax: Any, mode: str, axis: int, look: tuple) -> None:
        color, style, label = look
        for run, error in enumerate(np.array(history[mode]["error_arcmin"], float)):
            ax.plot(
                history["time_s"], error[:, axis], color=color, linestyle=style, linewidth=0.8,
                label="" if run else label,
            )  # fmt: skip

    panels(result, path, "attitude error, the same three runs in each mode", draw)


def sigmas(result: dict[str, Any], path: Path) -> None:
    """The paper's Figures 5 and 7: the filter's sigma in time, and (thin) the rms error over the runs."""
    history = result["histories"]

    def draw(ax: Any, mode: str, axis: int, look: tuple) -> None:
        color, style, label = look
        ax.plot(history["time_s"], np.array(history[mode]["sigma_arcmin"])[:, axis], color=color, linestyle=style,
                linewidth=1.6, label=label)  # fmt: skip
        rms = np.array(history[mode]["rms_arcmin"], float)[:, axis]
        ax.plot(history["time_s"], rms, color=color, linestyle=(0, (1, 1.5)), linewidth=0.8)
        ax.set_yscale("log")
        if "event_s" in result:
            ax.axvline(result["event_s"], color="0.3", linewidth=0.7, linestyle=(0, (2, 2)))

    panels(result, path, f"sigma of the filter; dotted, the rms error of {result['runs']} runs", draw)


def azimuth_figures(result: dict[str, Any], folder: Path) -> list[Path]:
    """The figures for which the result has the histories.  Returns the files written."""
    folder, written = Path(folder), []
    for part, stem in ((result, "azimuth_hold"), (result.get("shock", {}), "azimuth_hold_shock")):
        if "histories" in part:
            for draw, name in ((errors, "error"), (sigmas, "sigma")):
                written.append(folder / f"{stem}_{name}.png")
                draw(part, written[-1])
    return written
