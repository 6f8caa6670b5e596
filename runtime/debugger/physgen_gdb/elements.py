"""What the bits of a stored element stand for: centre + scale * stored, in the precision that code computes with."""
import fractions
import math
import struct

WHOLE = {"int32": "int", "int64": "long", "uint64": "unsigned long", "boolean": "bool"}  # the type that gdb shows them as
BYTES = {"float32": 4, "float64": 8, "int32": 4, "int64": 8, "uint64": 8, "boolean": 1, "half": 2, "bfloat16": 2, "snorm16": 2, "none": 0}
CODES = {"float32": "f", "float64": "d", "int32": "i", "int64": "q", "uint64": "Q", "boolean": "B", "half": "e", "snorm16": "h"}
SNORM16_STEPS = 32767


def as_float(number):
    """The nearest float, as a Python number."""
    if not math.isfinite(number):
        return float(number)
    try:
        return struct.unpack("f", struct.pack("f", number))[0]
    except OverflowError:
        return math.copysign(math.inf, number)


def fma(a, b, c):
    """a * b + c, rounded once to double."""
    if not all(map(math.isfinite, (a, b, c))):
        return a * b + c
    return float(fractions.Fraction(a) * fractions.Fraction(b) + fractions.Fraction(c))


def snorm16(stored, scale, centre, rounded):
    low, high = (1e-290, 1e307) if rounded is float else (1e-30, 1e38)
    if stored == -SNORM16_STEPS - 1:
        return math.nan
    if not (scale >= low and scale + abs(centre) <= high):
        return rounded(fma(stored / SNORM16_STEPS, scale, centre))
    return rounded(fma(stored, rounded(rounded(scale) * rounded(1 / SNORM16_STEPS)), rounded(centre)))


def decode(type_name, memory, scale, centre, in_double):
    """The number that the bytes of an element stand for.

    type_name is the name of its ElementType; in_double says whether code computes with it in double."""
    if type_name == "bfloat16":
        stored = struct.unpack("f", b"\0\0" + memory)[0]
    else:
        stored = struct.unpack(CODES[type_name], memory)[0]
    if type_name in WHOLE:
        return stored
    rounded = float if in_double or type_name == "float64" else as_float
    if type_name == "snorm16":
        value = snorm16(stored, scale, centre, rounded)
    elif scale == 1 and centre == 0:
        value = stored
    elif centre == 0:
        value = rounded(stored * rounded(scale))
    else:
        value = rounded(fma(stored, rounded(scale), rounded(centre)))
    return value if in_double else as_float(value)


def rotation(quaternion, coarse):
    """The rows of the rotation matrix of w, x, y, z; of their direction, where they were rounded coarsely."""
    w, x, y, z = quaternion
    square = w * w + x * x + y * y + z * z
    if coarse and square == 0:
        return [[math.nan] * 3] * 3
    two = 2 / square if coarse else 2
    return [
        [1 - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)],
        [two * (x * y + w * z), 1 - two * (x * x + z * z), two * (y * z - w * x)],
        [two * (x * z - w * y), two * (y * z + w * x), 1 - two * (x * x + y * y)],
    ]


def rows(stored, shape):
    """The stored elements of a field as the rows of its matrix. shape is rows and columns, or None: a list is all that is known."""
    if shape is None:
        return [list(stored)]
    r, c = shape
    if len(stored) == r * c:
        return [[stored[j * r + i] for j in range(c)] for i in range(r)]
    skew = len(stored) == r * (r - 1) // 2  # else symmetric; triangles are stored column by column
    places = {}
    for j in range(c):
        for i in range(j + skew, r):
            places[i, j] = len(places)
    if r != c or len(places) != len(stored):
        raise ValueError(f"{len(stored)} stored elements are no {r}x{c} matrix")
    lower = [[stored[places[max(i, j), min(i, j)]] if (max(i, j), min(i, j)) in places else 0 for j in range(c)] for i in range(r)]
    return [[-lower[i][j] if skew and i < j else lower[i][j] for j in range(c)] for i in range(r)]
