#!/usr/bin/env python3
"""Checks that each link of a folder of HTML leads to a file and a place in it: check_links.py FOLDER. Prints those that do not,
and exits with 1."""
import html.parser
import pathlib
import sys
import urllib.parse

OF_DOXYGEN = {"#nested-classes"}  # its summary of a class template leads there even where no list of nested classes is

class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.links, self.places = set(), set()
        self.feed(file.read_text(encoding="utf-8", errors="replace"))

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if value and (key == "id" or (key == "name" and tag == "a")):
                self.places.add(value)
            elif value and key in ("href", "src"):
                self.links.add(value)


def main():
    folder = pathlib.Path(sys.argv[1])
    pages = {file.name: Page(file) for file in folder.glob("*.html")}
    if not pages:
        sys.exit(f"check_links.py: there is no page in {folder}")
    dead = []
    for name, page in sorted(pages.items()):
        for link in sorted(page.links):
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc or link in OF_DOXYGEN:
                continue
            file, place = urllib.parse.unquote(parts.path) or name, urllib.parse.unquote(parts.fragment)
            if not (folder / file).exists() or (place and file in pages and place not in pages[file].places):
                dead.append(f"{name}: {link}")
    print("\n".join(dead))
    print(f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links, {len(dead)} of them dead")
    sys.exit(1 if dead else 0)


if __name__ == "__main__":
    main()
