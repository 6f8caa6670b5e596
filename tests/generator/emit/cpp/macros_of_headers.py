#!/usr/bin/env python3
"""macros_of_headers.py PHYSGEN FOLDER COMPILER...: whether physgen refuses every name that is a macro of a header that
programs include. The compilers say which these are; those of networks and terminals are not among them, whose macros
are names of physics as well (B0, DATA)."""
import pathlib
import re
import subprocess
import sys

HEADERS = """ctype.h assert.h byteswap.h complex.h dirent.h dlfcn.h endian.h errno.h fcntl.h fenv.h float.h getopt.h inttypes.h
libgen.h limits.h locale.h math.h poll.h pthread.h sched.h semaphore.h setjmp.h signal.h stddef.h stdio.h stdlib.h string.h
strings.h sys/mman.h sys/param.h sys/socket.h sys/stat.h sys/sysmacros.h sys/time.h sys/types.h sys/wait.h tgmath.h time.h
unistd.h values.h wchar.h chrono cmath complex filesystem fstream future random regex thread""".split()


def macros(compiler):
    """Each macro that is defined behind one of the headers, and the header: of one run over all of them, which takes a
    hundredth of the time of a run for each. <ctype.h> comes first, since those of C++ leave its macros out."""
    source = "".join(f"#include <{header}>\n#pragma behind {header}\n" for header in HEADERS)
    for standard in ("gnu++20", "c++20"):
        text = subprocess.run([compiler, f"-std={standard}", "-x", "c++", "-dD", "-E", "-"], input=source, capture_output=True,
                              text=True, check=True).stdout
        defined = set()
        for what, name in re.findall(r"^#(define|undef|pragma behind) ([\w./]+)", text, re.MULTILINE):
            if what == "define":
                defined.add(name)
            elif what == "undef":
                defined.discard(name)
            else:
                yield from ((macro, name) for macro in defined)


def main(physgen, folder, *compilers):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    names = {}
    for compiler in compilers:
        for name, header in macros(compiler):
            names.setdefault(name, header)
    fields = "".join(f"  Scalar {name};\n" for name in names if not re.search("^_|__", name))  # reserved in any case
    schema = folder / "macros.h"
    schema.write_text("#include <physgen/schema.h>\nnamespace m {\nusing namespace physgen::schema;\n"
                      f"struct PHYSGEN_OBJECT() A {{\n{fields}}};\n}}\n", encoding="utf-8")
    said = subprocess.run([physgen, "generate", str(schema), "-o", str(folder)], capture_output=True, text=True, check=False).stderr
    refused = set(re.findall(r"field name '(\w+)'", said))
    missing = [f"{name} of <{names[name]}>" for name in re.findall(r"Scalar (\w+);", fields) if name not in refused]
    if len(refused) < 1000 or missing:
        sys.exit(f"FAILED: {len(refused)} names are refused, and these are not: {', '.join(missing)}\n{said[:1000]}")
    print(f"{len(refused)} names of macros are refused")


if __name__ == "__main__":
    main(*sys.argv[1:])
