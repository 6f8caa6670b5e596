"""What gdb prints of arrays, views, references, rows, packs and values. Whatever they hold, a printer says it and raises nothing."""
import gdb
import gdb.printing
from physgen_gdb import fields, objects, references
from physgen_gdb.fields import Unreadable, arguments, plain_name


FAULTS = (Unreadable, gdb.error, ValueError, KeyError, IndexError, StopIteration, OverflowError)  # of what memory may hold


class Printed:
    """Text, and children under names or numbers."""

    def __init__(self, text, children=(), hint=None):
        self.text, self.given, self.hint = text, children, hint

    def to_string(self):
        return self.text

    def children(self):
        try:
            yield from self.given
        except FAULTS as why:
            yield "...", str(why)

    def display_hint(self):
        return self.hint


def told(make):
    """A printer that says in words what make(value) cannot read."""

    def printer(value):
        try:
            return make(value)
        except FAULTS as why:
            return Printed(str(why) or f"unreadable ({type(why).__name__})")

    return printer


def listed(found):
    """Children of objects by number, each printed by its own printer."""
    for i, one in found:
        yield f"[{i}]", objects.shown(one)


def collection(read):
    def make(value):
        found = read(value)
        return Printed(found.title(), listed((i, lambda i=i: found.object(i).value()) for i in range(found.size)), "array")

    return make


def one_object(value):
    return Printed(None, objects.handed_out(value).children())


def object_reference(value):
    found, one = references.objects_of(value)
    if one:
        return Printed(None, found[0].children())
    return Printed(f"{len(found)} lanes", listed((i, found[i].value) for i in range(len(found))), "array")


def field_reference(value):
    found, one = references.field_of(value)
    if one:
        return Printed(objects.shown(*[found[0][0].field, found[0][1]]))
    return Printed(f"{len(found)} lanes", listed((i, lambda i=i: found[i][0].field(found[i][1])) for i in range(len(found))), "array")


def rows(value):
    found = references.Rows(value)
    children = ((name, objects.shown(what.value) if isinstance(what, objects.Object) else what) for name, what in found.children())
    return Printed(found.title(), children)


def pack(value):
    first, last = references.lanes(value)
    begin = int(value["begin"])
    return Printed(f"objects {begin + first} .. {begin + last - 1}, in a pack of {arguments(plain_name(value.type))[1][0]}")


def batch(value):
    number, data = value.type.strip_typedefs().template_argument(0), value["data"]
    return Printed(data.cast(number.vector(data.type.sizeof // number.sizeof - 1)))  # the register says nothing of integers


def matrix(value):
    """An Eigen::Matrix, or the MatrixValue that holds one."""
    if plain_name(value.type).startswith("physgen::"):
        value = value["entries_"]
    of = value.type.strip_typedefs()
    scalar = of.template_argument(0).strip_typedefs().unqualified()
    parts = [int(part.split("ul")[0].rstrip("L")) for part in arguments(plain_name(of))[1][1:4]]
    storage = value["m_storage"]
    r = parts[0] if parts[0] >= 0 else int(storage["m_rows"])
    c = parts[1] if parts[1] >= 0 else int(storage["m_cols"])
    data = storage["m_data"]
    data = data if parts[0] < 0 or parts[1] < 0 else data["array"]
    if r < 0 or c < 0 or r * c > 1 << 40:
        return Printed(f"corrupted: {r} rows and {c} columns")
    by_rows = parts[2] & 1

    def entry(i, j):
        return data[i * c + j if by_rows else j * r + i]

    if not 0 < r * c <= 256 or (str(scalar), scalar.sizeof) not in objects.CODES:
        return Printed(f"{r}x{c} {scalar}", ((f"[{i},{j}]", entry(i, j)) for i in range(r) for j in range(c)))
    number = int if scalar.code == gdb.TYPE_CODE_INT else float
    rows_of = [[number(entry(i, j)) for j in range(c)] for i in range(r)]
    return Printed(objects.gdb_array(scalar, rows_of if c > 1 else [row[0] for row in rows_of]))


PRINTERS = {
    "physgen::Array": collection(objects.of_array),
    "physgen::View": collection(objects.of_view),
    "physgen::ObjectRef": object_reference,
    "physgen::FieldRef": field_reference,
    "physgen::ElementRef": field_reference,
    "physgen::Rows": rows,
    "physgen::RowArrays": rows,
    "physgen::Pack": pack,
    "physgen::PartialPack": pack,
    "physgen::MatrixValue": matrix,
    "Eigen::Matrix": matrix,
    "xsimd::batch": batch,
}


class Printers(gdb.printing.PrettyPrinter):
    """Finds the printer of a value by the name of its type."""

    def __init__(self):
        super().__init__("physgen")

    def __call__(self, value):
        of = value.type.strip_typedefs()
        if of.code != gdb.TYPE_CODE_STRUCT:
            return None
        if fields.is_tag(of):
            return told(one_object)(value)
        make = PRINTERS.get(str(of.unqualified()).partition("<")[0])
        return told(make)(value) if make else None
