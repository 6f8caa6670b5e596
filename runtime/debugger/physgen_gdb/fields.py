"""The fields of object types, read from what programs keep of them: the array `fields` of FieldInfo that each array of
objects refers to (fields/object_info.h), and the types of the members of values, which have the shapes."""
import collections
import re

import gdb

FieldInfo = collections.namedtuple(
    "FieldInfo", "name unit type offset count scale centre rotation quaternion own pruned in_double shape entries"
)
_known = {}  # by object, precision and formats; what a library that is loaded later has is looked up again


class Unreadable(Exception):
    """What is wrong with an array, in words."""


def forget(_event=None):
    _known.clear()


def arguments(type_name):
    """The name of a template and its arguments, as text."""
    name, _, inside = type_name.partition("<")
    parts, depth, start = [], 0, 0
    for at, c in enumerate(inside):
        depth += (c in "<({") - (c in ">)}")
        if depth < 0 or (c == "," and depth == 0):
            parts.append(inside[start:at].strip())
            start = at + 1
        if depth < 0:
            break
    return name, parts


def without_const(name):
    return re.sub(r"\s*\bconst\b\s*", "", name)


def plain_name(of):
    """The name of a type without typedefs, qualifiers and references."""
    stripped = of.strip_typedefs()
    if stripped.code in (gdb.TYPE_CODE_REF, gdb.TYPE_CODE_RVALUE_REF):
        stripped = stripped.target().strip_typedefs()
    return str(stripped.unqualified())


def lookup(type_name):
    try:
        return gdb.lookup_type(type_name)
    except gdb.error:
        return None


def is_tag(of):
    """Whether a type is the generated tag of an object type."""
    if of.code != gdb.TYPE_CODE_STRUCT or not str(of.unqualified()).endswith("Object"):
        return False
    bases = [field for field in of.fields() if field.is_base_class]
    return bool(bases) and str(bases[0].type).startswith("physgen::ObjectTag")


def text(view):
    """The text of a std::string_view, of any C++ library."""
    of = view.type.strip_typedefs()
    words = {field.type.strip_typedefs().code: view[field] for field in of.fields() if not field.is_base_class and hasattr(field, "bitpos")}
    return words[gdb.TYPE_CODE_PTR].string("utf-8", "replace", length=int(words[gdb.TYPE_CODE_INT]))


def field_infos(name):
    """The elements of an array of FieldInfo, by its name; None where the program has no such array."""
    try:
        at = gdb.parse_and_eval(f"&'{name}'")
    except gdb.error:
        return None
    if at.type.target().strip_typedefs().code == gdb.TYPE_CODE_STRUCT:
        return elements_of(at.dereference())
    info = lookup("physgen::FieldInfo")  # else of a name without a type, as with formats of an unnamed namespace
    if info is None:
        return None
    begin, count = int(at), 0
    while name in gdb.execute(f"info symbol {begin + count * info.sizeof}", to_string=True):
        count += 1
    return [gdb.Value(begin + k * info.sizeof).cast(info.pointer()).dereference() for k in range(count)]


def elements_of(array):
    """The elements of a std::array."""
    inner = next(array[field] for field in array.type.strip_typedefs().fields() if not field.is_base_class)
    low, high = inner.type.strip_typedefs().range()
    return [inner[i] for i in range(low, high + 1)]


def member(of, path):
    """The type of a value's member by its path "frames[1].turn", without what it is an array of, and the entries of that array."""
    entries = 1
    for name, indices in re.findall(r"(\w+)((?:\[\d+\])*)", path):
        fields = [field for field in of.fields() if field.name == name]
        if not fields:
            return None, 1
        of = fields[0].type.strip_typedefs()
        if of.code == gdb.TYPE_CODE_ARRAY:
            entries = 1 if indices else of.range()[1] + 1
            of = of.target().strip_typedefs()
    return of, entries


def shape_of(value_type, path):
    """Rows and columns of a field and its entries; no shape where the program has no value of the object."""
    of, entries = member(value_type, path) if value_type is not None else (None, 1)
    if of is None:
        return None, 1
    name, parts = arguments(str(of))
    if name == "physgen::MatrixValue":
        return tuple(int(re.match(r"\d+", part)[0]) for part in parts[1:3]), entries
    return (1, 1), entries


def value_type(object_name, real):
    """The type of the value of one object, where the program has it."""
    found = lookup(f"{object_name[: -len('Object')]}<{real}>")
    return found.strip_typedefs() if found is not None else None


def fields_of(object_name, real, formats):
    """The fields of an object type in a precision and formats. Raises Unreadable where the program has no list of them."""
    key = object_name, real, formats
    if key not in _known:
        _known[key] = _read(*key)
    return _known[key]


def _read(object_name, real, formats):
    tag = lookup(object_name)
    if tag is None or not is_tag(tag.strip_typedefs()):
        raise Unreadable(f"this program has no debug information of {object_name}; compile it with -g")
    base = next(field for field in tag.strip_typedefs().fields() if field.is_base_class)
    owner = str(base.type).replace("ObjectTagPerSpace", "ObjectTag", 1)  # which derives from that
    infos = field_infos(f"{owner}::fields<{real}, {formats}{' ' if formats.endswith('>') else ''}>")
    if infos is None:
        raise Unreadable(f"this program has no list of the fields of {object_name} in {formats}, since it makes no array of them")
    value = value_type(object_name, real)
    return [_field(info, value) for info in infos]


def _field(info, value):
    name, quaternion, rotation = text(info["name"]), bool(info["quaternion"]), bool(info["rotation"])
    count = int(info["count"])
    shape, entries = shape_of(value, name)
    if rotation:
        shape, entries = (3, 3), count // (4 if quaternion else 9)
    return FieldInfo(
        name=name,
        unit=text(info["unit"]),
        type=str(info["type"]).split("::")[-1],
        offset=int(info["offset"]),
        count=count,
        scale=float(info["scale"]),
        centre=float(info["centre"]),
        rotation=rotation,
        quaternion=quaternion,
        own=int(info["own"]) != 0,
        pruned=bool(info["pruned"]),
        in_double=bool(info["in_double"]),
        shape=shape,
        entries=entries,
    )
