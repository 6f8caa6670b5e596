#!/usr/bin/env python3
"""Writes what Doxygen reads into a folder, at the paths that the tree has it at: filtered_copies.py FOLDER, called in the root. Pages
and headers are as the filters give them, pictures and the style sheet as they are. One process does it for all files: to start one
for each, as Doxygen would, takes longer than Doxygen itself. PHYSGEN_PAGES and the others come from make.sh."""
import os
import pathlib
import shutil
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
import header_filter  # noqa: E402
import page_filter  # noqa: E402


def files(paths, *endings):
    """The files at the paths, and those below folders among them, that have one of the endings."""
    for path in map(pathlib.Path, paths):
        yield from (file for file in ([path] if path.is_file() else path.rglob("*")) if file.suffix in endings)


def main():
    folder = pathlib.Path(sys.argv[1])
    pages, headers, pictures = (os.environ[f"PHYSGEN_{name}"].split() for name in ("PAGES", "HEADERS", "PICTURES"))

    def place(file):
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        return folder / file

    for file in map(pathlib.Path, pages):
        place(file).write_text(page_filter.filtered(file.as_posix(), file.read_text(encoding="utf-8"), set(pages)), encoding="utf-8")
    for file in files(headers, ".h"):
        place(file).write_text(header_filter.filtered(file.read_text(encoding="utf-8")), encoding="utf-8")
    for file in (*files(pictures, ".png", ".svg"), pathlib.Path("tools/site/site.css")):
        shutil.copyfile(file, place(file))


if __name__ == "__main__":
    main()
