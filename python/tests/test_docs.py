"""The examples of README and package are what is printed."""

import doctest
import re
from pathlib import Path

import fitcheck

FOLDER = Path(__file__).parents[1]


def test_the_examples_of_the_package() -> None:
    assert doctest.testmod(fitcheck).failed == 0


def test_the_examples_of_the_readme() -> None:
    failed, tried = doctest.testfile(str(FOLDER / "README.md"), module_relative=False)
    assert failed == 0 and tried > 3


def test_the_programs_of_the_readme() -> None:
    blocks = re.findall(r"```python\n(.*?)```", (FOLDER / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    programs = [block for block in blocks if ">>>" not in block]
    assert programs
    for program in programs:
        exec(compile(program, "README.md", "exec"), {})


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
