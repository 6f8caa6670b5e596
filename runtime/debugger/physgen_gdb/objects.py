"""Where the objects of an array, a view or a reference lie, whether that can be, and the values of their fields.

An object is handed to gdb as a value of its tag, such as elasticity::StressObject, at the address of its first element: the
tag has no members, and its methods (methods.py) are the fields."""
import struct

import gdb
from physgen_gdb import elements, layout
from physgen_gdb.fields import Unreadable, arguments, fields_of, lookup, plain_name, without_const

BUFFER_ALIGNMENT = 256
_handed_out = {}  # Object by the name of its tag and its address


class Place:
    """Where records lie: of an array, or of the tile that a reference stands on."""

    def __init__(self, base, pitch, record_bytes, space="Host"):
        self.base, self.pitch, self.record_bytes, self.space = base, pitch, record_bytes, space

    def address(self, i, offset, size):
        return layout.element(self.base, self.pitch, self.record_bytes, i, offset, size)

    def read(self, i, offset, size):
        address = self.address(i, offset, size)
        try:
            return bytes(gdb.selected_inferior().read_memory(address, size))
        except (gdb.error, OverflowError):
            where = ", in CUDA memory; copy the array to Host to look at it" if self.space == "Cuda" else ""
            raise Unreadable(f"no memory can be read at {address:#x}{where}") from None


class Object:
    """Record i of a place. `prefix` and `fields` choose what is shown: all fields, or those of a nested object."""

    def __init__(self, tag, real, fields, place, i, prefix=""):
        self.tag, self.real, self.fields = tag, real, fields
        self.place, self.i, self.prefix = place, i, prefix

    def value(self):
        """What gdb is given."""
        first = min((f.offset for f in self.fields if elements.BYTES[f.type]), default=0)
        size = next((elements.BYTES[f.type] for f in self.fields if f.offset == first and elements.BYTES[f.type]), 1)
        self.place.read(self.i, first, 1)
        address = self.place.address(self.i, first, size)
        _handed_out[self.tag, address] = self
        return gdb.Value(address).cast(lookup(self.tag).pointer()).dereference()

    def children(self):
        for field in self.fields:
            name = field.name[len(self.prefix) :]
            if field.shape is None and field.count > 1 and elements.BYTES[field.type]:
                name += f" ({field.count} stored)"  # of a matrix or an array: nothing in the program says which
            yield f"{name} [{field.unit}]" if field.unit else name, shown(self.field, field)

    def field(self, field, entry=None):
        """A field's value, as a number or as rows of numbers; of a fixed array, one entry or all."""
        size, at = elements.BYTES[field.type], field.offset
        if size == 0:
            raise Unreadable("pruned: nothing is stored" if field.pruned else "nothing is stored")
        count = field.count // field.entries
        entries = range(field.entries) if entry is None else [entry]
        if field.own:
            stored = [self.place.read(self.i, at + (e * count + k) * size, size).hex() for e in entries for k in range(count)]
            raise Unreadable(f"bytes {' '.join(stored)} in a format of the program's own")
        values = [self._entry(field, at + e * count * size, count, size) for e in entries]
        of = elements.WHOLE.get(field.type) or ("double" if field.in_double else "float")
        return gdb_array(gdb.lookup_type(of), values if field.entries > 1 and entry is None else values[0])

    def _entry(self, field, at, count, size):
        stored = [
            elements.decode(field.type, self.place.read(self.i, at + k * size, size), field.scale, field.centre, field.in_double)
            for k in range(count)
        ]
        if field.quaternion:
            return elements.rotation(stored, coarse=size < (8 if field.in_double else 4))
        rows = elements.rows(stored, field.shape)
        if field.shape is None:
            return rows[0] if count > 1 else rows[0][0]
        if field.shape[1] == 1:
            rows = [row[0] for row in rows]
        return rows[0] if field.shape == (1, 1) else rows


CODES = {("float", 4): "f", ("double", 8): "d", ("int", 4): "i", ("long", 8): "q", ("unsigned long", 8): "Q", ("bool", 1): "B"}


def gdb_array(of, numbers):
    """Numbers, nested in lists, as a gdb value: a number, or an array of them. `of` is a type of CODES."""
    flat, sizes, inner = [numbers], [], numbers
    while isinstance(inner, list):
        sizes.append(len(inner))
        flat = [part for whole in flat for part in whole]
        inner = inner[0]
    packed = struct.pack(f"={len(flat)}{CODES[str(of), of.sizeof]}", *flat)
    for size in reversed(sizes):
        of = of.array(size - 1)
    return gdb.Value(packed, of)


