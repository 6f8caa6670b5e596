#!/usr/bin/python3
"""Makes a page of plots from physbench's results: report.py RESULTS.json... -o DIR"""
import argparse
import os
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
import rows  # noqa: E402

HELP = """Reads files that physbench --json wrote and makes DIR/index.html, one page with all plots inside, and each
plot as PNG and SVG beside it. Sections without rows say which rows would fill them, and the command that measures
those. Of rows that several files have from one machine, the last file's count. The same files give the same bytes."""


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="report.py", description=HELP, epilog="Exit status: 0 done, 2 wrong use or a file that is not physbench's."
    )
    parser.add_argument("results", nargs="+", metavar="RESULTS.json", help="files written by physbench --json=FILE")
    parser.add_argument(
        "--builds", default=rows.BUILDS, metavar="DIR", help="the folder of builds whose compiled kernels results are compared with; build"
    )
    parser.add_argument("-o", "--output", required=True, metavar="DIR", help="folder to write to; made if missing")
    options = parser.parse_args(arguments)
    try:
        results = rows.load(options.results, options.builds)
        outputs = _build(results)
        _write(options.output, outputs)
    except rows.ResultsError as error:
        return _fail(error)
    except ImportError as error:
        return _fail(f"{error}; on Debian: apt install python3-matplotlib")
    except OSError as error:
        return _fail(f"cannot write {error.filename or options.output}: {error.strerror or error}")
    print(os.path.join(options.output, "index.html"))
    return 0


def _build(results):
    import page
    import plots  # here, so that a wrong file is reported before matplotlib loads, and without it

    return page.build([module.section(results) for module in plots.ALL], results.files)


def _write(folder, outputs):
    """Writes all files under other names first, so that a full disk leaves none half-written."""
    os.makedirs(folder, exist_ok=True)
    partial = {name: os.path.join(folder, f".{name}.partial") for name in outputs}
    try:
        for name, content in outputs.items():
            with open(partial[name], "wb") as stream:
                stream.write(content)
        for name in outputs:
            os.replace(partial[name], os.path.join(folder, name))
    finally:
        for path in partial.values():
            if os.path.exists(path):
                os.remove(path)


def _fail(message):
    print(f"report.py: {message}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
