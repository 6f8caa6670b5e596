"""References to objects and their fields, and rows: where what they name lies."""
import re

import gdb
from physgen_gdb import elements, layout
from physgen_gdb.fields import FieldInfo, Unreadable, arguments, elements_of, fields_of, plain_name
from physgen_gdb.objects import Object, Objects, Place, of_array, of_view, pitch_in

TYPES = {"float": "float32", "double": "float64", "int": "int32", "long": "int64", "unsigned long": "uint64", "bool": "boolean"}


class Cursor:
    """The member at_ of a reference: a place, and the records there that it stands on; several under a pack."""

    def __init__(self, at):
        name, parts = arguments(plain_name(at.type))
        if name != "physgen::Cursor":
            raise Unreadable("of a local, which lies in no array")
        shape, sizes = layout.Layout(parts[1]), re.findall(r"\d+", parts[2])
        pitch = pitch_in(at["pitch_"], shape)
        record, lane_bytes = int(sizes[1]), int(sizes[2])
        fields = {field.name for field in at.type.strip_typedefs().fields()}
        self.one = "object_" in fields
        if self.one:
            lane = int(at["lane_"])
            base, records = int(at["object_"]) - lane * lane_bytes, [lane]
        elif "index_" in fields:
            base, records = int(at["base_"]), [int(i) for i in elements_of(at["index_"])]
        else:
            first, last = lanes(at["pack_"])
            base, records = int(at["tile_"]), [int(at["lane_"]) + l for l in range(first, last)]
        self.place = Place(base, pitch, record)
        self.records = [shape.record_of(i) for i in records]


def lanes(pack):
    """The lanes of a pack that are objects of the range."""
    name, parts = arguments(plain_name(pack.type))
    whole = name == "physgen::Pack"
    return (0, int(parts[0])) if whole else (int(pack["first"]), int(pack["last"]))


def objects_of(reference):
    """The objects that an ObjectRef stands on, and whether it is one by itself."""
    base = next(field for field in reference.type.strip_typedefs().unqualified().fields() if field.is_base_class)
    name, (real, formats, _) = arguments(plain_name(base.type))  # of the generated accessors
    cursor, tag = Cursor(reference["at_"]), name[: -len("Ref")] + "Object"
    fields = fields_of(tag, real, formats)
    return [Object(tag, real, fields, cursor.place, i) for i in cursor.records], cursor.one


def field_of(reference):
    """The values that a FieldRef or an ElementRef stands on, and whether it is one by itself."""
    name, parts = arguments(plain_name(reference.type))
    cursor = Cursor(reference["at_"])
    if name == "physgen::FieldRef":
        field = stated(parts[0], parts[1], parts[2], 0)
    else:
        field = stated("physgen::shape::Scalar", parts[0], parts[1], 0)
        at = int(reference["offset_"]) + int(reference["k_"]) * elements.BYTES[field.type]
        field = field._replace(offset=at)
    return [(Object("", "", [field], cursor.place, i), field) for i in cursor.records], cursor.one


def stated(shape, stored, computed, offset):
    """A field as the types of its shape, its format and its precision state it."""
    name, parts = arguments(shape.split("physgen::shape::")[-1])
    sizes = [int(re.match(r"\d+", part)[0]) for part in parts if re.match(r"\d+", part)]
    n = sizes[0] if sizes else 3
    rows_columns = {"Scalar": (1, 1), "Rotation": (3, 3), "Diagonal": (n, 1)}.get(name) or (n, sizes[-1] if len(sizes) > 1 else n)
    count = {"Symmetric": n * (n + 1) // 2, "Skew": n * (n - 1) // 2}.get(name, rows_columns[0] * rows_columns[1])
    quaternion = stored.startswith("physgen::format::Quaternion")
    if quaternion:
        stored, count = arguments(stored)[1][0], 4
    kind, scale, centre = meaning(stored, computed)
    return FieldInfo(
        name="", unit="", type=kind, offset=offset, count=count, scale=scale, centre=centre, rotation=name == "Rotation",
        quaternion=quaternion, own=False, pruned="Pruned" in stored, in_double=computed == "double", shape=rows_columns, entries=1
    )  # fmt: skip


def meaning(stored, computed):
    """The stored type, scale and centre of a format by its name."""
    name, parts = arguments(stored)
    name = name.split("physgen::format::")[-1]
    numbers = [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?:e[+-]\d+)?", parts[-1])] if parts else []
    if name in ("Snorm16", "Scaled") and any(len(re.sub(r"e.*|\D", "", n)) == 7 for n in re.findall(r"-?[\d.e+-]+", parts[-1])):
        raise Unreadable(f"in {stored}, whose numbers this compiler rounds; look at the object, view[i]")
    if name == "Half":
        return "half", 2.0 ** int(numbers[0]), 0.0
    if name == "Snorm16":
        return "snorm16", numbers[1] / 2 - numbers[0] / 2, numbers[1] / 2 + numbers[0] / 2
    if name == "Scaled":
        return meaning(parts[0], computed)[0], *numbers
    plain = {"Native": TYPES[computed], "Float32": "float32", "Float64": "float64", "Bfloat16": "bfloat16"}
    if name in plain:
        return plain[name], 1.0, 0.0
    if name in ("Nothing", "Pruned"):
        return "none", 1.0, 0.0
    raise Unreadable(f"in {stored}, a format of the program's own; look at the object, view[i]")


class Rows:
    """Rows, or the arrays that own them: a range of entries for each row."""

    def __init__(self, value):
        owned = plain_name(value.type).startswith("physgen::RowArrays<")
        read = of_array if owned else of_view
        self.ranges, self.entries = read(value["ranges_"]), read(value["entries_"])
        self.targets = int(value["targets_"]["count"] if owned else value["targets_"])

    def title(self):
        tag = self.entries.tag[: -len("Object")]
        return f"{self.ranges.size} rows of {self.entries.size} {tag}, which name {self.targets} targets"

    def children(self):
        """Entries by row: "[0][1]" is entry 1 of row 0."""
        for i in range(self.ranges.size):
            row = self.ranges.object(i)
            begin, end = (int(row.field(field)) for field in row.fields[:2])
            if not 0 <= begin <= end <= self.entries.size:
                yield f"[{i}]", f"entries {begin} .. {end - 1} of {self.entries.size}: corrupted"
            elif begin == end:
                yield f"[{i}]", "no entries"
            else:
                yield from ((f"[{i}][{k - begin}]", self.entries.object(k)) for k in range(begin, end))
