"""Does what a page tells its reader to do: run_page.py PAGE.md [EXAMPLES [PATTERN]]

In an empty folder, in the page's order: a code block that follows a line "`FILE`:" is saved as FILE, and a block of the
language `sh` is run by a shell that stops at the first command that fails. EXAMPLES and the folder of the page are linked there as `examples` and `docs`.
With a PATTERN only those lines of `sh` blocks are run that begin with a match of that regular expression.
"""

import os
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"(?:^`(?P<file>[^`\n]+)`:\n\n)?^```(?P<language>\w*)\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL)


def save(folder, name, text):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def run(folder, text):
    print(text, end="", flush=True)
    if subprocess.run(["sh", "-e", "-c", text], cwd=folder, stdin=subprocess.DEVNULL).returncode != 0:
        sys.exit(f"run_page.py: this failed:\n{text}")


def main(page, examples=None, pattern=""):
    with open(page, encoding="utf-8") as file:
        blocks = list(BLOCK.finditer(file.read()))
    ran = 0
    with tempfile.TemporaryDirectory(prefix="gnomon-page-") as folder:
        if examples:
            os.symlink(examples, os.path.join(folder, "examples"))
            os.symlink(os.path.dirname(os.path.abspath(page)), os.path.join(folder, "docs"))
        for block in blocks:
            if block["file"]:
                save(folder, block["file"], block["text"])
            elif block["language"] == "sh":
                lines = block["text"].splitlines(keepends=True)
                text = "".join(line for line in lines if re.match(pattern, line))
                if text:
                    run(folder, text)
                    ran += 1
    if ran == 0:
        sys.exit(f"run_page.py: {page} has no commands")


main(*sys.argv[1:])
