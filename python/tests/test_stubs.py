"""The stub declares the names and arguments of the compiled module; modules export existing names."""

from __future__ import annotations

import ast
import importlib
import pkgutil
import re
from pathlib import Path
from typing import Any, Dict, List, Optional

import pytest

import burnish
from burnish import _core

STUB = ast.parse((Path(burnish.__file__).parent / "_core.pyi").read_text())
IN_STUB = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
CLASSES = {name: node for name, node in IN_STUB.items() if not name.startswith("_")}
MODULES = [info.name for info in pkgutil.walk_packages(burnish.__path__, "burnish.")
           if not info.name.rsplit(".", 1)[1].startswith("_")]


def functions(body: List[ast.stmt]) -> Dict[str, ast.FunctionDef]:
    return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}


def body_of(node: ast.ClassDef) -> List[ast.stmt]:
    """Returns the body of a class with those of base classes that exist only in the stub."""
    bases = [base.id for base in node.bases if isinstance(base, ast.Name) and base.id.startswith("_")]
    return [*node.body, *(line for base in bases for line in body_of(IN_STUB[base]))]


def arguments(node: ast.FunctionDef) -> List[str]:
    return [argument.arg for argument in node.args.args + node.args.kwonlyargs]


def bound_arguments(function: Any) -> Optional[List[str]]:
    """Returns the arguments that pybind11 writes into the first line of the docstring.

    None if the line has no arguments, or if the function has overloads."""
    first = (function.__doc__ or "").split("\n", 1)[0]
    match = re.match(r"\w+\((.*)\) -> ", first)
    if match is None or "*args" in first:
        return None
    text, depth, names = match[1], 0, []
    for part in re.split(r"(, |[\[\](){}<>])", text):
        if part in ("[", "(", "{", "<"):
            depth += 1
        elif part in ("]", ")", "}", ">"):
            depth -= 1
        elif depth == 0 and re.match(r"\w+: ", part):
            names.append(part.split(":", 1)[0])
    return names


def public(owner: Any) -> List[str]:
    return [name for name in vars(owner) if not name.startswith("_") and not hasattr(object, name)]


def test_stub_declares_every_compiled_name() -> None:
    in_stub = set(CLASSES) | set(functions(STUB.body))
    compiled = {name for name in public(_core) if not isinstance(getattr(_core, name), type(ast))}
    assert compiled - in_stub == set()
    assert in_stub - compiled == set()


def test_functions_have_the_arguments_of_the_stub() -> None:
    for name, node in functions(STUB.body).items():
        bound = bound_arguments(getattr(_core, name))
        assert bound is None or bound == arguments(node), name


@pytest.mark.parametrize("name", CLASSES)
def test_classes_have_the_members_of_the_stub(name: str) -> None:
    compiled = getattr(_core, name)
    in_stub = functions(body_of(CLASSES[name]))
    annotated = {node.target.id for node in body_of(CLASSES[name])
                 if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)}
    assert set(public(compiled)) == {n for n in in_stub if not n.startswith("_")} | {
        n for n in annotated if not n.startswith("_")}
    for member, node in in_stub.items():
        if member.startswith("__") and member != "__init__":
            continue  # called by position
        function = vars(compiled).get(member)
        bound = bound_arguments(function.__func__ if isinstance(function, staticmethod) else function)
        assert bound is None or bound == arguments(node), f"{name}.{member}"


@pytest.mark.parametrize("name", CLASSES)
def test_members_have_docstrings(name: str) -> None:
    compiled = getattr(_core, name)
    assert compiled.__doc__
    for member in public(compiled):
        text = getattr(vars(compiled)[member], "__doc__", None) or ""
        if text.startswith(member + "("):  # the signature
            text = text.partition("\n")[2]
        assert text.strip(), f"{name}.{member}"


@pytest.mark.parametrize("name", MODULES)
def test_exports_are_sorted_and_exist(name: str) -> None:
    module = importlib.import_module(name)
    assert module.__doc__
    assert module.__all__ == sorted(module.__all__)
    for exported in module.__all__:
        assert hasattr(module, exported), exported


def test_package_exports_everything_outside_its_namespaces() -> None:
    imports = [node for node in ast.parse(Path(burnish.__file__).read_text()).body
               if isinstance(node, ast.ImportFrom)]
    namespaces = {"burnish." + alias.name for node in imports if node.module is None
                  for alias in node.names}
    assert "burnish.residual" in namespaces
    for name in sorted(set(MODULES) - namespaces):
        module = importlib.import_module(name)
        for exported in module.__all__:
            assert getattr(burnish, exported) is getattr(module, exported), f"{name}.{exported}"
