"""The tables of documents are those of the registries."""

from tools import tables


def test_tables_of_documents_are_current():
    changed = [page.name for page in tables.changed_documents()]
    assert not changed, "run: python -m tools.tables"


def test_every_table_stands_in_a_document():
    pages = sorted((tables.ROOT / "docs").glob("*.md"))
    text = "".join(page.read_text(encoding="utf-8") for page in pages)
    assert not [name for name in tables.TABLES if f"<!-- table: {name} -->" not in text]
