#!/usr/bin/env python3
"""nothing_refused.py gnu|nvcc SOURCE COMPILER FLAGS...: whether the compiler refuses exactly what SOURCE lists.

A line `/// refused NAME: words` is one case: under every index that REFUSED(NAME) calls it with, an error with these
words must name it, and the scene and the array of its field; where a copy is refused, the field. No other is reported.
"""
import re
import subprocess
import sys

compiler, source, command = sys.argv[1], sys.argv[2], sys.argv[3:]
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

result = subprocess.run([*command, source], capture_output=True, text=True)
found, report, lines = {}, [], (result.stdout + result.stderr).splitlines()
if result.returncode == 0:
    sys.exit("FAILED: it compiles")
for number, line in enumerate(lines):
    error = re.search(r"error: (.*)", line)
    if not error:
        continue
    # g++ says where it is before the error, from its last `In instantiation of` on; nvcc behind it, up to the next one.
    around = lines[:number][::-1] if compiler == "gnu" else lines[number + 1:]
    block = []
    for other in around:
        if " error: " in other:
            break
        block.append(other)
        if compiler == "gnu" and re.search(r": In \w+ ", other):
            break
    place = "\n".join(block[::-1] if compiler == "gnu" else block)
    named = {(name, kind if f"REFUSED({name})" in text else "") for name, kind in case.findall(place)}
    named = {key for key in named if key[1] or f"REFUSED({key[0]})" not in text}
    if len(named) != 1:
        report.append(f"an error that names {sorted(named) or 'no case'}: {error[1]}")
        continue
    (key,) = named
    words = expected.get(key)
    if words is None:
        report.append(f"{key} is none of the cases: {error[1]}")
    elif words not in error[1]:
        report.append(f"{key}: not \"{words}\", but {error[1]}")
    elif key in found and found[key] != error[1]:
        report.append(f"{key} is reported twice: {error[1]}")
    else:
        if "no kernel of the scene" in words and not re.search(
                r"Scene_ ?= ?explicit_dynamics[;,] Array_ ?= ?arrays::svds[;,] Field_ ?= ?refused::", place):
            report.append(f"{key}: scene, array and field are not named")
        if "the array copied" in words and not re.search(
                r'DeformationSvdObject, (kField=)?physgen::detail::FieldName<2(UL)?>\{(\{\'U\'|"U")', place):
            report.append(f"{key}: object and field are not named")
        found[key] = error[1]
report += [f"{key} is not refused" for key in expected if key not in found]
if report or not expected:
    sys.exit("FAILED:\n" + "\n".join(report or ["there are no cases"]))
print(f"{len(found)} cases are refused, and nothing else")
