#!/usr/bin/env python3
"""refused.py gnu|clang|nvcc HITS SOURCE COMPILER FLAGS...: whether the compiler refuses every case of SOURCE, and nothing
else. The places of the static_asserts that fail are written to the file HITS.

A case begins with a line `/// refused NAME: words` and ends where the next one begins, or at a line `// ---- ...`. At
least one error in it, or in a template that it instantiates, must have the words; errors elsewhere are faults. `|` stands
between words of which one must be there, as where compilers say the same in other words. A line `/// naming A; B` behind it asks for
more: what g++ says around one of these errors names A and B, such as a step, an array and a field. In a case
`/// refused at once NAME: words` the line of the first error has the words, g++'s within 200 characters.
"""
import re
import sys

sys.dont_write_bytecode = True
import compiler_errors  # noqa: E402


def cases_of(source):
    """@return {case: its words}; {case: what it names}; the case at each line;
    and the cases whose first error must have the words"""
    cases, names, case_at, present, at_once = {}, {}, {}, None, set()
    for number, text in enumerate(open(source, encoding="utf-8").read().splitlines(), 1):
        begins = re.match(r"/// refused( at once)? (\w+): (.*)$", text)
        if begins:
            present = begins[2]
            if present in cases:
                sys.exit(f"FAILED: two cases are named {present}")
            cases[present] = begins[3].split("|")
            if begins[1]:
                at_once.add(present)
        elif text.startswith("// ----"):
            present = None
        elif text.startswith("/// naming "):
            names[present] = text[len("/// naming ") :].split("; ")
        case_at[number] = present
    if not cases:
        sys.exit(f"FAILED: {source} has no cases")
    return cases, names, case_at, at_once


def main(compiler, hits, source, *command):
    cases, names, case_at, at_once = cases_of(source)
    found, named, seen, faults, case = set(), set(), set(), [], None
    for error in compiler_errors.compile_source(compiler, command, source, hits):
        places = error.lines_of(source)
        if places:  # of which the nearest may be in what several cases share
            case = next((case_at[place] for place in places if case_at[place]), None)
        elif error.leads:  # else it is of the error before: compilers say once for several what has led there
            case = None
        if compiler != "gnu" and case is None and error.leads:  # these forget which call led to a template of a template
            found |= {case for case, words in cases.items() if any(word in error.message for word in words)}
        elif case is None:
            faults.append(f"outside of all cases: {error.line}")
        elif case in at_once - seen and not any(words in error.at_once for words in cases[case]):
            faults.append(f"{case}: its first error does not have the words at once: {error.line}")
        elif any(words in error.words for words in cases[case]):
            found.add(case)
            if all(name in "\n".join([error.line, *error.context]) for name in names.get(case, [])):
                named.add(case)
        seen.add(case)
    if compiler == "gnu":
        faults += [f"{case}: no such error names {' and '.join(names[case])}" for case in names if case in found - named]
    faults += [
        f"{case}: no error has the words \"{'|'.join(words)}\"" for case, words in cases.items() if words and case not in found
    ]
    if faults:
        sys.exit("FAILED:\n" + "\n".join(faults))
    print(f"{len(found)} cases are refused, and nothing else")


if __name__ == "__main__":
    main(*sys.argv[1:])
