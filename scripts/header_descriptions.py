"""Reads descriptions of specifications from headers, and generates C++ from them.

A struct or enumeration is described if the comment above it contains `@described LAYER`. The text before this tag is
its meaning; the text after it is only for readers of the header. `@described LAYER.NAME` defines a name that differs
from the name in C++. `@result` after it marks a result of the library. Each member must be a separate statement:

    double force = 30.0;  ///< Normal force to press with [N], > 0

A unit is in brackets, or in braces if the text has other brackets. After a comma, a text ends with the range of its
value: `> 0`, `>= 0`, `0 to 1`, `0 to below 1`, `between 0 and 1`, `not zero` (for a vector), each optionally with
` or infinite`, or `finite or infinite`. These tags can follow, in any order:

    @key NAME      key in files; default: the name of the member
    @word WORD     word in files for a missing or infinite value
    @more TEXT     second sentence in docs, Python and C++, which comments in files omit
    @code TEXT     text in docs, Python and C++ in place of the first text, which files keep
    @required      no default in Python
    @stated        no default in files
    @name_of KIND  for a text or a list of texts: names of frames, joints or contacts of the model
    @words WORDS   for a count: words in files for 0, 1, ...
    @number_too    for a vector: Python accepts one number for all entries
    @after NAME    the member follows the member NAME in files and Python, independent of its place in C++
    @undescribed   the member exists only in C++
    @note TEXT     text only for readers of the header

`// @section KEY TEXT` before a member begins a section of files, which ends at the next section; `// @section -` returns
to the top level. `// @group TEXT` begins a group of members. Unknown tags, unknown units at the end of a text, and
ranges without a comma raise HeaderError with file and line."""

import keyword
import pathlib
import re
import textwrap

NUMBER = r"-?\d+\.?\d*(?:e-?\d+)?"
RANGE = re.compile(rf"(?:^|, |(?<=[.)]) )((?:>=? {NUMBER}|{NUMBER} to (?:below )?{NUMBER}|between {NUMBER} and {NUMBER}"
                   r"|finite|not zero)(?: or infinite)?)$")
LOST = re.compile(rf"[>\]}}] ?(?:[<>]=? ?{NUMBER}|\(.*[<>].*\))$")  # a range without its comma
UNIT_WORDS = {"m", "s", "kg", "N", "Nm", "Ns", "Nms", "rad", "Hz", "W", "J", "V", "A", "sqrt", "degrees", "deg", "bit", "us", "ms", "mm"}
BARE = ("required", "stated", "number_too", "undescribed")
TAGS = re.compile(rf"\s*@(more|code|key|word|words|name_of|after|note|{'|'.join(BARE)})\b\s*")


class HeaderError(Exception):
    pass


def is_unit(text):
    words = re.findall(r"[A-Za-z]+", text.replace(" or ", " "))
    return bool(words or text.startswith("1/")) and all(word in UNIT_WORDS for word in words) and not re.search(r"[,;:]", text)


def meaning_of(text):
    """Text in the format of descriptions: the unit is in braces, and after a sentence in brackets too."""
    for match in re.finditer(r"\[([^\[\]]*)\]", text):
        if is_unit(match[1]) and "{" not in text and text.count('"', 0, match.start()) % 2 == 0:
            unit = f"{{{match[1]}}}" if match.start() == 0 else f"[{{{match[1]}}}]"
            return text[: match.start()] + unit + text[match.end() :]
    return text


def range_code(text):
    """C++ initializer of a Range, from the text of a range."""
    words = text.removesuffix(" or infinite").split()
    parts = {}
    if words[0] in (">", ">="):
        parts = {"least": words[1], "open": "true" if words[0] == ">" else None}
    elif words[0] == "between":
        parts = {"least": words[1], "most": words[3], "open": "true"}
    elif words[0] == "not":
        parts = {"direction": "true"}
    elif words[0] != "finite":
        parts = {"least": words[0], "most": words[-1], "below": "true" if "below" in words else None}
    if text.endswith(" or infinite"):
        parts["infinite"] = "true"
    return "{" + ", ".join(f".{name} = {value}" for name, value in parts.items() if value) + "}"


