"""Figures of the Euler-angle table and of its exploration."""

from typing import Any

import numpy as np

from boresight.analysis.figures import BLUE, ORANGE, Sheets


def table_figure(result: dict[str, Any], sheets: Sheets) -> None:
    """Table 1 as a picture: the paper's, by linear covariance, by Monte Carlo; three squares a case."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LinearSegmentedColormap, TwoSlopeNorm
    from matplotlib.lines import Line2D
    from matplotlib.patches import Rectangle

    paper, threshold = np.array(result["paper"]), result["threshold"]
    # The hue changes at the threshold and nowhere else; the depth says how far away the cell is.
    hue = LinearSegmentedColormap.from_list(
        "ratio", [(0, "#08457a"), (0.5, "#bfd9ef"), (0.5, "#fbdcc2"), (1, "#b34700")], N=512
    )
    scale = ScalarMappable(TwoSlopeNorm(np.log10(threshold), np.log10(0.02), 0.0), hue)
    panels = [("Song and Lee, Table 1", np.where(paper, 0.02, 1.0))]
    for title, part in (("(a) linear covariance", "linear"), ("(b) Monte Carlo", "monte_carlo")):
        panels.append((f"{title}: {result[part]['agree']} of {paper.size}", np.array(result[part]["ratio"])))
    short = [", ".join(part[0] for part in name.split(", ")) for name in result["motions"]]
    with sheets("euler_table", 9.6, 4.3, ncols=3, sharey=True) as (drawing, axes):
        for ax, (title, ratio) in zip(axes, panels, strict=True):
            for (i, j, k), value in np.ndenumerate(ratio):
                x, y = j + 0.09 + 0.28 * k, i + 0.2
                tint = scale.to_rgba(np.log10(np.clip(value, 0.02, 1.0)))
                ax.add_patch(Rectangle((x, y), 0.26, 0.6, facecolor=tint, edgecolor="none"))
                if (value < threshold) != paper[i, j, k]:
                    ax.add_line(Line2D([x, x + 0.26], [y, y + 0.6], color="black", linewidth=1.2))
            ax.set(xlim=(0, 7), ylim=(7, 0), aspect="equal", title=title, xlabel="motion")
            ax.set_xticks(np.arange(7) + 0.5, short)
            ax.set_yticks(np.arange(7) + 0.5, result["matchings"])
            ax.set_xticks(np.arange(8), minor=True)
            ax.set_yticks(np.arange(8), minor=True)
            ax.grid(False)
            ax.grid(True, which="minor")
            ax.tick_params(which="both", length=0)
            ax.spines[:].set_visible(False)
        axes[0].set_ylabel("matched angles")
        ticks = (0.02, 0.05, 0.1, 0.2, threshold, 0.5, 1.0)
        bar = drawing.colorbar(scale, ax=axes, location="bottom", ticks=np.log10(ticks), aspect=60, fraction=0.04)
        bar.ax.set_xticklabels([f"{tick:.2g}" for tick in ticks])
        bar.ax.minorticks_off()
        bar.outline.set_visible(False)
        bar.set_label(
            r"$\varepsilon_n$, $\varepsilon_e$, $\varepsilon_d$ (left to right in each case): error after "
            f"{result['seconds']:g} s, as a part of the error at the start\n"
            "blue: estimated; orange: not estimated; struck through: other than in the paper"
        )


def history(result: dict[str, Any], match: int, motion: int, sheets: Sheets) -> None:
    """One of the paper's Figures 2 to 10: the three errors in time, three runs, within the filter's 1-sigma band."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    parts = result["history"]
    time, runs = parts["time_s"], result["runs"]
    error, rms, sigma, linear = (
        parts[name][:, match, motion] for name in ("error_deg", "rms_deg", "sigma_deg", "linear_sigma_deg")
    )
    names = result["matchings"][match], result["motions"][motion]
    stem = f"figure_{2 + 3 * match + motion:02d}_{names[0]}_match_{names[1]}_motion"
    lines = ((rms, "0.2", (0, (5, 3)), f"rms of {runs} runs"),
             (linear, "0.5", (0, (1, 1.5)), "1 sigma, H along the true motion"))  # fmt: skip
    with sheets(stem, 5.6, 5.0, nrows=3, sharex=True, sharey=True) as (drawing, axes):
        for k, ax in enumerate(axes):
            shown = result["paper"][match][motion][k]
            tint = BLUE if shown else ORANGE
            ax.fill_between(time, -sigma[:, k], sigma[:, k], color=tint, alpha=0.18, linewidth=0)
            ax.plot(time, error[:, :, k], color=tint, linewidth=0.9)
            for values, color, line, _ in lines:
                ax.plot(time, np.stack([values[:, k], -values[:, k]], -1), color=color, linestyle=line, linewidth=0.9)
            ax.set_ylabel(rf"$\varepsilon_{'ned'[k]}$ [deg]")
            says = "estimated" if shown else "not estimated"
            ax.set_title(f"paper: {says}", loc="right", fontsize=8, color=tint, pad=2)
        axes[0].set_title(f"{names[0]} match, {names[1]} motion", loc="left")
        axes[0].set(xlim=(0, time[-1]))
        axes[-1].set_xlabel("time [s]")
        # one legend for panels of two colours: what a line is, by its shape
        keys = {"1 sigma of the filter": Patch(color="0.85"), "error, three runs": Line2D([], [], color="0.45")}
        keys |= {label: Line2D([], [], color=color, linestyle=line) for _, color, line, label in lines}
        drawing.legend(keys.values(), keys.keys(), loc="outside lower center", ncols=2)


