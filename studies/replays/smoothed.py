"""A pass over a recording, smoothed: each instant's estimate with all messages, and by how much sigmas shrink."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from boresight.analysis.figures import BLUE, ORANGE, Sheets
from boresight.analysis.record import Record
from boresight.analysis.smoother import smooth
from boresight.runtime.array import Array

BAND = 1.96  # sigmas, 95 %


@dataclass(frozen=True)
class Quantity:
    """What is shown: a state, by its place in x, and its unit in SI and rad.  in_nav: nav has its estimate."""

    name: str
    unit: str
    scale: float
    at: int
    in_nav: bool = True


def backwards(record: Record) -> dict[str, Any]:
    """A pass smoothed, after each of its K corrections; record: of one run.

    Returns time (K,) s since it began, sigma and filter_sigma (K, n), nav and filter_nav, by field (K, size).
    """
    done, rows = smooth(record), record.rows("feedback")
    variance = np.diagonal(record.covariance(rows), axis1=-2, axis2=-1)
    return {
        "time": record.time[rows], "sigma": done.sigma[rows], "filter_sigma": np.sqrt(variance),
        "nav": {name: value[rows] for name, value in done.nav.items()},
        "filter_nav": {name: value[rows] for name, value in record.nav.items()},
    }  # fmt: skip


def summary(found: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Of each quantity the filter and the smoother in the middle of the recording, and by how much sigmas shrink.

    found: of `backwards`, with estimate and filter_estimate (K, n), and what is shown under "of".
    """
    middle, out = len(found["time"]) // 2, []
    for one in found["of"]:
        at: dict[str, Any] = {}
        for part in ("filter_", ""):
            at[f"{part}estimate"] = float(found[f"{part}estimate"][middle, one.at] / one.scale) if one.in_nav else None
            at[f"{part}sigma"] = float(found[f"{part}sigma"][middle, one.at] / one.scale)
        ratio = found["sigma"][:, one.at] / found["filter_sigma"][:, one.at]
        out.append({"state": one.name, "unit": one.unit, "at_s": float(found["time"][middle]), **at,
                    "of_filter": float(ratio[middle]), "median_of_filter": float(np.median(ratio))})  # fmt: skip
    return out


def smoothed_lines(
    found: Sequence[Mapping[str, Any]],
    table: Callable[[Sequence[Sequence[str]]], list[str]],
    number: Callable[[float, float], str],
) -> list[str]:
    """The table for the report."""
    rows = [("", "filter", "1 sigma", "smoothed", "1 sigma", "unit", "sigma x", "median x")]
    for s in found:
        cells = []
        for part in ("filter_", ""):
            value, sigma = s[f"{part}estimate"], s[f"{part}sigma"]
            cells += ["" if value is None else number(value, sigma), number(sigma, sigma)]
        rows.append((s["state"], *cells, s["unit"], f"{s['of_filter']:.2f}", f"{s['median_of_filter']:.2f}"))
    return [
        "",
        f"Smoothed, with all messages, {found[0]['at_s']:.0f} s after the pass began; sigmas by noise:",
        "",
        *table(rows),
        "",
        "- Sigma x: the smoother's sigma over the filter's there.  Median x: of all messages.",
        "",
    ]


def draw_smoothed(found: Mapping[str, Any], sheets: Sheets, stem: str) -> None:
    """Of each quantity with an estimate the filter's band and the smoother's."""
    shown = [one for one in found["of"] if one.in_nav]
    rows = -(-len(shown) // 3)
    with sheets(stem, 11, 2.2 * rows, nrows=rows, ncols=3, squeeze=False) as (drawing, axes):
        for one, ax in zip(shown, axes.ravel(), strict=False):
            for part, color, label in (("filter_", ORANGE, "filter"), ("", BLUE, "smoothed")):
                value, sigma = (found[part + kind][:, one.at] / one.scale for kind in ("estimate", "sigma"))
                band: tuple[Array, Array] = (value - BAND * sigma, value + BAND * sigma)
                ax.fill_between(found["time"], *band, color=color, alpha=0.25, lw=0, label=f"{label}, 95 % by noise")
                ax.plot(found["time"], value, color=color, label=label)
                if part:
                    reach = 5 * float(np.median(sigma))
            centre = float(np.median(value))
            ax.set(ylim=(centre - reach, centre + reach), title=one.name, ylabel=f"[{one.unit}]")
        for ax in axes.ravel()[len(shown) :]:
            ax.remove()
        for ax in axes.ravel()[max(0, len(shown) - 3) : len(shown)]:
            ax.set_xlabel("time [s]")
        drawing.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
