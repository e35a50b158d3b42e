"""Cells of pages are run in their order, in an empty folder, and print what the pages say."""

import contextlib
import io
import os
import pathlib
import re

import pytest

BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
DOCS = pathlib.Path(os.environ["GNOMON_EXAMPLES"]).parent


@pytest.mark.parametrize("page", ["docs/python.md", "README.md"])
def test_cells_of_a_page_print_what_stands_below_them(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    blocks = BLOCK.findall((DOCS / page).read_text())
    names: dict[str, object] = {}
    cells = 0
    for (language, text), (following, expected) in zip(blocks, [*blocks[1:], ("", "")]):
        if language != "python":
            continue
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(text, page, "exec"), names)
        assert printed.getvalue() == (expected if following == "text" else ""), text
        cells += 1
    assert cells > 0
