"""The layouts, and the law of addresses by which elements of objects lie in memory: the one place in Python that states them.
A test holds it equal to layout/*.h and layout/address.h."""
import re

PADDING_OBJECTS = 32


def align_up(value, step):
    return (value + step - 1) // step * step


class Layout:
    """What a type such as physgen::Aosoa<16> says.

    pitch() is the number of objects of a tile, padded() the number of those for which memory is held, record_bytes() the
    size of a record with `content` bytes whose largest element is aligned to `alignment`."""

    def __init__(self, type_name):
        found = re.fullmatch(r"(?:physgen::)?(AosPadded|Aosoa<(\d+)(?:[a-z]*)>|Aos|Soa|Uniform)", type_name)
        if not found:
            raise ValueError(f"{type_name} is no layout that this printer knows")
        self.tile = int(found[2] or 0)
        self.kind = found[1].split("<")[0]
        names = {"AosPadded": "array of structs, padded", "Aos": "array of structs", "Soa": "struct of arrays"}
        self.name = names.get(self.kind) or (f"tiles of {self.tile}" if self.tile else "one record for all")

    def pitch(self, objects):
        return self.tile or (self.padded(objects) if self.kind == "Soa" else 1)

    def padded(self, objects):
        whole = align_up(objects, max(self.tile, PADDING_OBJECTS))
        return whole + PADDING_OBJECTS if self.kind == "Soa" and whole > 0 and whole % 512 == 0 else whole

    def record_bytes(self, content, alignment):
        if self.kind == "Soa" or self.tile >= 8:
            return content
        return align_up(content, 8 // self.tile if self.tile else max(alignment, 16) if self.kind == "AosPadded" else alignment)

    def record_of(self, i):
        """The record that object i has."""
        return 0 if self.kind == "Uniform" else i


def element(base, pitch, record_bytes, i, offset, size):
    """The address of an element of record i that has `size` bytes and lies `offset` bytes into the record."""
    return base + (i // pitch) * pitch * record_bytes + offset * pitch + (i % pitch) * size
