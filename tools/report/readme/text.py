"""Numbers as READMEs print them."""


def ms(row, digits=3):
    return f"{row.ms:.{digits}f}"


def count(number):
    return f"{number:,.0f}"


def span(values, form=".2f"):
    """The smallest and the largest, for `{} to {}`."""
    values = list(values)
    return [format(min(values), form), format(max(values), form)]


def eps(value):
    return f"{value:.1f} eps" if value < 1e4 else f"{value:.0e} eps"


def error(row, which):
    return f"{row.error(which):.1e}"


def mebibytes(row):
    return row.counter("bytes_per_object") * row.objects / 2**20


def copy_fractions(file, *patterns):
    return span(row.copy_fraction for row in file.all(*patterns))
