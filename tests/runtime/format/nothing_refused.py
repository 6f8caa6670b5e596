#!/usr/bin/env python3
"""nothing_refused.py gnu|nvcc HITS SOURCE COMPILER FLAGS...: whether the compiler refuses exactly what SOURCE lists. The
places of the static_asserts that fail are written to the file HITS.

A line `/// refused NAME: words` is one case: under every index that REFUSED(NAME) calls it with, an error with these
words must name it, and the scene and the array of its field; where a copy is refused, the field. No other is reported.
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
import compiler_errors  # noqa: E402

compiler, hits, source, *command = sys.argv[1:]
text = open(source, encoding="utf-8").read()
kinds = {"gnu": ["one", "pack", "gathered"], "nvcc": ["one"]}[compiler]
marks = {"gnu": r"refused(?: on the host)?", "nvcc": r"refused"}[compiler]

expected = {}
for name, words in re.findall(rf"^/// {marks} (\w+): (.*)$", text, re.M):
    under = kinds if f"REFUSED({name})" in text else [""]
    for kind in under:
        expected[(name, kind)] = words
names = "|".join(sorted({name for name, _ in re.findall(r"^/// refused(?: on the host)? (\w+): (.*)$", text, re.M)} |
                        set(re.findall(r"^REFUSED\((\w+)\)$", text, re.M)) | {"only_copying"}, key=len, reverse=True))
case = re.compile(rf"refused::({names})_?(?:<refused::(\w+)>|\b)")

found, report = {}, []
errors = compiler_errors.compile_source(compiler, command, source, hits)
if not errors:
    sys.exit("FAILED: it compiles")
for error in errors:
    place = "\n".join(error.context)
    named = {(name, kind if f"REFUSED({name})" in text else "") for name, kind in case.findall(place)}
    named = {key for key in named if key[1] or f"REFUSED({key[0]})" not in text}
    if len(named) != 1:
        report.append(f"an error that names {sorted(named) or 'no case'}: {error.message}")
        continue
    (key,) = named
    words = expected.get(key)
    if words is None:
        report.append(f"{key} is none of the cases: {error.message}")
    elif words not in error.message:
        report.append(f"{key}: not \"{words}\", but {error.message}")
    elif key in found and found[key] != error.message:
        report.append(f"{key} is reported twice: {error.message}")
    else:
        if "no kernel of the scene" in words and not re.search(
                r"Scene_ ?= ?explicit_dynamics[;,] Array_ ?= ?arrays::svds[;,] Field_ ?= ?refused::", place):
            report.append(f"{key}: scene, array and field are not named")
        if "the array copied" in words and not re.search(
                r'DeformationSvdObject, (kField=)?physgen::detail::FieldName<2(UL)?>\{(\{\'U\'|"U")', place):
            report.append(f"{key}: object and field are not named")
        found[key] = error.message
report += [f"{key} is not refused" for key in expected if key not in found]
if report or not expected:
    sys.exit("FAILED:\n" + "\n".join(report or ["there are no cases"]))
print(f"{len(found)} cases are refused, and nothing else")
