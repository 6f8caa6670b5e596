#!/usr/bin/env python3
"""static_asserts_test.py ROOT HITS [without CUDA]: whether every static_assert of the public headers below ROOT is hit by a
case that must not compile. The files in the folder HITS say which were: refused.py and nothing_refused.py write them.
A static_assert that no program can hit stands in INVARIANTS."""
import pathlib
import re
import sys

FOLDERS = ("runtime/include", "tools/fem", "generated")
# Words of static_asserts that hold whatever a program does, and why.
INVARIANTS = {
    "fields.size() > 0": "physgen refuses objects without fields, and only it writes objects",
    "std::is_trivially_copyable_v<Value> && sizeof(Value) <= 64": "values of folds are numbers, alone or with an index",
    "masks convert to bool with this xsimd": "of a version of xsimd that the build does not have",
    "IsMaterial<Model<double>>": "rows of materials.h stand in this tree; no program adds one",
    "material.volume_modulus();": "materials are rows of this tree; no program adds one",
    "Concept<Type>": "rows of preconditioner_rows.h stand in this tree; solver_catalog.py adds one to a copy of it",
    "physgen::are_sound_records<": "physgen plans what the compiler finds; tests/generator/plan/proof_test.cpp has plans that it does not",
}


class StaticAssert:
    """One of them: the lines that it is on, and what it says."""

    def __init__(self, path, text, begin):
        end, depth, quoted = begin, 0, False
        while True:
            letter = text[end]
            if letter == "\\":
                end += 1
            elif letter == '"':
                quoted = not quoted
            elif not quoted:
                depth += (letter == "(") - (letter == ")")
                if letter == ")" and depth == 0:
                    break
            end += 1
        self.path = path
        self.first, self.last = (text.count("\n", 0, place) + 1 for place in (begin, end))
        self.says = re.sub(r'"\s*"', "", " ".join(text[begin : end + 1].split()))

    def __str__(self):
        return f"{self.path}:{self.first}: static_assert{self.says}"


def static_asserts(root):
    """Those of the public headers; of generated ones and of comments none that are no code."""
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.h")):
            text = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
            for match in re.finditer(r"\bstatic_assert(?=\()", text):
                yield StaticAssert(path, text, match.end())


def needs_cuda(one, root):
    """Whether only nvcc compiles it: in a file for CUDA, or behind an #ifdef that it alone passes."""
    if "cuda" in one.path.relative_to(root).as_posix():
        return True
    guards = []
    for line in one.path.read_text(encoding="utf-8").splitlines()[: one.first]:
        if re.match(r"#if", line):
            guards.append("__CUDA" in line and "!" not in line)
        elif re.match(r"#el", line):
            guards[-1] = False
        elif re.match(r"#endif", line):
            guards.pop()
    return any(guards)


def main(root, hits, *without_cuda):
    root = pathlib.Path(root).resolve()
    hit = set()
    for file in pathlib.Path(hits).iterdir():
        for line in file.read_text().splitlines():
            path, number = line.rsplit(":", 1)
            hit.add((path, int(number)))
    found = list(static_asserts(root))
    unused = [words for words in INVARIANTS if not any(words in one.says for one in found)]
    faults = [f"INVARIANTS names '{words}', and no static_assert says so" for words in unused]
    for one in found:
        is_hit = any((str(one.path), number) in hit for number in range(one.first, one.last + 1))
        invariant = any(words in one.says for words in INVARIANTS)
        if is_hit and invariant:
            faults.append(f"a program can hit this one of INVARIANTS: {one}")
        elif not is_hit and not invariant and not (without_cuda and needs_cuda(one, root)):
            faults.append(f"no case that must not compile hits {one}")
    if len(found) < 100:
        faults.append(f"there are hardly any static_asserts below {root}: {len(found)}")
    if faults:
        sys.exit("FAILED:\n" + "\n".join(faults))
    kept = sum(not any(words in one.says for words in INVARIANTS) for one in found)
    print(f"{kept} static_asserts of public headers, each with a case that must not compile")


if __name__ == "__main__":
    main(*sys.argv[1:])
