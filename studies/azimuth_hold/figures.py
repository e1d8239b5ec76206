"""Figures of the azimuth hold and of its disturbances, in the place of Kim's Figures 4 to 7."""

from typing import Any

import numpy as np

from boresight.analysis.figures import BLUE, GREEN, GREY, ORANGE, Sheets

# Colour, line, width and label: where two lie on one another, the wide one shows on both sides of the thin one.
LOOK = {
    "inertial": (GREY, "-", 1.0, "pure inertial"),
    "zupt": (ORANGE, "-", 1.0, "zero-velocity updates"),
    "azimuth": (BLUE, "-", 3.0, "with the azimuth, as in the paper"),
    "reference": (GREEN, (0, (4, 2)), 1.2, "with the azimuth and its error as a state"),
    "turn_plain": (ORANGE, "-", 1.0, "half a degree turned, nothing notices"),
    "turn_guarded": (BLUE, "-", 1.6, "the same, with detector and gate"),
    "shock_guarded": (GREEN, (0, (4, 2)), 1.2, "a shock of 10 g, with detector and gate"),
}


def lines(ax: Any, time: Any, values: Any, modes: list[str], **look: Any) -> None:
    """A line a mode: values (T, modes)."""
    for m, mode in enumerate(modes):
        color, style, width, label = LOOK[mode]
        ax.plot(time, values[:, m], **{"color": color, "linestyle": style, "linewidth": width, "label": label} | look)


def draw(result: dict[str, Any], sheets: Sheets) -> None:
    """The paper's Figures 4 and 6, beside the error itself; and 5 and 7."""
    history, modes = result["history"], result["modes"]
    time, error = history["time_s"], history["error_arcmin"]
    with sheets("azimuth_hold_error", 9.6, 6.0, nrows=3, ncols=2, sharex=True) as (drawing, axes):
        for axis, (left, right) in enumerate(axes):
            lines(left, time, error[:, :, 0, axis], modes)
            lines(right, time, (error - error[0])[:, :, 0, axis], modes)
            left.set_ylabel(rf"$\phi_{'enu'[axis]}$ [arcmin]")
            right.set_ylim(*left.get_ylim())
        axes[0, 0].set_title("attitude error of one run", loc="left")
        axes[0, 1].set_title("its change since the hand-over, as in the paper's Figures 4 and 6", loc="left")
        for ax in axes[-1]:
            ax.set(xlabel="time at rest [s]", xlim=(0, time[-1]))
        drawing.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    with sheets("azimuth_hold_sigma", 6.4, 6.0, nrows=3, sharex=True) as (drawing, axes):
        for axis, ax in enumerate(axes):
            sigma_and_rms(ax, history, axis, modes)
            ax.set_ylabel(rf"$\phi_{'enu'[axis]}$ [arcmin]")
        axes[0].set_title(f"sigma of the filter; dotted, the rms error of {result['runs']} runs", loc="left")
        axes[-1].set(xlabel="time at rest [s]", xlim=(0, time[-1]))
        drawing.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)


def sigma_and_rms(ax: Any, history: dict[str, Any], axis: int, modes: list[str]) -> None:
    rms = np.sqrt(np.mean(history["error_arcmin"][..., axis] ** 2, axis=-1))
    lines(ax, history["time_s"], history["sigma_arcmin"][..., axis], modes)
    lines(ax, history["time_s"], rms, modes, linestyle=(0, (1, 1.5)), linewidth=1.6, label="")
    ax.set_yscale("log")


def draw_shock(result: dict[str, Any], sheets: Sheets) -> None:
    """About up: three runs of each, and sigma with the rms error; the level shows nothing of it."""
    history, modes = result["history"], result["modes"]
    with sheets("azimuth_hold_shock", 9.6, 3.4, ncols=2, sharex=True) as (drawing, (left, right)):
        for run in range(min(3, result["runs"])):
            shown = {} if run == 0 else {"label": ""}
            lines(left, history["time_s"], history["error_arcmin"][:, :, run, 2], modes, **shown)
        sigma_and_rms(right, history, 2, modes)
        for ax in (left, right):
            ax.axvline(result["event_s"], color="0.3", linewidth=0.7, linestyle=(0, (2, 2)))
            ax.set(xlabel="time at rest [s]", xlim=(0, history["time_s"][-1]), ylabel=r"$\phi_u$ [arcmin]")
        left.set_title("error about up, three runs", loc="left")
        right.set_title(f"sigma of the filter; dotted, the rms error of {result['runs']} runs", loc="left")
        drawing.legend(*left.get_legend_handles_labels(), loc="outside lower center", ncols=3)
