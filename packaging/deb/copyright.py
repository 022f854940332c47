"""The copyright file of the package: `copyright.py LICENSE LIBRARIES` writes it to stdout.

Own licence first, then what each library in the folder says of itself and where its
licence texts lie.
"""

import sys
from collections.abc import Iterator
from importlib.metadata import Distribution, distributions
from pathlib import Path

PLACE = "/usr/lib/hapticplayer/lib"


def libraries(folder: Path) -> Iterator[tuple[str, Distribution]]:
    for path in sorted(folder.glob("common")) + sorted(folder.glob("*/site-packages")):
        where = f"{PLACE}/{path.relative_to(folder)}"
        found = distributions(path=[str(path)])
        for one in sorted(found, key=lambda one: one.metadata["Name"].lower()):
            if one.metadata["Name"] != "hapticplayer":
                yield where, one


def licence(one: Distribution) -> str:
    """In one word or the first line."""
    said = one.metadata.get("License-Expression") or one.metadata.get("License")
    classes = [
        text.rpartition("::")[2].strip()
        for text in one.metadata.get_all("Classifier") or ()
        if text.startswith("License ::")
    ]
    return (said or ", ".join(classes) or "see its licence file").splitlines()[0]


def main(own: str, folder: str) -> None:
    print("hapticplayer\n")
    print(Path(own).read_text(encoding="utf-8"))
    print(
        "It comes with these libraries, unchanged; the text of each licence is in the"
    )
    print("folder NAME-VERSION.dist-info beside it, and of the GPL, LGPL and Apache")
    print("licences in /usr/share/common-licenses.\n")
    for where, one in libraries(Path(folder)):
        print(f"{one.metadata['Name']} {one.version}: {licence(one)}")
        print(f"    {where}")


if __name__ == "__main__":
    main(*sys.argv[1:])
