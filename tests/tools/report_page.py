"""The report's command, and its page as the tests look at it."""
import pathlib
import subprocess
import sys
from html.parser import HTMLParser

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools" / "report"
SECTIONS = [
    "the-paper-s-table-1-redone",
    "speed-against-error",
    "layouts-of-every-kernel",
    "conversions-between-layouts",
    "transfers-between-host-and-device",
    "gathered-against-streamed",
    "cost-per-object-against-the-number-of-objects",
    "force-differential-against-cusparse",
    "error-against-speed-on-hard-inputs",
    "machines-versions-commands",
]


def report(*arguments):
    return subprocess.run(
        [sys.executable, TOOL / "report.py", *map(str, arguments)], capture_output=True, text=True, check=False
    )


class Page(HTMLParser):
    """What the tests ask of a page: sections with their text and their numbers of plots, references, and ids."""

    def __init__(self, path):
        super().__init__()
        self.text, self.plots, self.references, self.ids, self.section = {}, {}, [], [], ""
        self.source = path.read_text(encoding="utf-8")
        self.feed(self.source)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "section":
            self.section = attributes["id"]
            self.text[self.section], self.plots[self.section] = "", 0
        if tag == "svg":
            self.plots[self.section] += 1
        if "id" in attributes:
            self.ids.append(attributes["id"])
        self.references += [
            value for name, value in attributes.items() if name in ("src", "href", "xlink:href", "data")
        ]

    def handle_data(self, data):
        if self.section:
            self.text[self.section] += data
