"""The report's command, and its page as the tests look at it."""
import collections
import contextlib
import io
import pathlib
import subprocess
import sys
import unittest.mock
from html.parser import HTMLParser

TOOL = pathlib.Path(__file__).resolve().parents[3] / "tools" / "report"
sys.path.insert(0, str(TOOL))
import drawing  # noqa: E402
import report as tool  # noqa: E402

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


Done = collections.namedtuple("Done", "returncode stderr")


def report(*arguments):
    """The command in this process, where matplotlib loads once. @return its exit status, and what it said"""
    said = io.StringIO()
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
        try:
            status = tool.main([str(argument) for argument in arguments])
        except SystemExit as end:  # of wrong use
            status = end.code
    return Done(status, said.getvalue())


def report_of_words(*arguments):
    """The same with empty plots, which are what takes its time: for tests that look at the words of a page alone."""
    with (
        unittest.mock.patch.object(drawing, "svg", lambda figure: "<svg ></svg>"),
        unittest.mock.patch.object(drawing, "png", lambda figure, *rest, **options: b""),
    ):
        return report(*arguments)


def report_of_a_process(*arguments):
    """The same in a process of its own."""
    command = [sys.executable, TOOL / "report.py", *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return Done(done.returncode, done.stderr)


class Page(HTMLParser):
    """The parts of a page that tests ask for: sections with their text and their numbers of plots, references, and ids."""

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
