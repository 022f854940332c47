"""What import-linter does not check: no file imports itself round a corner, nor for types."""

from graphlib import CycleError, TopologicalSorter

import grimp


def test_no_files_import_each_other_in_a_circle():
    graph = grimp.build_graph("hapticplayer", "app")
    imports = {
        module: graph.find_modules_directly_imported_by(module)
        for module in graph.modules
    }
    try:
        TopologicalSorter(imports).prepare()
    except CycleError as found:
        circle = " -> ".join(reversed(found.args[1]))
        raise AssertionError(f"a circle of imports: {circle}") from None
