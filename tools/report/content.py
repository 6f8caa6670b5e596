"""The parts of a section of the page: paragraphs, tables and figures."""
from dataclasses import dataclass, field


@dataclass
class Text:
    html: str


@dataclass
class Table:
    """A table; cells are plain text, the first column is left-aligned. `folded`: behind a line to click."""

    header: list
    rows: list
    caption: str
    folded: bool = False


@dataclass
class Figure:
    """A plot: `name` is that of its files, `plot` a matplotlib Figure, `caption` plain text with units."""

    name: str
    plot: object
    caption: str


@dataclass
class Section:
    """`blocks` is empty when no row fills the section; then the page shows `rows` and `command` instead. `used`: the
    measured rows that the blocks are made of; the page says which of them may be older than the code."""

    title: str
    blocks: list
    rows: str = ""
    command: str = ""
    used: list = field(default_factory=list)
