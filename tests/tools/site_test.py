"""Tests of the site of documentation: how pages are given to Doxygen, which dead links are found, and the whole site: site_test.py"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
ROOT = pathlib.Path(__file__).resolve().parents[2]
SITE = ROOT / "tools" / "site"
sys.path.insert(0, str(SITE))
import header_filter  # noqa: E402
import page_filter  # noqa: E402


def filtered(text):
    return page_filter.filtered("tools/README.md", text, {"tools/README.md", "runtime/README.md"})


class PageFilterTest(unittest.TestCase):
    def test_headings_have_names_of_their_page(self):
        self.assertEqual(
            filtered("# Tools\n\n## In a `debugger`\n"),
            "# Tools {#tools_readme}\n\n## In a `debugger` {#tools_readme_in_a_debugger}\n",
        )

    def test_links_lead_to_pages_and_headings(self):
        self.assertEqual(filtered("[a](../runtime/README.md)"), "[a](@ref runtime_readme)")
        self.assertEqual(filtered("[a\nb](../runtime/README.md#which-one)"), "[a b](@ref runtime_readme_which_one)")
        self.assertEqual(filtered("[`a`](#here)"), "[`a`](@ref tools_readme_here)")

    def test_a_link_to_what_the_site_lacks_is_its_text(self):
        self.assertEqual(filtered("see [the list](packages.txt)."), "see the list.")

    def test_links_out_of_the_tree_stay(self):
        self.assertEqual(filtered("[a](https://example.org/b.md)"), "[a](https://example.org/b.md)")

    def test_pictures_are_found_by_their_names(self):
        self.assertEqual(filtered("![a cube](report/cube.png)"), "![a cube](cube.png)")

    def test_code_stays(self):
        for text in ("```\n# no heading\n[a](../runtime/README.md)\n```\n", "`f[i](../runtime/README.md)`", "`a\nb[i](#c)`"):
            self.assertEqual(filtered(text), text)


class HeaderFilterTest(unittest.TestCase):
    def test_the_lines_at_the_top_describe_the_file(self):
        text = header_filter.filtered("// Runs <k>:\n//   #include <k>\n// #3.\n#pragma once\n// of no one\n")
        self.assertEqual(
            text, "/// @file\n/// Runs &lt;k>:\n///\n///        #include <k>\n/// \\#3.\n\n#pragma once\n// of no one\n"
        )

    def test_a_range_ends_no_sentence(self):
        self.assertEqual(header_filter.filtered("/// Of 0 .. n-1.\nf(\" .. \");\n"), "/// Of 0 &hellip; n-1.\nf(\" .. \");\n")


class LinksTest(unittest.TestCase):
    def checked(self, **pages):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in pages.items():
                (pathlib.Path(folder) / f"{name}.html").write_text(text)
            done = subprocess.run([SITE / "check_links.py", folder], capture_output=True, text=True)
            return done.returncode, done.stdout

    def test_links_that_lead_somewhere_pass(self):
        self.assertEqual(self.checked(a='<a href="b.html#c">', b='<p id="c"><a href="https://example.org">')[0], 0)

    def test_a_missing_file_and_a_missing_place_are_named(self):
        status, text = self.checked(a='<a href="c.html"><img src="d.png">', b='<a href="a.html#e">')
        self.assertEqual(status, 1)
        for line in ("a.html: c.html", "a.html: d.png", "b.html: a.html#e"):
            self.assertIn(line + "\n", text)

    def test_a_folder_without_pages_is_refused(self):
        self.assertEqual(self.checked()[0], 1)


class SiteTest(unittest.TestCase):
    def test_the_site_has_pages_headers_and_a_search_and_no_dead_link(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([SITE / "make.sh", folder], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            html = pathlib.Path(folder) / "html"
            self.assertIn("parallel_for", (html / "parallel__for_8h.html").read_text())
            self.assertIn("pitch", (html / "words.html").read_text())
            self.assertTrue(list((html / "search").glob("functions_*.js")))
            detail = [file.name for file in html.glob("*detail*")]
            self.assertEqual(detail, [], "what is private has no page")


if __name__ == "__main__":
    unittest.main()
