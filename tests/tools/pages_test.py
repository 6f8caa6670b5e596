"""Tests of the pages of documentation: their links, their length, the files that they name, CONTRIBUTING.md's table of the
tree, WORDS.md's list, and the version that all state: pages_test.py"""
import pathlib
import re
import sys
import unittest

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import wrap_pages  # noqa: E402

BUILT = {"build", ".git", ".github"}  # the forge reads .github by itself
CODE = (".h", ".cpp", ".cu", ".py", ".sh", ".cmake", ".in", ".txt")  # endings of the files that pages name
NAME = re.compile(r"(?<![\w<*./-])(?:\.\./)*((?:[\w.-]+/)*[A-Za-z][\w.-]*\.(?:h|cpp|cu|py|sh|cmake|in|txt))\b(?![\w*/(])")
# Files of examples: a user's program and its schema, a scene, and those that one adds.
EXAMPLES = re.compile(
    r"pressure\.cpp|s\.scene\.h|integrate\.h|(.*/)?derivatives\..*|(schemas|(physgen/)?(layout|format))/x\.h|groups/GROUP\.cpp|(.*/)?x\.physgen\.h"
)
WORDS_A_MINUTE = 250
LOOKED_FOR = (
    *("schema", "field", "layout", "format", "shape", "element type", "diagnostic", "emitter", "scene"),
    *("material", "kernel", "benchmark row", "test"),
)


def pages():
    return [path for path in ROOT.rglob("*.md") if not BUILT & set(path.relative_to(ROOT).parts)]


def prose(text):
    """A page without its blocks of code and words in backticks, in which brackets are C++."""
    return re.sub(r"`[^`\n]*`", "", re.sub(r"(?ms)^ *```.*?^ *```", "", text))


def anchors(page):
    """Those that GitHub makes of a page's headings."""
    text = re.sub(r"(?ms)^ *```.*?^ *```", "", page.read_text(encoding="utf-8"))
    heads = [re.sub(r"`|\[([^]]*)\]\([^)]*\)", r"\1", head) for head in re.findall(r"(?m)^#+ (.*)$", text)]
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


def code(root):
    """The paths of files that pages may name."""
    files = [path for path in root.rglob("*") if path.suffix in CODE and not BUILT & set(path.relative_to(root).parts)]
    return [path.relative_to(root).as_posix() for path in files]


def unknown_files(text, known):
    """Names of files on a page that are the end of no path, and paths without an ending in its pictures."""
    names = [name for name in NAME.findall(text) if not EXAMPLES.fullmatch(name)]
    unknown = [name for name in names if not any(("/" + path).endswith("/" + name) for path in known)]
    for picture in re.findall(r"(?ms)^```\n(.*?)^```", text):
        if re.search(r"(?m)^ +(v|\|)$", picture):
            for name in re.findall(r"(?<![\w<*./-])[a-z_]+/[a-z_]+\b(?![\w*/.-])", picture):
                ends = tuple(f"/{name}{end}" for end in CODE)
                if not any(f"/{path}".endswith(ends) or f"/{name}/" in f"/{path}" for path in known):
                    unknown.append(name)
    return unknown


def unknown_words(text, known):
    """Words behind physgen:: on a page that no header and no file of CMake has."""
    return sorted({word for words in re.findall(r"\bphysgen::(\w+(?:::\w+)*)", text) for word in words.split("::")} - known)


def words_of_sources():
    """The words of headers that programs include, and of the files that name targets."""
    folders = ("runtime/include", "generated", "tools/fem", "generator/cmake", "tools/cmake")
    files = [path for folder in folders for path in (ROOT / folder).rglob("*")]
    texts = [path.read_text(encoding="utf-8") for path in files if path.suffix in (".h", ".cmake", ".in", ".txt")]
    return {word for text in texts for word in re.findall(r"\w+", text)}


def table(page, heading):
    """The rows of a page's first table below a heading, as lists of cells."""
    section = (ROOT / page).read_text(encoding="utf-8").split(f"# {heading}\n")[1].split("\n## ")[0]
    rows = [line.strip("|").split(" | ") for line in section.splitlines() if line.startswith("| ")]
    return [[cell.strip() for cell in row] for row in rows[1:]]


