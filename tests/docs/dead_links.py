"""dead_links.py FOLDER: fails if a page there, or a page in its folder docs, links to a file that is not there."""

import pathlib
import re
import sys

folder = pathlib.Path(sys.argv[1])
pages = [*folder.glob("*.md"), *folder.glob("docs/*.md")]
dead = [f"{page}: {target}" for page in pages
        for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", page.read_text(encoding="utf-8"))
        if "://" not in target and not (page.parent / target).exists()]
print("\n".join(dead) or f"{len(pages)} pages")
sys.exit(bool(dead) or not pages)
