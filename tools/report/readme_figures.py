"""Which figures of READMEs come from which results. readme_numbers.py compares them and writes them.

- Tables are in readme_tables.py, figures in sentences in readme_sentences.py, pictures in PICTURES.
- What looks measured in the parts of READMEs in COMPLETE, but comes from no result file, is in ELSEWHERE."""
import importlib
from dataclasses import dataclass

import rows
from readme_sentences import MEASURED

READMES = ["README.md", MEASURED, "tools/README.md", "tools/fem/README.md", "tools/physbench/README.md"]
READMES += ["tools/truthcube/README.md", "tools/examples/kernels.md"]


# ---- Pictures --------------------------------------------------------------------------------------------------------
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

# ---- What is from elsewhere ------------------------------------------------------------------------------------------
# Parts of READMEs, from one text to another ("" is the end), in which all that looks measured must be held by results
# or stand in ELSEWHERE: words as in SENTENCES, and where they are from.
COMPLETE = {
    MEASURED: ("# What was measured", "## What accessors cost"),
    "tools/physbench/README.md": ("# physbench", ""),
}
ELSEWHERE = {
    MEASURED: [
        ("The paper's table 1 (GTX 285, 2010) had {}, {} and {} for the first three.", "the paper"),
        (
            "runs at the rate of a copy ({} to {}), {} to {} times as fast as the better of the two ways over AoS",
            "`tools/dev run --threads=1` on such a machine; no results of it are checked in",
        ),
        ("On one CPU core with AVX-512 (AMD EPYC, {} objects,", "as above"),
        ("the stress derivative runs at {} to {} of a copy, {} to {} times AoS.", "as above"),
        ("The SVD does {} million matrices a second ({} million in packs of 8,", "as above"),
        ("Eigen's JacobiSVD {} million.", "as above"),
    ],
    "tools/physbench/README.md": [
        ("compressed by {} % with a bulge", "fem/mesh/truth_cube.cpp"),
        ("Default sizes ({} tets on the CPU, {} on the GPU)", "options.h"),
        ("the same row took {} ms; that way is gone", "a way to copy that is gone; no command measures it any more"),
        ("| `random` | I + {} N(0,1) |", "how the set is made"),
    ],
}
