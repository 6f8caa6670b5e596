#!/usr/bin/env python3
"""refused.py SOURCE COMPILER FLAGS...: whether g++ refuses every case of SOURCE, and nothing else.

A case begins with a line `/// refused NAME: words` and ends where the next one begins, or at a line `// ---- ...`. At
least one error in it, or in a template that it instantiates, must have the words; errors elsewhere are faults. A case
`/// refused with AVX-512 NAME: words` must be refused only where the flags ask for AVX-512. `|` stands between words of
which one must be there. A line `/// naming A; B` behind it asks for more: what g++ says around one of these errors names
A and B, such as a step, an array and a field.
"""
import re
import subprocess
import sys

source, command = sys.argv[1], sys.argv[2:]
lines = open(source, encoding="utf-8").read().splitlines()
wide = "-march=x86-64-v4" in command

cases, names, case_at, present = {}, {}, {}, None  # words of a case, what it names; the case at each line
for number, text in enumerate(lines, 1):
    begins = re.match(r"/// refused( with AVX-512)? (\w+): (.*)$", text)
    if begins:
        present = begins[2]
        if present in cases:
            sys.exit(f"FAILED: two cases are named {present}")
        cases[present] = begins[3].split("|") if wide or not begins[1] else []
    elif text.startswith("// ----"):
        present = None
    elif text.startswith("/// naming "):
        names[present] = text[len("/// naming "):].split("; ")
    case_at[number] = present
if not cases:
    sys.exit(f"FAILED: {source} has no cases")

here = re.compile(re.escape(source) + r":(\d+):")


def case_named(places):
    """The case of the first place that is in the source; None where none is."""
    for place in places:
        found = here.search(place)
        if found:
            return case_at[int(found[1])]
    return None


done = subprocess.run([*command, source], capture_output=True, text=True, check=False)
output = done.stderr.splitlines()
errors = [number for number, text in enumerate(output) if re.search(r": (fatal )?error: ", text)]
found, named, faults, case = set(), set(), [], None
for begin, number in zip([-1, *errors], errors):
    # g++ says before an error what has led there, from its last `In ...` on, and says it once for several errors.
    around = output[begin + 1 : number]
    heads = [k for k, text in enumerate(around) if re.search(r": In \w+ |: At ", text)]
    context = around[heads[-1] :] if heads else []
    case = case_named([output[number], *context[::-1]]) or (None if context or here.search(output[number]) else case)
    if case is None:
        faults.append(f"outside of all cases: {output[number]}")
    elif any(words in output[number] for words in cases[case]):
        found.add(case)
        if all(name in "\n".join([*context, output[number]]) for name in names.get(case, [])):
            named.add(case)
faults += [f"{case}: no such error names {' and '.join(names[case])}" for case in names if case in found - named]
faults += [f"{case}: no error has the words \"{'|'.join(words)}\"" for case, words in cases.items() if words and case not in found]
if faults:
    sys.exit("FAILED:\n" + "\n".join(faults))
print(f"{len(found)} cases are refused, and nothing else")