def draw(result: dict[str, Any], sheets: Sheets) -> None:
    """The table, and Figures 2 to 10."""
    table_figure(result, sheets)
    for match, motion in np.ndindex(3, 3):
        history(result, match, motion, sheets)


def durations(result: dict[str, Any], sheets: Sheets) -> None:
    """How long Table 1 stays the paper's: the lowest sigma of its not estimated cells, with each cause switched off."""
    with sheets("euler_durations", 5.6, 3.4) as (_, ax):
        for row in result["durations"]:
            if not row["process_noise"] and not row["second_order"]:
                continue  # lies on the line above it, or at 1
            causes = [
                word for key, word in (("earth_rate", "Earth rate"), ("second_order", "second order")) if row[key]
            ]
            label = f"{'Q of 1 deg/h' if row['process_noise'] else 'Q = 0'}; {' and '.join(causes) or 'neither'}"
            ax.plot(
                row["time_s"],
                row["smallest"],
                color=BLUE if row["process_noise"] else ORANGE,
                linestyle={2: "-", 0: (0, (1, 1.5))}.get(len(causes), (0, (5, 2)) if row["earth_rate"] else "-."),
                label=label,
            )
        ax.axhline(1 / 3, color="0.3", linewidth=0.8)
        ax.text(1.1, 0.345, "threshold", fontsize=8, color="0.3")
        ax.set(xscale="log", yscale="log", xlim=(1, 3600), ylim=(0.02, 1.3), xlabel="time [s]")
        ax.set_ylabel("sigma, part of the start")
        ax.set_yticks([0.02, 0.05, 0.1, 0.2, 0.5, 1.0], ["0.02", "0.05", "0.1", "0.2", "0.5", "1"])
        ax.set_xticks([1, 10, 30, 120, 300, 1000, 3600], ["1", "10", "30", "120", "300", "1000", "3600"])
        ax.minorticks_off()
        ax.legend(loc="lower left")
        ax.set_title("the best known of the errors that the paper calls not estimable", loc="left")


def consistency(result: dict[str, Any], sheets: Sheets) -> None:
    """NEES against the misalignment: the paper's filter with and without a bias, and the exact one."""
    kinds = (
        (False, False, "no bias, Q = 0", ORANGE, "o"),
        (True, False, "1 deg/h and its Q", BLUE, "s"),
        (False, True, "exact residual, P turned; no bias", "0.25", "D"),
    )
    with sheets("euler_consistency", 5.6, 3.4) as (_, ax):
        low, high = result["consistency"][0]["nees"]["band"]
        ax.axhspan(low, high, color="0.85", linewidth=0, label="95 % band, 50 runs")
        for bias, exact, label, color, marker in kinds:
            rows = [
                row
                for row in result["consistency"]
                if row["bias"] == bias and row["exact"] == exact and row["turn_covariance"] == exact
                if row["iterations"] == (3 if exact else 1) and row["told_arcmin"] == [1.0, 1.0]
            ]
            size = np.array([row["misalignment_deg"] for row in rows])
            mean, small, large = (np.array([row["nees"][k] for row in rows]) for k in ("mean", "smallest", "largest"))
            shift = {"o": 0.97, "s": 1.0, "D": 1.03}[marker]
            ax.errorbar(
                size * shift, mean, (mean - small, large - mean), color=color, marker=marker, markersize=4, label=label
            )
        ax.set(xscale="log", yscale="log", xlabel="misalignment, 1 sigma per axis [deg]", ylabel="NEES of 6 states")
        ax.set_xticks([0.1, 0.2, 0.3, 0.5, 1, 2, 3], ["0.1", "0.2", "0.3", "0.5", "1", "2", "3"])
        ax.minorticks_off()
        ax.legend(loc="upper left")
        ax.set_title("mean of the 49 cases, bars to the smallest and the largest", loc="left")


def explored(result: dict[str, Any], sheets: Sheets) -> None:
    if result["finished"]:
        durations(result, sheets)
        consistency(result, sheets)