class Entry:
    """Member of a struct, or value of an enumeration."""

    def __init__(self, name, comment, where):
        self.name, self.where = name, where
        parts = TAGS.split(comment)
        self.meaning, self.range, self.tags = parts[0].strip(), "", {}
        for tag, value in zip(parts[1::2], parts[2::2]):
            if tag in self.tags:
                raise HeaderError(f"{where}: @{tag} occurs twice")
            if (tag in BARE) == bool(value.strip()):
                raise HeaderError(f"{where}: @{tag} {'must not have a' if value.strip() else 'needs a'} text")
            self.tags[tag] = value.strip()
        self.tags.pop("note", None)
        if "@" in re.sub(r"`[^`]*`", "", self.meaning):
            raise HeaderError(f"{where}: unknown tag after @; wanted a tag of scripts/header_descriptions.py")
        if found := RANGE.search(self.meaning):
            self.range, self.meaning = found[1], self.meaning[: found.start()]
        if (lost := LOST.search(self.meaning)) and not self.range:
            raise HeaderError(f"{where}: the range '{lost[0].strip()}' has no comma before it; wanted for example ', > 0'")
        if (lost := re.search(r"\[[A-Za-z0-9^/]+\]$", self.meaning)) and not is_unit(lost[0][1:-1]):
            raise HeaderError(f"{where}: '{lost[0]}' is not a unit; known units are {', '.join(sorted(UNIT_WORDS))}")
        self.meaning = meaning_of(self.meaning).replace("\\n", "\n")


class Described:
    """Described struct or enumeration of a header."""

    def __init__(self, head, cpp_name, namespace, path, line):
        self.where, self.path, self.namespace, self.cpp_name = f"{path}:{line}", path, namespace, cpp_name
        before, _, behind = head.partition("@described")
        words = behind.split()
        if not words:
            raise HeaderError(f"{self.where}: @described needs a layer")
        self.layer, _, other = words[0].partition(".")
        self.name = other or cpp_name.rpartition("::")[2]
        self.is_result = words[1:2] == ["@result"]
        self.meaning = " ".join(before.split())
        self.entries, self.groups, self.is_enum = [], [], False


