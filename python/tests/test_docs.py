"""The examples of README and package are what is printed."""

import ast
import doctest
import json
import re
from pathlib import Path

import fitcheck
import pytest

FOLDER = Path(__file__).parents[1]


def test_the_examples_of_the_package() -> None:
    assert doctest.testmod(fitcheck).failed == 0


def test_the_examples_of_the_readme() -> None:
    failed, tried = doctest.testfile(str(FOLDER / "README.md"), module_relative=False)
    assert failed == 0 and tried > 3


@pytest.mark.parametrize("page", [FOLDER / "README.md", FOLDER.parent / "docs" / "manual" / "own-programs.md"])
def test_the_programs_of_the_documents(page: Path) -> None:
    blocks = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    programs = [block for block in blocks if ">>>" not in block]
    assert programs
    for program in programs:
        exec(compile(program, page.name, "exec"), {})


def test_every_name_has_its_types() -> None:
    types = (Path(fitcheck.__file__).parent / "__init__.pyi").read_text(encoding="utf-8")
    for name in fitcheck.__all__:
        assert re.search(rf"^(class|def) {name}\b", types, re.MULTILINE), name
        thing = getattr(fitcheck, name)
        if isinstance(thing, type):
            own = [own for own in vars(thing) if not own.startswith("_")]
            body = re.split(r"\n(?=class |def )", types[re.search(rf"^class {name}\b", types, re.MULTILINE).start() :])[0]
            for own in own:
                assert re.search(rf"\b{own}\b", body), f"{name}.{own}"


def test_help_says_what_the_types_say() -> None:
    types = ast.parse((Path(fitcheck.__file__).parent / "__init__.pyi").read_text(encoding="utf-8"))
    functions = [node for node in types.body if isinstance(node, ast.FunctionDef)]
    assert len(functions) == 8
    for function in functions:
        assert getattr(fitcheck, function.name).__doc__ == ast.get_docstring(function), function.name


def test_the_notebook_runs_from_its_first_cell_to_its_last() -> None:
    cells = json.loads((FOLDER / "ten_minutes.ipynb").read_text(encoding="utf-8"))["cells"]
    programs = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    names: dict[str, object] = {}
    for number, program in enumerate(programs):
        exec(compile(program, f"cell {number}", "exec"), names)
    assert names["verdict"].status == fitcheck.Status.RE_MEASURE
    assert names["judged"]["status"].to_list() == ["GOOD", "SCRAP", "REWORK", "GOOD", None, "REWORK"]
    assert names["found"].count == 80
