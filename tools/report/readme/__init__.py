"""Which figures of READMEs come from which results; readme_numbers.py compares them and writes them.

- A table stands in a README between `<!-- figures: NAME, from FILE.json -->` and `<!-- end of figures -->`; tables.py
  makes it. That of the packages comes in the same way from their list, tools/packages.txt.
- A figure in a sentence is a `{}` in sentences.py, with the words around it as the README has them.
- A picture is drawn anew when its files change: pictures.py.
- What looks measured and comes from no result file is in elsewhere.py, with where it is from."""

READMES = [
    "README.md",
    "tools/fem/README.md",
    "tools/physbench/README.md",
    "tools/truthcube/README.md",
    "tools/examples/kernels.md",
]