class Scanner:
    """Splits the text of a header into statements with their comments."""

    def __init__(self, path, name):
        self.text, self.name, self.at = path.read_text(), name, 0
        self.described, self.namespace, self.types = [], "", []

    def line(self, at=None):
        return self.text.count("\n", 0, self.at if at is None else at) + 1

    def refuse(self, what):
        raise HeaderError(f"{self.name}:{self.line()}: {what}")

    def comment(self):
        """Reads a comment line; returns its mark (`//`, `///` or `///<`) and its text."""
        end = self.text.find("\n", self.at)
        raw = self.text[self.at : end if end >= 0 else len(self.text)]
        mark = re.match(r"///<|///|//", raw)[0]
        self.at += len(raw)
        return mark, raw[len(mark) :].strip()

    def block(self, of=None):
        """Reads up to the closing brace of a block. Its statements are entries of `of`, if that is described."""
        doc, notes, last = [], [], None
        while self.at < len(self.text):
            rest = self.text[self.at :]
            if space := re.match(r"\s+", rest):
                if space[0].count("\n") > 1:
                    doc = []
                self.at += space.end()
            elif rest.startswith("//"):
                mark, text = self.comment()
                if mark == "///<" and last is not None:
                    last[1].append(text)
                elif mark == "///":
                    doc.append(text)
                elif of is not None and (text.startswith("@") or (notes and mark == "//")):
                    notes.append(text)
            elif rest.startswith("#"):
                self.at += re.match(r"(?:.*\\\n)*.*", rest).end()
            elif rest.startswith("}"):
                break
            else:
                begin = self.at
                statement, inner = self.statement(doc, of)
                if inner is None and any(line.startswith("@described") for line in doc):
                    raise HeaderError(f"{self.name}:{self.line(begin)}: @described is not before a struct or an enumeration")
                if of is not None and inner is None:
                    last = self.entry(of, statement, doc, notes, begin)
                doc, notes = [], notes if of is not None and inner else []
        if of is not None:
            self.finish(of)

    def entry(self, of, statement, doc, notes, begin):
        """Adds the member or enumerator of a statement; returns None for functions, static members and types."""
        if of.is_enum:
            name = re.match(r"\w+", statement)[0]
        else:
            plain = statement
            while (shorter := re.sub(r"<[^<>]*>", "", plain)) != plain:
                plain = shorter
            several = "," in re.sub(r"\{.*\}|\(.*\)|\[.*\]|\"(?:[^\"\\]|\\.)*\"", "", plain, flags=re.DOTALL)
            plain = re.split(r"=|\{", plain)[0].rstrip("; \n")
            if re.match(r"(static|using|friend|template|typedef|explicit|virtual|operator|public:|private:)\b", plain) or "(" in plain or "operator" in plain:
                return None
            if several:
                raise HeaderError(f"{self.name}:{self.line(begin)}: several members in one statement; wanted one, because "
                                  f"{of.cpp_name} is described")
            name = re.search(r"\w+$", plain)[0]
        if notes:
            of.groups.append((len(of.entries), " ".join(notes)))
        raw = (name, list(doc), self.line(begin))
        of.entries.append(raw)
        return raw

    def finish(self, of):
        entries = [Entry(name, " ".join(doc), f"{self.name}:{line}") for name, doc, line in of.entries]
        hidden = [i for i, entry in enumerate(entries) if "undescribed" in entry.tags]
        of.groups = [(at - sum(i < at for i in hidden), text) for at, text in of.groups]
        of.entries = [entry for entry in entries if "undescribed" not in entry.tags]
        moved = [entry for entry in of.entries if "after" in entry.tags]
        of.entries = [entry for entry in of.entries if "after" not in entry.tags]
        while moved:
            names = ["-", *(entry.name for entry in of.entries)]
            next_one = next((entry for entry in moved if entry.tags["after"] in names), None)
            if next_one is None:
                raise HeaderError(f"{moved[0].where}: @after {moved[0].tags['after']}: {of.cpp_name} has no such member")
            of.entries.insert(names.index(next_one.tags.pop("after")), next_one)
            moved.remove(next_one)

    def statement(self, doc, of):
        """Reads a statement; returns its text, and True for a type or namespace with inner statements, else None."""
        begin, depth = self.at, 0
        while self.at < len(self.text):
            c = self.text[self.at]
            if self.text.startswith("//", self.at):
                if of is not None and of.is_enum and depth == 0:
                    break
                self.comment()
                continue
            if c == '"' or (c == "'" and not self.text[self.at - 1].isalnum()):  # not the separator in 10'000
                self.at += re.match(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'|.', self.text[self.at :]).end()
                continue
            if c == "{" and depth == 0:
                head = " ".join(self.text[begin : self.at].split())
                if found := re.match(r"(namespace|struct|class|enum class|enum|extern \"C\")\b ?([\w:]*)", head):
                    self.inside(found[1], found[2], head, doc)
                    return head, True
            depth += c in "({["
            depth -= c in ")}]"
            self.at += 1
            if depth == 0 and (c == ";" or (of is not None and of.is_enum and c == ",")):
                break
            if depth == 0 and c == "}" and not re.match(r"\s*[;,)(.{]", self.text[self.at :]):
                break  # end of a function
            if depth < 0:
                self.at -= 1
                break
        return self.text[begin : self.at].strip(), None

    def inside(self, kind, name, head, doc):
        line = self.line()
        self.at += 1
        described = None
        text = " ".join(doc)
        if kind == "namespace":
            self.namespace, outer = name or self.namespace, self.namespace
        elif "@described" in text:
            described = Described(text, "::".join([*self.types, name]), self.namespace, self.name, line)
            described.is_enum = kind.startswith("enum")
            self.described.append(described)
        self.types += [name] if kind != "namespace" else []
        self.block(described)
        del self.types[len(self.types) - (kind != "namespace"):]
        if not self.text.startswith("}", self.at):
            self.refuse(f"'{head}' does not end")
        self.at += 1
        if kind == "namespace":
            self.namespace = outer
        elif semicolon := re.match(r"[^;{}]*;", self.text[self.at :]):
            self.at += semicolon.end()


def word_of(enumerator):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", enumerator).lower()


def folder_of(path):
    """Folder of the sources of a header's layer, relative to the root."""
    parts = path.parts
    if parts[0] != "include":
        return path.parent
    return pathlib.Path(*parts[2:4]) if parts[2] == "tasks" else pathlib.Path("src", parts[2])


def read_headers(root):
    """Described structs and enumerations of all headers, by the folder of the sources of their layer."""
    layers = {}
    for top in ("include/burnish", "src", "tasks"):
        for path in sorted((root / top).rglob("*.hpp")):
            if "/// @described" not in path.read_text():
                continue
            name = path.relative_to(root)
            scanner = Scanner(path, str(name))
            scanner.block()
            if len(scanner.described) != scanner.text.count("/// @described"):
                scanner.refuse("a '@described' of this file was not found by the scanner")
            layers.setdefault(folder_of(name), []).extend(scanner.described)
    return layers


def included(root, path, seen):
    """Headers of the repository that a header includes, directly or indirectly."""
    for name in re.findall(r'^#include "([^"]+)"', (root / path).read_text(), re.MULTILINE):
        for top in ("include", "src", "tasks"):
            found = pathlib.Path(top, name)
            if found not in seen and (root / found).is_file():
                seen.add(found)
                included(root, found, seen)
    return seen


def as_included(path):
    return pathlib.Path(*path.parts[1:]).as_posix()


# C++

