#!/usr/bin/python3
"""Draws pictures of a run of truthcube from the files in its --out folder; see --help."""
import argparse
import os
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
from truthcube import beads, records  # noqa: E402

HELP = """Draws a run of truthcube from the files in its --out folder (cube.vtkhdf, beads.csv, run.json): its surface in
perspective and a cut along y through its middle (surface.png, cut.png), at rest and after each step, coloured by
displacement and von Mises stress; the last step of both (last_step.png); the beads' displacements as arrows
(beads.png), with the difference to those of a table or of the checked-in reference (tests/fem/solver/oracle) where it
has beads of the run; and, of equilibria, the residual over Newton steps (convergence.png). Of more than 14 steps as many
are drawn, evenly spread. With --errors it draws error against time from a file of truthcube_runs.py --errors instead.
The same files give the same bytes."""


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="truthcube_pictures.py", description=HELP,
        epilog="Exit status: 0 done; 2 wrong use, or a file that is not truthcube's: then nothing is written.",
    )  # fmt: skip
    parser.add_argument("run", metavar="RUN", help="folder that truthcube --out wrote; with --errors a file of runs")
    parser.add_argument("-o", "--output", required=True, metavar="DIR", help="folder to write to; made if missing")
    parser.add_argument("--beads", metavar="FILE", help="table of beads to compare with: x,y,z,ux,uy,uz in metres and, "
                        "if there is one, compression")  # fmt: skip
    parser.add_argument("--errors", action="store_true", help="draw error against time from a file of runs")
    options = parser.parse_args(arguments)
    if options.errors and options.beads:
        parser.error("--beads is for a run's folder: a file of runs has its errors in it")
    try:
        outputs = _errors(options.run) if options.errors else _pictures(options.run, options.beads)
        os.makedirs(options.output, exist_ok=True)
        for name, content in outputs.items():
            path = os.path.join(options.output, name)
            with open(path, "wb") as stream:
                stream.write(content)
            print(path)
    except records.RunError as error:
        return _fail(error)
    except ImportError as error:
        return _fail(f"{error}; on Debian: apt install python3-matplotlib python3-h5py")
    except OSError as error:
        return _fail(f"cannot write {error.filename or options.output}: {error.strerror or error}")
    return 0


def _pictures(folder, table):
    """@return {file name: bytes}"""
    import drawing  # here, so that without matplotlib there is a remedy
    from truthcube import arrows, body, convergence, files

    run = files.read_run(folder)
    if not run.steps:
        raise records.RunError(f"{os.path.join(folder, 'run.json')}: the run has no steps yet")
    figures = {}
    if run.beads:  # first, since a table may be refused
        step = run.steps[-1]
        figures["beads"] = arrows.draw(run, step, *_reference(run, step, table))
    elif table:
        raise records.RunError(f"{folder} has no beads.csv to compare {table} with: only runs of the Truth Cube have one")
    outside, middle = body.outside(run), body.middle(run)
    figures["surface"], figures["cut"] = body.steps(run, outside), body.steps(run, middle)
    figures["last_step"] = body.last_step(run, outside, middle)
    if not run.moves:
        figures["convergence"] = convergence.draw(run)
    about = f"{run.record['command']}; {run.record['device']}"
    return {f"{name}.png": drawing.png(figure, about, dpi=140) for name, figure in figures.items()}


def _reference(run, step, table):
    """Beads to compare with, and what they are called; nothing where there are none."""
    name = table or beads.oracle_name(run.record["settings"], step.compression)
    if name is None:
        return ()
    found = beads.at_compression(beads.read_beads(table or beads.ROOT / name), step.compression)
    if found is None:
        raise records.RunError(f"{table} has no beads of a compression of {step.compression:g}, the run's last step")
    return found, os.path.basename(table) if table else "reference"


def _errors(path):
    import drawing
    from truthcube import error_against_time

    figure = error_against_time.draw(path)
    return {"error_against_time.svg": drawing.svg(figure).encode(), "error_against_time.png": drawing.png(figure)}


def _fail(message):
    print(f"truthcube_pictures.py: {message}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
