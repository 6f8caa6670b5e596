"""The sections of the page, one a file; each has section(results), which returns a content.Section."""
from . import (
    conversions,
    errors,
    force_differential,
    gathered,
    growth,
    layouts,
    paper_table,
    pareto,
    provenance,
    transfers,
)

ALL = [paper_table, pareto, layouts, conversions, transfers, gathered, growth, force_differential, errors, provenance]
