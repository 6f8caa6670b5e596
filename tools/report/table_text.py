"""Numbers of a result's row as text, and the lines of a table of Markdown."""


# ---- Numbers ---------------------------------------------------------------------------------------------------------
def ms(row, digits=3):
    return f"{row.ms:.{digits}f}"


def count(number):
    return f"{number:,.0f}"


def eps(value):
    return f"{value:.1f} eps" if value < 1e4 else f"{value:.0e} eps"


def error(row, which):
    return f"{row.error(which):.1e}"


def times(before, after):
    return f"{before.ms / after.ms:.2f}x"


# ---- Tables ----------------------------------------------------------------------------------------------------------
def markdown(header, body):
    head, *lines = ("| " + " | ".join(cells) + " |\n" for cells in (header, *body))
    return head + "|---" * len(header) + "|\n" + "".join(lines)


def captioned(row, words, table):
    """A table with the machine and the number of objects of its rows above it."""
    return f"{row.machine}, {count(row.objects)} {words}:\n\n{table}"
