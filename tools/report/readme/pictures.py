"""Pictures that READMEs show, and the files of results that they are drawn of."""
import importlib
from dataclasses import dataclass

import rows


@dataclass(frozen=True)
class Picture:
    """A plot, made from some files of results."""

    path: str
    files: tuple
    draw: object  # paths of the files -> matplotlib's figure, or None where they have no rows for it


def _of_page(plot):
    """The first plot of a section of the report, plots/`plot`.py."""

    def draw(paths):
        section = importlib.import_module(f"plots.{plot}").section(rows.load(paths))  # only drawing needs matplotlib
        return next((block.plot for block in section.blocks if hasattr(block, "plot")), None)

    return draw


def _error_against_time(paths):
    return importlib.import_module("truthcube.error_against_time").draw(*paths)


PICTURES = [
    Picture("tools/report/results/h200_pareto.svg", ("h200.json", "h200_storage.json"), _of_page("pareto")),
    Picture("tools/report/results/h200_gathered.svg", ("h200_gathers.json",), _of_page("gathered")),
    Picture("tools/report/results/truthcube/error_against_time.svg", ("truthcube/errors.json",), _error_against_time),
]
