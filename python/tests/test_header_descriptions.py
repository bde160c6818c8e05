"""Notation of member descriptions in headers: the result of reading it, and errors with file and line."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "header_descriptions.py"
if not SCRIPT.exists():
    pytest.skip("a package without its sources", allow_module_level=True)
_spec = importlib.util.spec_from_file_location("header_descriptions", SCRIPT)
assert _spec and _spec.loader
headers = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(headers)

HEAD = "namespace burnish {\nconst int size = 10'000;\n/// How it presses.\n/// @described contact\nstruct Press {\n"
END = "};\n}  // namespace burnish\n"


def read(tmp_path: Path, body: str):
    folder = tmp_path / "include/burnish/contact"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "press.hpp").write_text(HEAD + body + END)
    (found,) = headers.read_headers(tmp_path)[Path("src/contact")]
    return found


@pytest.mark.parametrize("comment, meaning, numbers", [
    ("Normal force to press with [N], > 0", "Normal force to press with [{N}]", "> 0"),
    ("[m/s], below which it fades, >= 0 or infinite", "{m/s}, below which it fades", ">= 0 or infinite"),
    ("Viscous friction [Nms/rad or Ns/m], >= 0", "Viscous friction [{Nms/rad or Ns/m}]", ">= 0"),
    ("> 0", "", "> 0"),
    ("Kept as it was. between 0 and 1", "Kept as it was.", "between 0 and 1"),
    ("[x, y, z] out of the material, not zero", "[x, y, z] out of the material", "not zero"),
    ('with units, such as "time [s]"', 'with units, such as "time [s]"', ""),
    ("of them, 0 to below 1", "of them", "0 to below 1"),
    ("ends when more than 3", "ends when more than 3", ""),
])
def test_comment_is_split_into_meaning_unit_and_range(tmp_path: Path, comment: str, meaning: str, numbers: str) -> None:
    (entry,) = read(tmp_path, f"  double force = 30.0;  ///< {comment}\n").entries
    assert (entry.name, entry.meaning, entry.range) == ("force", meaning, numbers)


def test_members_keep_their_order_and_functions_are_skipped(tmp_path: Path) -> None:
    press = read(tmp_path, """  std::map<std::string, double> ways = {};  ///< one by one @word none @key way
  // @section limits Beyond these
  // a run ends.
  int third = 3;  ///< @after second
  /// first of all, for
  /// each of them @after -
  std::vector<int> first{1, 2};
  int second = 2;  ///< @after first
  bool holds(double x) const { return x > 0.0; }  ///< of a number
  static constexpr int size = 3;
  Press& with(double x, double y);
  double hidden = 0.0;  ///< @undescribed
  Eigen::Vector3d last = Eigen::Vector3d::Zero();  ///< @required @more And so on. @note For readers.
""")
    assert [entry.name for entry in press.entries] == ["first", "second", "third", "ways", "last"]
    assert press.entries[0].meaning == "first of all, for each of them"
    assert press.entries[3].tags == {"word": "none", "key": "way"}
    assert press.entries[4].tags == {"required": "", "more": "And so on."}
    assert press.groups == [(1, "@section limits Beyond these a run ends.")]
    code = headers.description_code(press)
    assert '.group("Beyond these a run ends.", "limits")' in code and code.index(".group") < code.index('"first"') + 200


def test_values_of_an_enumeration_are_words(tmp_path: Path) -> None:
    folder = tmp_path / "src/contact"
    folder.mkdir(parents=True)
    (folder / "kind.hpp").write_text("namespace burnish {\nstruct Shape {\n  /// What it is.\n  /// @described contact.ShapeKind\n"
                                     "  enum class Kind { FlatPlane, Log6 };\n};\n}\n")
    (kind,) = headers.read_headers(tmp_path)[Path("src/contact")]
    assert (kind.cpp_name, kind.name, kind.is_enum) == ("Shape::Kind", "ShapeKind", True)
    assert [headers.word_of(entry.name) for entry in kind.entries] == ["flat_plane", "log6"]


@pytest.mark.parametrize("body, words", [
    ("  double a = 0.0, b = 1.0;\n", "press.hpp:6: several members in one statement"),
    ("  double a;  ///< Force to press with [N] > 0\n", "press.hpp:6: the range '] > 0' has no comma before it"),
    ("  double a;  ///< Damping of the tool [Nsm]\n", "press.hpp:6: '[Nsm]' is not a unit"),
    ("  double a;  ///< way @keys b\n", "press.hpp:6: unknown tag after @"),
    ("  double a;  ///< way @key\n", "press.hpp:6: @key needs a text"),
    ("  double a;  ///< way @required yes\n", "press.hpp:6: @required must not have a text"),
    ("  double a;\n  double b;  ///< @key x @key y\n", "press.hpp:7: @key occurs twice"),
    ("  /// @described contact\n  template <class T>\n  struct B {};\n", "press.hpp:7: @described is not before a struct"),
    ("  double a;  ///< @after b\n", "press.hpp:6: @after b: Press has no such member"),
])
def test_invalid_header_raises_with_file_and_line(tmp_path: Path, body: str, words: str) -> None:
    with pytest.raises(headers.HeaderError) as refused:
        read(tmp_path, body)
    assert words in str(refused.value)
