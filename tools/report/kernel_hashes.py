#!/usr/bin/env python3
"""Hashes of compiled kernels, by which results say what they measured: kernel_hashes.py -o FILE.txt
--keys KEY=SOURCE... --objects OBJECT... writes a line `KEY HASH` for each key, and FILE.cpp, which physbench is linked with.

What is hashed of an object or a program: the bytes of its sections of code and constants with the symbols that they refer to, and
the PTX of its kernels on CUDA (their machine code where there is no PTX), without comments and places in sources. So another
comment, line or name of a variable is the same hash; another compiler, option or instruction is another. PTX that nvcc has compressed
is hashed as it is, in which names of a file's own kernels hold a hash of its text: objects that are hashed need --no-compress."""
import argparse
import hashlib
import pathlib
import re
import struct
import sys

ALLOCATED, PROGBITS, RELA, SYMTAB = 2, 1, 4, 2
# Tables for debuggers and for exceptions, and what names the file itself; kernels of CUDA are read as PTX.
LEFT_OUT = re.compile(r"\.(eh_frame|gcc_except_table|note|interp|gnu|nv_fatbin|nvFatBinSegment)|__nv_module_id")


def of(paths):
    """The hash of files together. @throws OSError, ValueError of a file that is no ELF of 64 bits"""
    whole = hashlib.sha256()
    for path in sorted(map(str, paths)):
        for part in _parts(pathlib.Path(path).read_bytes(), path):
            whole.update(part)
    return whole.hexdigest()[:16]


# ---- The host's code -------------------------------------------------------------------------------------------------
def _parts(content, path):
    """Names and bytes of sections with what they refer to, in the order of their texts; and the kernels of CUDA."""
    if content[:6] != b"\x7fELF\x02\x01":
        raise ValueError(f"{path} is no object or program of 64 bits (ELF, little-endian)")
    (start,), (size, count, names_at) = struct.unpack_from("<Q", content, 40), struct.unpack_from("<3H", content, 58)
    heads = [struct.unpack_from("<2I4Q2I2Q", content, start + k * size) for k in range(count)]
    text = heads[names_at][4]
    names = [_string(content, text + head[0]) for head in heads]
    data = lambda head: content[head[4] : head[4] + head[5]]  # noqa: E731
    kept = {
        k: [names[k].encode() + b"\0", data(head)]
        for k, head in enumerate(heads)
        if head[1] == PROGBITS and head[2] & ALLOCATED and not LEFT_OUT.match(names[k])
    }
    symbols = next((_symbols(content, head, heads, names) for head in heads if head[1] == SYMTAB), [])
    for head in heads:
        if head[1] == RELA and head[7] in kept and symbols:  # info: the section that they are of
            for offset, info, addend in struct.iter_unpack("<QQq", data(head)):
                kept[head[7]].append(f"{offset} {info & 0xFFFFFFFF} {symbols[info >> 32]} {addend}\n".encode())
    kernels = [_kernels(data(head)) for name, head in zip(names, heads) if name == ".nv_fatbin"]
    return sorted(_without_hashes(b"".join(parts)) for parts in kept.values()) + kernels


def _symbols(content, head, heads, names):
    """The name of each symbol; of a section its own."""
    text = heads[head[6]][4]
    found = []
    for k in range(head[5] // 24):
        name, info, _, section = struct.unpack_from("<IBBH", content, head[4] + 24 * k)
        is_section = info & 15 == 3
        found.append(names[section] if is_section and section < len(names) else _string(content, text + name))
    return found


def _string(content, place):
    return content[place : content.index(b"\0", place)].decode("utf-8", "replace")


# ---- Kernels of CUDA -------------------------------------------------------------------------------------------------
_FATBIN, _PTX = 0xBA55ED50, 1
_COMMENT = re.compile(rb"//[^\n]*")
_PLACE = re.compile(rb"\s*\.(loc|file)\b")


def _kernels(section):
    """PTX without comments and places, or machine code where there is no PTX."""
    found, place = [], 0
    while place + 16 <= len(section):
        magic, _, head, size = struct.unpack_from("<IHHQ", section, place)
        if magic != _FATBIN:
            place += 8  # what aligns the next one
            continue
        entry, place = place + head, place + head + size
        while entry < place:
            kind, _, head, size = struct.unpack_from("<HHIQ", section, entry)
            found.append((kind, section[entry + head : entry + head + size]))
            entry += head + size
    texts = [text for kind, text in found if kind == _PTX] or [code for _, code in found]
    return _without_hashes(b"\n".join(_without_places(text) for text in sorted(texts)))


def _without_places(text):
    if not text.lstrip().startswith(b".version"):
        return text  # compressed, or machine code
    lines = (_COMMENT.sub(b"", line).strip() for line in text.split(b"\n") if not _PLACE.match(line))
    return b"\n".join(line for line in lines if line)


def _without_hashes(content):
    """Names of what a .cu file has for itself hold hashes of the file's path and text."""
    return re.sub(rb"[0-9a-f]{8}_\d+_\w+?_cu_[0-9a-f]{8}", b"", content)


# ---- The build -------------------------------------------------------------------------------------------------------
def of_builds(folder):
    """{KEY: hashes} of all builds in a folder. @throws OSError"""
    found = {}
    for path in sorted(pathlib.Path(folder).glob("*/tools/physbench/hashes/*.txt")):
        for line in path.read_text(encoding="utf-8").splitlines():
            key, _, hashed = line.partition(" ")
            found.setdefault(key, set()).add(hashed)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", required=True, type=pathlib.Path, metavar="FILE.txt")
    parser.add_argument("--keys", nargs="+", required=True, metavar="KEY=SOURCE", help="the source that has the kernels of a key")
    parser.add_argument("--objects", nargs="+", required=True, metavar="OBJECT", help="what sources were compiled to")
    options = parser.parse_args()
    known, lines = {}, []  # one source may have the kernels of several keys
    for word in sorted(options.keys):
        key, _, source = word.partition("=")
        objects = [path for path in options.objects if re.search(rf"(^|/){re.escape(source)}\.o(bj)?$", path)]
        if len(objects) != 1:
            raise ValueError(f"{len(objects)} objects are of {source}, which has the kernels of {key}")
        if source not in known:
            known[source] = of(objects)
        lines.append(f"{key} {known[source]}\n")
    options.output.write_text("".join(lines))
    text = "".join(f'    "{line[:-1]}\\n"\n' for line in lines)
    options.output.with_suffix(".cpp").write_text(
        '// Written by tools/report/kernel_hashes.py.\n#include "report/kernel_hashes.h"\n\n'
        f"[[maybe_unused]] static const bool are_known = physgen::bench::add_kernel_hashes(\n{text[:-1]});\n"
    )


if __name__ == "__main__":
    try:
        main()
    except (OSError, ValueError) as error:
        sys.exit(f"kernel_hashes.py: {error}")
