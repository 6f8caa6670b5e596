"""Methods that gdb evaluates in Python, since optimised programs have no code of them: array[i], view[i], get(i), view(), and the
fields of an object by their names, view[i].sigma()."""
import re

import gdb
import gdb.xmethod
from physgen_gdb import fields, objects, references
from physgen_gdb.fields import Unreadable, is_tag, lookup, plain_name


def object_named(value, type_name):
    """The object that a method is called on."""
    if not type_name.startswith("physgen::ObjectRef<"):
        return objects.handed_out(value)
    found, one = references.objects_of(value)
    if not one:
        raise Unreadable("a reference to the objects of a pack has no single field; print the reference")
    return found[0]


def object_at(value, type_name, i):
    read = objects.of_array if type_name.startswith("physgen::Array<") else objects.of_view
    return read(value).object(i).value()


def field(name):
    """The method of a field, of an entry of a fixed array, or of a nested object."""

    def call(value, type_name, *entry):
        one = object_named(value, type_name)
        path = one.prefix + name
        for found in one.fields:
            if found.name == path and (not entry or 0 <= entry[0] < found.entries):
                return one.field(found, *entry)
        nested = path + (f"[{entry[0]}]" if entry else "") + "."
        inner = [found for found in one.fields if found.name.startswith(nested)]
        owner = one.tag[: -len("Object")]
        if not inner:
            raise Unreadable(f"{owner} has no {name}({', '.join(map(str, entry))})")
        tag = nested_tag(one, name)
        if tag is None:
            raise Unreadable(f"no value of {owner} is in this program, which would tell the type of {name}; print the whole object")
        return objects.Object(tag, one.real, inner, one.place, one.i, nested).value()

    return call


def nested_tag(one, name):
    """The tag of a nested object, by the type of the member of its owner's value."""
    value = fields.value_type(one.tag, one.real)
    of = fields.member(value, name)[0] if value is not None else None
    tag = re.sub(r"<.*", "", str(of)) + "Object"
    return tag if lookup(tag) is not None else None


class Worker(gdb.xmethod.XMethodWorker):
    """One method of a type, with so many arguments of type long."""

    def __init__(self, call, type_name, count):
        self.call, self.type_name, self.count = call, type_name, count

    def get_arg_types(self):
        return [gdb.lookup_type("long")] * self.count or None

    def get_result_type(self, *given):
        return self(*given).type

    def __call__(self, of, *indices):
        value = of.dereference() if of.type.strip_typedefs().code == gdb.TYPE_CODE_PTR else of
        try:
            return self.call(value, self.type_name, *map(int, indices))
        except (Unreadable, gdb.error, ValueError) as why:
            return gdb.Value(str(why))  # an exception would be shown as a fault of this script


class Matcher(gdb.xmethod.XMethodMatcher):
    """Finds the methods of a type by their name."""

    def __init__(self):
        super().__init__("physgen")
        self.methods = []  # they are not listed one by one

    def match(self, class_type, method_name):
        name = plain_name(class_type)
        if name.startswith(("physgen::Array<", "physgen::View<")):
            if method_name in ("operator[]", "get"):
                return Worker(object_at, name, 1)
            if method_name in ("view", "const_view") and name.startswith("physgen::Array<"):
                return Worker(lambda value, _name: value, name, 0)
        elif name.startswith("physgen::ObjectRef<") or is_tag(class_type.strip_typedefs()):
            if method_name == "get":
                return Worker(lambda value, name: object_named(value, name).value(), name, 0)
            if re.fullmatch(r"\w+", method_name) and method_name != "put":
                return [Worker(field(method_name), name, count) for count in (0, 1)]
        return None
