"""Damages the text of a schema, by tokens, characters and whole stretches."""
import re

TOKENS = ["struct", "PHYSGEN_OBJECT()", "PHYSGEN(unit(\"m\"))", "Scalar", "Vector<3>", "namespace", "{", "}", ";", "<", ">", "(", ")",
          "[", "]", "[[", "0", "-1", "1e400", "99999999999999999999", ",", "::", "*/", "/*", "//", "#define x y\n", "#include \"a\"\n",
          "#include __FILE__\n", "#if 1\n", "template <class T>", "using", "constexpr", "static", "= 3", "&", "*", "const", "\"", "'",
          "R\"(", "\\\n", "\0", "\ufeff", "λ", "operator", "enum", "union", "virtual", "friend", "decltype(", "sizeof", "__asm__",
          "_Pragma(\"once\")", "#error x\n", "#line 7 \"other.h\"\n", "__builtin_nan(\"\")", "alignas(8)", "try", "import", "module;\n",
          "#pragma clang diagnostic error \"-Weverything\"\n", "PHYSGEN", "PHYSGEN_OBJECT", "#undef PHYSGEN\n",
          "#define Scalar float\n", "[[clang::annotate(\"physgen.object\")]]", "[[clang::annotate(\"physgen.field\", 3)]]"]


def mutated(text, random):
    """The text with 1 to 8 changes."""
    for _ in range(random.choice([1, 1, 1, 2, 3, 8])):
        text = random.choice([by_token, by_token, by_token, by_character, by_stretch])(text, random)
    return text[:2_000_000]


def by_token(text, random):
    tokens = re.findall(r"\w+|\s+|[^\w\s]", text)
    if not tokens:
        return random.choice(TOKENS)
    at, other = random.randrange(len(tokens)), random.randrange(len(tokens))
    change = random.randrange(5)
    if change == 0:
        del tokens[at]
    elif change == 1:
        tokens[at], tokens[other] = tokens[other], tokens[at]
    elif change == 2:
        tokens[at] = random.choice(TOKENS)
    elif change == 3:
        tokens.insert(at, " " + random.choice(TOKENS) + " ")
    else:
        tokens.insert(at, tokens[other])
    return "".join(tokens)


def by_character(text, random):
    at = random.randrange(len(text) + 1)
    # Surrogates stand for bytes that are not UTF-8.
    new = random.choice([chr(random.randrange(1, 128)), chr(0xDC80 + random.randrange(128)), chr(random.randrange(0x100, 0x3000)), "\0"])
    return text[:at] + new + text[at + random.randrange(2):]


def by_stretch(text, random):
    begin, end = sorted(random.randrange(len(text) + 1) for _ in range(2))
    change = random.randrange(4)
    if change == 0:
        return text[:begin]
    if change == 1:
        return text[:begin] + text[end:]
    if change == 2:
        return text[:end] + text[begin:end] * random.choice([1, 2, 300]) + text[end:]
    bracket = random.choice(["(", "{", "[", "<", "namespace a {", "struct A {", "PHYSGEN("])
    return text[:begin] + bracket * random.choice([3, 300, 3000]) + text[begin:]
