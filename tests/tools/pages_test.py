"""Tests of the pages of documentation: where their links lead, and what README.md says of the tree: pages_test.py"""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILT = {"build", ".git"}


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

    def test_what_the_table_of_the_tree_names_exists(self):
        table = (ROOT / "README.md").read_text(encoding="utf-8").split("## Where things live")[1].split("\n## ")[0]
        names = [name for name in re.findall(r"`([\w./]+)`", table) if "/" in name]
        self.assertGreater(len(names), 20)
        missing = [name for name in names if not any((ROOT / base / name).exists() for base in ("", "runtime/include/physgen"))]
        self.assertEqual(missing, [])

    def test_a_dead_link_is_found(self):
        page = ROOT / "tests" / "tools" / "pages_test.md"
        page.write_text("[a](absent.md) [b](../../README.md#no-such-heading) [c](../../README.md#words)\n", encoding="utf-8")
        try:
            self.assertEqual(len(dead_links(page)), 2)
        finally:
            page.unlink()


if __name__ == "__main__":
    unittest.main()