def dead_links(page):
    dead = []
    for link in re.findall(r"\]\(([^)\s]+)\)", prose(page.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = page.parent / path if path else page
        if not target.exists() or (anchor and anchor not in anchors(target)):
            dead.append(f"{page.relative_to(ROOT)} links to {link}")
    return dead


class PagesTest(unittest.TestCase):
    def test_links_lead_to_files_and_headings(self):
        found = pages()
        self.assertGreater(len(found), 10)
        self.assertEqual([dead for page in found for dead in dead_links(page)], [])

    def test_every_page_of_the_tree_is_reached_from_the_readme(self):
        reached, open_pages = set(), [ROOT / "README.md"]
        while open_pages:
            page = open_pages.pop()
            if page in reached:
                continue
            reached.add(page)
            for link in re.findall(r"\]\(([^)\s#]+)[^)]*\)", prose(page.read_text(encoding="utf-8"))):
                target = (page.parent / link).resolve()
                open_pages += [target / "README.md"] if target.is_dir() and (target / "README.md").exists() else []
                open_pages += [target] if target.suffix == ".md" and target.exists() else []
        self.assertEqual(sorted(str(page) for page in set(pages()) - reached), [])

    def test_files_that_pages_name_exist(self):
        known = code(ROOT)
        named = {page: unknown_files(page.read_text(encoding="utf-8"), known) for page in pages()}
        changes = ROOT / "CHANGELOG.md"  # whose tables have old names in their first column
        text = re.sub(r"^\| `[^`|]*` \| (?=`)", "| ", changes.read_text(encoding="utf-8"), flags=re.M)
        named[changes] = unknown_files(text, known)
        self.assertEqual({str(page): names for page, names in named.items() if names}, {})

    def test_a_file_that_is_gone_is_found_in_prose_and_in_pictures(self):
        text = "`kernels/absent.h` and `stress.h`\n```\nkernels/stress.h\n  |\n  v\nreport/absent_session\n```\n"
        self.assertEqual(unknown_files(text, code(ROOT)), ["kernels/absent.h", "report/absent_session"])

    def test_words_of_the_namespace_on_pages_exist(self):
        known = words_of_sources()
        named = {page: unknown_words(page.read_text(encoding="utf-8"), known) for page in pages()}
        self.assertEqual({str(page): words for page, words in named.items() if words}, {})

    def test_a_word_that_the_namespace_has_not_is_found(self):
        text = "`parallel_for(physgen::AbsentSpace, n)` and `physgen::fem::svd(F, U, s, V)`"
        self.assertEqual(unknown_words(text, words_of_sources()), ["AbsentSpace"])

    def test_the_walks_of_a_field_and_of_a_row_are_drawn(self):
        walks = {"generator": ("schemas/x.h", "object.cpp"), "tools/physbench": ("kernels/stress.h", "tools/report")}
        for page, ends in walks.items():
            text = (ROOT / page / "README.md").read_text(encoding="utf-8")
            pictures = re.findall(r"(?ms)^```\n(.*?)^```", text)
            self.assertTrue(any(all(end in picture for end in ends) for picture in pictures), page)

    def test_the_table_of_the_tree_has_a_place_for_every_word_that_is_looked_for(self):
        rows, places = table("CONTRIBUTING.md", "Where things live"), 0
        for word in LOOKED_FOR:
            of_word = [row[1] for row in rows if re.search(rf"\*\*{word}s?\*\*", row[0])]
            self.assertEqual(len(of_word), 1, word)
            paths = re.findall(r"`([\w./]+)`", of_word[0])
            self.assertTrue(paths, word)
        for row in rows:
            for path in [name for name in re.findall(r"`([\w./]+)`", row[1] + row[2]) if "/" in name]:
                self.assertTrue(any((ROOT / base / path).exists() for base in ("", "runtime/include/physgen")), path)
                places += 1
        self.assertGreater(places, 20)

    def test_the_page_of_the_set_up_names_each_of_its_stages(self):
        sources = [path.read_text(encoding="utf-8") for path in (ROOT / "tools").rglob("*") if path.suffix in (".h", ".cpp", ".cu")]
        stages = {name for text in sources for name in re.findall(r'InStage(?: \w+)?\("([^"]+)"\)', text)}
        self.assertGreater(len(stages), 20)
        page = (ROOT / "tools/truthcube/README.md").read_text(encoding="utf-8")
        section = re.search(r"(?ms)^## The set-up$.*?^## ", page)[0]
        self.assertEqual({name for name in stages if f"`{name}`" not in section}, set())

    def test_a_word_is_explained_once_in_one_list(self):
        words = [word for row in table("WORDS.md", "Words") for word in row[0].split(", ") if word]
        self.assertGreater(len(words), 30)
        self.assertEqual(sorted({word for word in words if words.count(word) > 1}), [])
        lists = [page for page in pages() if re.search(r"(?mi)^#+ (words|glossary|terms)$", page.read_text(encoding="utf-8"))]
        self.assertEqual(lists, [ROOT / "WORDS.md"])

    def test_the_readme_takes_minutes_and_shows_the_cube_first(self):
        text = (ROOT / "README.md").read_text(encoding="utf-8")
        self.assertLessEqual(len(text.split()), 700)
        self.assertLess(text.index("![A silicone cube"), text.index("\n## "))

    def test_lines_of_prose_fit_140_characters(self):
        places = {str(page): wrap_pages.wrapped(page.read_text(encoding="utf-8"))[1] for page in pages()}
        self.assertEqual({page: lines for page, lines in places.items() if lines}, {}, "tools/dev format wraps them")

    def test_wrapping_moves_words_to_the_next_line_and_leaves_code_and_tables(self):
        long = "- " + "word " * 27 + "`code that stays whole` and more"
        text = f"{long}\n  behind it.\n\n| {'cell ' * 40}|\n```\n{long}\n```\n"
        new, places = wrap_pages.wrapped(text)
        self.assertEqual(places, [1])
        self.assertEqual(new, f"- {'word ' * 26}word\n  `code that stays whole` and more behind it.\n" + text.split("\n", 2)[2])
        self.assertEqual(wrap_pages.wrapped(new), (new, []))

    def test_a_long_page_says_at_its_top_what_is_where(self):
        for page in pages():
            text = page.read_text(encoding="utf-8")
            if len(prose(text).split()) > 5 * WORDS_A_MINUTE:
                top = text.split("\n## ")[0]
                self.assertGreater(len(re.findall(r"\]\(#[^)]+\)", top)), 2, f"{page} has no list of its headings at its top")

    def test_headers_changelog_and_citation_agree_on_the_version(self):
        text = {name: (ROOT / name).read_text(encoding="utf-8") for name in ("CHANGELOG.md", "CITATION.cff", "CMakeLists.txt")}
        header = (ROOT / "runtime/include/physgen/version.h").read_text(encoding="utf-8")
        version = re.search(r'PHYSGEN_VERSION "(\d+)\.(\d+)\.(\d+)"', header)
        major, minor, patch = (int(part) for part in version.groups())
        number = int(re.search(r"PHYSGEN_VERSION_NUMBER (\d+)", header)[1])
        self.assertEqual(number, 10000 * major + 100 * minor + patch)
        self.assertEqual(re.search(r"(?m)^## (.*)$", text["CHANGELOG.md"])[1], f"{major}.{minor}.{patch}")
        self.assertEqual(re.search(r"(?m)^version: (.*)$", text["CITATION.cff"])[1], f"{major}.{minor}.{patch}")
        self.assertIn("project(physgen VERSION ${version} ", text["CMakeLists.txt"])

    def test_a_dead_link_is_found(self):
        page = ROOT / "tests" / "tools" / "pages_test.md"
        page.write_text("[a](absent.md) [b](../../README.md#no-such-heading) [c](../../README.md#pages)\n", encoding="utf-8")
        try:
            self.assertEqual(len(dead_links(page)), 2)
        finally:
            page.unlink()


if __name__ == "__main__":
    unittest.main()
