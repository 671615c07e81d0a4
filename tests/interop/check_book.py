"""Follows every link of a built book: files, pages and the headings that fragments name.

    check_book.py BOOK SOURCES

BOOK is the folder that mdBook has written, SOURCES the folder of its chapters. Links that leave the book must
name files of the repository. Prints what leads nowhere; exit code 1 if anything does.
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """Names that links can lead to, and the links."""

    def __init__(self, path):
        super().__init__()
        self.names, self.links = set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.names.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


def leads_nowhere(page, link, book, pages, sources):
    """What is wrong with a link of a page, or None."""
    parts = urlsplit(link)
    if parts.scheme or parts.netloc:
        return None
    target = (page.parent / unquote(parts.path)).resolve() if parts.path else page
    if not target.is_relative_to(book):
        # chapters and pages lie in folders of the same shape
        target = (sources / page.parent.relative_to(book) / unquote(parts.path)).resolve()
        return None if target.exists() else "no such file in the repository"
    if target not in pages:
        return None if target.exists() else "no such file in the book"
    if parts.fragment and unquote(parts.fragment) not in pages[target].names:
        return "no such heading"
    return None


def main():
    book, sources = (Path(argument).resolve() for argument in sys.argv[1:3])
    # print.html repeats all chapters in one page, toc.html serves readers without scripts
    pages = {path: Page(path) for path in sorted(book.rglob("*.html")) if path.name not in ("print.html", "toc.html")}
    followed, wrong = 0, 0
    for path, page in pages.items():
        # the page of errors is shown at any address
        for link in page.links if path.name != "404.html" else []:
            followed += 1
            fault = leads_nowhere(path, link, book, pages, sources)
            if fault:
                wrong += 1
                print(f"{path.relative_to(book)}: {link}: {fault}")
    print(f"{len(pages)} pages, {followed} links, {wrong} lead nowhere")
    if wrong or not followed:
        sys.exit(1)


main()
