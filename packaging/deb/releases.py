"""Tell the metadata of a desktop the releases: `releases.py CHANGELOG.md METAINFO.xml`."""

import re
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

_RELEASE = re.compile(r"^## \[?(\d+\.\d+\.\d+)\]?.*?(\d{4}-\d{2}-\d{2})", re.MULTILINE)


def main(changelog: str, metainfo: str) -> None:
    tree = ET.parse(metainfo)  # noqa: S314 - our own
    releases = ET.SubElement(tree.getroot(), "releases")
    for version, date in _RELEASE.findall(Path(changelog).read_text(encoding="utf-8")):
        ET.SubElement(releases, "release", version=version, date=date)
    if len(releases):
        ET.indent(tree)
        tree.write(metainfo, encoding="utf-8", xml_declaration=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
