"""Names of version 0.3: refused with the new one in files, overrides and keywords; listed in docs; gone from sources."""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path
from typing import Dict, Iterator, List, Tuple

import pytest

import burnish
from burnish import _core, polishing, press_hold, push_wall, stand
from test_specs import DEFAULTED, SPECS

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
