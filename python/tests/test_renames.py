"""Names of version 0.3: refused with the new one in files, overrides, keywords, attributes; listed in docs; gone from
sources."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import pickle
import re
from pathlib import Path
from typing import Any, Dict, Iterator, List, Tuple

import pytest

import burnish
from burnish import _core, polishing, press_hold, push_wall, stand
from test_specs import DEFAULTED, ENUMS, SPECS

ROOT = Path(__file__).parents[2]
RENAMES: List[Tuple[str, str]] = _core.renames()
TASKS = {"polishing": polishing, "press_hold": press_hold, "push_wall": push_wall, "stand": stand}

KEYWORDS = [(name, old, new) for name in DEFAULTED for old, new in RENAMES
            if new in {f.name for f in dataclasses.fields(SPECS[name])}]


@pytest.mark.parametrize("name, old, new", KEYWORDS, ids=[f"{n}.{o}" for n, o, _ in KEYWORDS])
def test_old_keyword_is_refused_with_the_new_one(name: str, old: str, new: str) -> None:
    field_names = {f.name for f in dataclasses.fields(SPECS[name])}
    assert old not in field_names
    now = next(now for was, now in RENAMES if was == old and now in field_names)
    with pytest.raises(TypeError, match=f"'{old}' is now called '{now}'"):
        SPECS[name](**{old: 1.0})
    value = SPECS[name]()
    with pytest.raises(AttributeError, match=f"'{old}' is now called '{now}'"):
        setattr(value, old, 1.0)


MODEL = burnish.load_robot(str(ROOT / "robots/arm7")).model
PLANT = burnish.make_ideal_plant(MODEL, burnish.SceneSpec())
OWNERS: Dict[str, Any] = {"burnish": burnish, "burnish.model": burnish.model, "burnish.push_wall": push_wall,
                          "burnish.sim": burnish.sim, "burnish.model.Model": MODEL, "burnish.sim.Plant": PLANT, **ENUMS,
                          **SPECS}
ATTRIBUTES = [(name, old) for name, owner in OWNERS.items() for old in dict(RENAMES)
              if any(hasattr(owner, now) for was, now in RENAMES if was == old)]


@pytest.mark.parametrize("name, old", ATTRIBUTES, ids=[f"{n}.{o}" for n, o in ATTRIBUTES])
def test_old_attribute_is_refused_with_the_new_one(name: str, old: str) -> None:
    owner = OWNERS[name]
    now = next(now for was, now in RENAMES if was == old and hasattr(owner, now))
    assert not hasattr(owner, old)
    assert old not in dir(owner)
    with pytest.raises(AttributeError, match=f" has no attribute '{old}'; '{old}' is now called '{now}'$"):
        getattr(owner, old)


@pytest.mark.parametrize("name, old, new", KEYWORDS, ids=[f"{n}.{o}" for n, o, _ in KEYWORDS])
def test_old_entry_is_refused_with_the_new_one(name: str, old: str, new: str) -> None:
    value = SPECS[name]()
    assert hasattr(value, new)
    with pytest.raises(AttributeError, match=f" has no entry '{old}'; '{old}' is now called '"):
        getattr(value, old)


# Old attributes of Python that are neither keys nor columns.
PYTHON_NAMES = [
    ("burnish", "StatedJoint", "FileJoint"),
    ("burnish.model", "StatedJoint", "FileJoint"),
    ("burnish.model.Model", "stated_joints", "file_joints"),
    ("burnish.ocp.Penalty", "square", "quadratic"),
    ("burnish.ocp.PenaltyKind", "SQUARE", "QUADRATIC"),
    ("burnish.push_wall", "Lean", "ForceSearch"),
    ("burnish.push_wall.Limit", "MOST", "FORCE_MAX"),
    ("burnish.push_wall.Limit", "BEAR", "STATICS"),
    ("burnish.push_wall.Limit", "GIVE", "TRACKING"),
    ("burnish", "ToolTipSpec", "TouchSpec"),
    ("burnish.sim", "SupportSpec", "TouchSpec"),
    ("burnish.sim", "scene_under_tip", "with_surface_at"),
    ("burnish.sim.Plant", "contact_force_world", "wrenches"),
]


@pytest.mark.parametrize("name, old, new", PYTHON_NAMES)
def test_old_name_of_python_is_in_the_table(name: str, old: str, new: str) -> None:
    assert hasattr(OWNERS[name], new)
    assert (old, new) in RENAMES
    assert (name, old) in ATTRIBUTES


def test_old_entry_of_a_setting_is_refused_with_the_new_one() -> None:
    names = [field.name for field in dataclasses.fields(push_wall.Setting)]
    assert _core.did_you_mean("lean_end", names) == "; 'lean_end' is now called 'search_end'"


@pytest.mark.parametrize("name", ["burnish", "burnish.model.Model", "burnish.push_wall.Limit", "burnish.ocp.Penalty"])
def test_missing_attribute_without_a_new_name_is_an_attribute_error(name: str) -> None:
    owner = OWNERS[name]
    assert not hasattr(owner, "nothing")
    assert getattr(owner, "__nothing__", None) is None
    with pytest.raises(AttributeError, match=" has no attribute 'nothing'$"):
        getattr(owner, "nothing")
    assert "nothing" not in dict(inspect.getmembers(owner))


def test_owners_can_be_copied_and_pickled() -> None:
    for model in (copy.copy(MODEL), copy.deepcopy(MODEL), pickle.loads(pickle.dumps(MODEL))):
        assert repr(model) == repr(MODEL)
    member = push_wall.Limit.FORCE_MAX
    assert copy.deepcopy(member) is copy.copy(member) is pickle.loads(pickle.dumps(member)) is member
    assert push_wall.Limit["FORCE_MAX"] is push_wall.Limit(member.value) is member


def old_texts(text: str) -> Iterator[Tuple[str, str, str]]:
    """Yields the text with one key replaced by its old name, the old name and the new name."""
    for old, new in RENAMES:
        key = re.compile(rf"(^|[{{,] ?| ){new}: ", re.MULTILINE)
        for found in key.finditer(text):
            if "#" not in text[text.rfind("\n", 0, found.start()) + 1:found.start()]:
                yield text[:found.start(0)] + found[1] + old + ": " + text[found.end():], old, new


@pytest.mark.parametrize("task", TASKS)
def test_old_key_of_a_task_file_is_refused_with_the_new_one(task: str, tmp_path: Path) -> None:
    module = TASKS[task]
    text = module.task_text(module.Task())
    tried = 0
    for number, (old_text, old, new) in enumerate(old_texts(text)):
        file = tmp_path / f"{number}.yaml"
        file.write_text(old_text)
        if refused(module, file, f"'{old}' is now called '{new}'"):
            tried += 1
    assert tried >= {"polishing": 9, "press_hold": 0, "push_wall": 9, "stand": 6}[task]


def refused(module: object, file: Path, words: str) -> bool:
    """Returns true if the error names the new word. The test skips keys whose new name is valid elsewhere."""
    with pytest.raises(burnish.Error) as refusal:
        getattr(module, "read_task")(file)
    return words in str(refusal.value)


@pytest.mark.parametrize("old, now", [
    ("price: 3", "'price' is now called 'l1_weight'"),
    ("l1_weight: 3, square: 3", "'square' is now called 'quadratic_weight'"),
])
def test_old_key_of_a_problem_is_refused_with_the_new_one(old: str, now: str, tmp_path: Path) -> None:
    text = (ROOT / "examples/problems/reaching_within_limits.yaml").read_text()
    file = tmp_path / "problem.yaml"
    assert "l1_weight: 1000" in text
    file.write_text(text.replace("l1_weight: 1000", "l1_weight: 3, quadratic_weight: 3"))
    burnish.files.read_problem_file(file)
    file.write_text(text.replace("l1_weight: 1000", old))
    with pytest.raises(burnish.Error, match=now):
        burnish.files.read_problem_file(file)


def test_every_rename_is_documented() -> None:
    text = (ROOT / "docs/renames.md").read_text()
    rows: Dict[str, str] = {}
    for line in text.splitlines():
        cells = line.split("|")
        if line.startswith("| `"):
            for old in re.findall(r"`(\w+)`", cells[1]):
                rows[old] = rows.get(old, "") + cells[2]
    for old, new in RENAMES:
        if not old.startswith("believed_normal"):
            assert f"`{new}`" in rows[old], f"docs/renames.md says of '{old}': {rows[old]}"


# Private words of earlier versions, as parts of identifiers. Names of tests count, too.
PRIVATE = {
    "bend", "bends", "price", "prices", "priced", "boost", "boosted", "calm", "haste", "fading", "pace", "rub", "rubs",
    "rubbing", "bear", "bears", "bearing", "borne", "lean", "leans", "leaning", "remembered", "crew", "seam", "door",
    "doors", "believe", "believed", "believes", "told", "house",
}
SUFFIXES = {".cpp", ".hpp", ".tpp", ".h", ".py", ".pyi", ".ts", ".yaml", ".cmake"}
# Files about the old names, and inputs written by other programs.
EXEMPT = {"src/base/renames.cpp", "tests/base/renames_test.cpp", "tests/apps/report_test.cpp",
          "python/tests/test_golden.py", "python/tests/test_renames.py", "scripts/golden_runs.py"}


def code_of(path: Path) -> str:
    """Returns the text of a source without comments and without strings that contain sentences."""
    text = path.read_text(errors="replace")
    if path.suffix in {".cpp", ".hpp", ".tpp", ".h", ".ts"}:
        text = re.sub(r'"(?:[^"\\\n]|\\.)*[ ](?:[^"\\\n]|\\.)*"', '""', text)
        return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r'"""(?:.|\n)*?"""', '""', text)
    text = re.sub(r'"(?:[^"\\\n]|\\.)*[ ](?:[^"\\\n]|\\.)*"', '""', text)
    return re.sub(r"#[^\n]*", "", text)


def parts_of(identifier: str) -> List[str]:
    return [part.lower() for part in re.findall(r"[A-Z]?[a-z]+|[A-Z]+|\d+", identifier)]


def test_no_identifier_has_a_private_word() -> None:
    if not (ROOT / "include").is_dir():
        pytest.skip("the sources are not here")
    found = []
    for folder in ("include", "src", "tasks", "apps", "benchmarks", "tests", "python", "web", "examples", "scripts"):
        for path in sorted((ROOT / folder).rglob("*")):
            name = str(path.relative_to(ROOT))
            if path.suffix not in SUFFIXES or name in EXEMPT or "node_modules" in name or "fuzz/corpus" in name:
                continue
            for identifier in set(re.findall(r"[A-Za-z_]\w*", code_of(path))):
                if PRIVATE.intersection(parts_of(identifier)):
                    found.append(f"{name}: {identifier}")
    assert not found, "\n".join(found)