def quoted(text, indent):
    """C++ string literal, wrapped to the line length."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    lines = textwrap.wrap(escaped, 96 - indent, break_long_words=False, break_on_hyphens=False, drop_whitespace=False)
    return ("\n" + " " * indent).join(f'"{line}"' for line in lines or [""])


def words_code(of):
    entries = ",\n       ".join(
        "{" + quoted(entry.tags.get("word", word_of(entry.name)), 8) + (", " + quoted(entry.meaning, 8) if entry.meaning else "") + "}"
        for entry in of.entries)
    return (f"const Words& words_of({of.cpp_name} /*of*/) {{\n"
            f"  static const Words all{{\n      {quoted(of.layer, 6)},\n      {quoted(of.name, 6)},\n      {quoted(of.meaning, 6)},\n"
            f"      {{{entries}}}}};\n  return all;\n}}\n")


def group_code(text):
    kind, _, rest = text.partition(" ")
    key, _, meaning = rest.partition(" ") if kind == "@section" else ("-", "", rest)
    section = "" if key == "-" else ", " + quoted(key, 13)
    return f".group({quoted(meaning.replace(chr(92) + 'n', chr(10)), 13)}{section})"


def description_code(of):
    lines = [f"const Description& description_of(const {of.cpp_name}* /*of*/) {{",
             f"  using S = {of.cpp_name};", "  static const Description all =",
             f"      Describe<S>({quoted(of.layer, 18)}, {quoted(of.name, 18)},\n                  {quoted(of.meaning, 18)})"]
    if of.is_result:
        lines.append("          .result()")
    groups = dict(of.groups)
    for i, entry in enumerate(of.entries):
        if i in groups:
            lines.append("          " + group_code(groups[i]))
        name = entry.name + "_" * keyword.iskeyword(entry.name)  # name in Python
        text = f'          .field("{name}", &S::{entry.name}'
        if entry.meaning or entry.range:
            text += f",\n                 {quoted(entry.meaning, 17)}"
        if entry.range:
            text += f",\n                 {range_code(entry.range)}"
        lines.append(text + ")")
        for tag, value in entry.tags.items():
            name = {"code": "in_code"}.get(tag, tag)
            lines.append(f"          .{name}({quoted(value, 12 + len(name)) if value else ''})")
    for at, text in of.groups:
        if at >= len(of.entries):
            lines.append("          " + group_code(text))
    return "\n".join(lines) + ";\n  return all;\n}\n"


HEAD = "// Written by scripts/describe --write from the headers of the layer; not to be edited.\n// clang-format off\n"


def by_namespace(described, code):
    texts = []
    for namespace in dict.fromkeys(of.namespace for of in described):
        parts = [code(of) for of in described if of.namespace == namespace]
        texts.append(f"namespace {namespace} {{\n\n" + "\n".join(parts) + f"\n}}  // namespace {namespace}\n")
    return "\n".join(texts)


def generated(root, layers):
    """Generated files and their texts. They include manual descriptions in descriptions.hpp."""
    texts = {}

    def header_of(folder):
        by_hand = folder / "descriptions.hpp"
        return as_included(by_hand if (root / by_hand).is_file() else folder / "descriptions.gen.hpp")

    for folder, described in layers.items():
        headers = sorted({pathlib.Path(of.path) for of in described})
        seen = set()
        for header in headers:
            included(root, header, seen)
        near = {folder_of(path) for path in seen} - {folder}
        others = [other for other in near if any(pathlib.Path(of.path) in seen for of in layers.get(other, ()))
                  or (root / other / "descriptions.hpp").is_file()]
        includes = sorted({*map(as_included, headers), *map(header_of, others)} | {"base/description.hpp" if folder.name == "base" else "base/descriptions.gen.hpp"})
        declared = by_namespace(described, lambda of: f"const Words& words_of({of.cpp_name});\n" if of.is_enum
                                else f"const Description& description_of(const {of.cpp_name}*);\n").replace(";\n\nconst", ";\nconst")
        texts[folder / "descriptions.gen.hpp"] = (
            HEAD + "#pragma once\n\n" + "".join(f'#include "{name}"\n' for name in includes) + "\n" + declared)
        own = [as_included(path) for path in (folder / "figures.hpp",) if (root / path).is_file()]
        texts[folder / "descriptions.gen.cpp"] = (
            HEAD + "".join(f'#include "{name}"\n' for name in [header_of(folder), *own])
            + "\n// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables\n"
            + by_namespace(described, lambda of: words_code(of) if of.is_enum else description_code(of))
            + "// NOLINTEND(readability-function-size,modernize-raw-string-literal)\n")
    return texts