def shown(read, *of):
    """What read() gives, or in words why it cannot."""
    try:
        return read(*of)
    except Unreadable as why:
        return str(why)


def handed_out(value):
    """The Object that a value of a tag stands for."""
    found = _handed_out.get((plain_name(value.type), int(value.address))) if value.address is not None else None
    if found is None:
        raise Unreadable("an object of no array that is known here; write array[i] or view[i]")
    return found


class Objects:
    """The objects of an array or a view."""

    def __init__(self, tag, real, formats, shape, space, size):
        self.tag, self.layout, self.size = tag, layout.Layout(shape), size
        self.space = space.split("::")[-1]
        self.real, self.formats = without_const(real), formats

    def object(self, i):
        if not 0 <= i < self.size:
            raise Unreadable(f"object {i} of {self.size}")
        return Object(self.tag, self.real, self.fields, self.place, self.layout.record_of(i))

    def title(self):
        return f"{self.size} {self.tag[: -len('Object')]}, {self.layout.name}{', CUDA' if self.space == 'Cuda' else ''}"

    def check(self, base):
        """Reads the list of fields, and finds what no array can be."""
        if self.size < 0 or self.size > 1 << 48:
            raise Unreadable(f"corrupted, or not made yet: its size is {self.size}")
        self.fields = fields_of(self.tag, self.real, self.formats) if self.size > 0 else []
        self.content = max((f.offset + f.count * elements.BYTES[f.type] for f in self.fields), default=0)
        if self.size > 0 and base == 0 and self.content > 0:
            raise Unreadable(f"null, though its size is {self.size}")


def of_array(value):
    """@pre value is an Array"""
    tag, real, space, shape, formats = arguments(plain_name(value.type))[1]
    buffer = value["buffer_"]
    base, held = int(buffer["data_"]), int(buffer["bytes_"])
    objects = Objects(tag, real, formats, shape, space, int(value["size_"]))
    objects.check(base)
    capacity = int(value["capacity_"])  # there is memory for so many
    kind = {"Host": "host", "PinnedHost": "pinned", "Cuda": "cuda"}[objects.space]
    record = record_in(held, objects.layout.padded(capacity))
    if (
        base % BUFFER_ALIGNMENT
        or capacity < objects.size
        or record < objects.content
        or (held > 0 and (record == 0 or str(buffer["space_"]).split("::")[-1] != kind))
    ):
        raise Unreadable(f"corrupted: {held} bytes at {base:#x} are not those of {objects.size} objects")
    objects.place = Place(base, objects.layout.pitch(capacity), record, objects.space)
    return objects


def record_in(held, padded):
    """The bytes of a record, of so many that fill the memory of an array; of a checked program, before the counts of losses."""
    losses = lookup("physgen::Losses")
    for extra in (0, losses.sizeof if losses is not None else 0):
        if padded and held > extra and (held - extra) % padded == 0:
            return (held - extra) // padded
    return 0


def pitch_in(value, shape):
    """The pitch that a view, or the member pitch_ of a reference, has."""
    if shape.kind != "Soa":
        return shape.pitch(1)
    pitch = int(value["pitch_"])
    if pitch <= 0:
        raise Unreadable(f"corrupted: its pitch is {pitch}")
    return pitch


def of_view(value):
    """@pre value is a View"""
    tag, real, shape, formats, space = arguments(plain_name(value.type))[1]
    base, objects = int(value["base_"]), Objects(tag, real, formats, shape, space, int(value["size_"]))
    objects.check(base)
    if objects.size > 0:
        pitch = pitch_in(value, objects.layout)
        if objects.layout.kind == "Soa" and pitch < objects.size:
            raise Unreadable(f"corrupted: its pitch is {pitch}, of {objects.size} objects")
        objects.place = Place(base, pitch, _record_bytes(value, objects), objects.space)
    return objects


def _record_bytes(value, objects):
    try:
        return int(value["record_bytes"])
    except gdb.error:
        pass
    if objects.layout.kind in ("Soa", "Uniform") or objects.layout.tile > 2:
        return objects.layout.record_bytes(objects.content, 1)
    raise Unreadable("the bytes of its records are not in the debug information of this program; look at the array")
