# SPDX-License-Identifier: Apache-2.0
"""Finds the places of the tree's texts that a mutant can change: C++ by libclang, Python by `ast`, templates by Jinja's lexer.

A place is a dictionary: `file`, `begin` and `end` (bytes), `replacement`, `operator`, and for C++ `edits`, the same
change behind a switch: (begin, end, text) with the mutant's number as {n}.
"""
import ast
import concurrent.futures
import hashlib
import json
import pathlib
import random
import re
import shlex

# Folder → room, which is a group of folders. The longest path that holds a file counts. A folder with None is never mutated: tests,
# the tools that judge mutants, and samples for users.
ROOMS = {"model/include/tribo": "formulas", "model/src": "engine", "model/scene": "scene", "model/catalogue": "catalogue",
         "model/ehl": "film", "model/sweep": "sweep", "verification/conformance": "judging",
         "verification/reproduction": "judging", "verification/accuracy": "judging", "verification/protocol": "judging",
         "verification/conformance/subjects": None, "verification/tests": None, "verification/gates": None,
         "reports/program": "program", "reports/page": "page's data", "reports/page/render": "page's templates and pictures",
         "reports/page/gnuplot": "page's templates and pictures", "reports/field": "page's data",
         "reports/field/templates": "page's templates and pictures", "reports/field/adapters": None, "reports/field/textbook": None, "benchmarks": "benchmarks", "benchmarks/tests": None}
# Where libclang 14 finds its own headers (libclang-common-14-dev).
CLANG_HEADERS = "/usr/lib/llvm-14/lib/clang/14.0.6/include"
WHOLE = {"BOOL", "CHAR_U", "UCHAR", "USHORT", "UINT", "ULONG", "ULONGLONG", "CHAR_S", "SCHAR", "SHORT", "INT", "LONG", "LONGLONG"}
ARITHMETIC = WHOLE | {"FLOAT", "DOUBLE", "LONGDOUBLE"}
OTHER = {"<": ("boundary", "<="), "<=": ("boundary", "<"), ">": ("boundary", ">="), ">=": ("boundary", ">"),
         "==": ("comparison", "!="), "!=": ("comparison", "=="), "&&": ("logic", "||"), "||": ("logic", "&&"),
         "+": ("arithmetic", "-"), "-": ("arithmetic", "+"), "*": ("arithmetic", "/"), "/": ("arithmetic", "*")}
TURNED = {"<": ">=", "<=": ">", ">": "<=", ">=": "<"}
# Functions whose first two arguments may change places.
ORDER_FREE = {"Mul", "Add", "Max", "Min", "And", "Or", "MulAdd", "MulSub", "NegMulAdd", "max", "min", "fmax", "fmin", "hypot"}
# Highway's operations on vectors, each with the one that takes its place.
VECTOR = {"Add": "Sub", "Sub": "Add", "Mul": "Div", "Div": "Mul", "Min": "Max", "Max": "Min", "MulAdd": "NegMulAdd",
          "NegMulAdd": "MulAdd", "MulSub": "MulAdd", "Lt": "Le", "Le": "Lt", "Gt": "Ge", "Ge": "Gt", "And": "Or", "Or": "And"}
IMPURE = re.compile(rb"\w\s*\(|\)\s*\(|\+\+|--|[^=!<>]=[^=]|\[|\bnew\b|\bthrow\b|\bco_")


def room_of(file):
    best = max((folder for folder in ROOMS if file.startswith(folder + "/")), key=len, default=None)
    return ROOMS.get(best) if not re.search(r"(^|/)(tests|templates/solver|test_[^/]*)(/|$|\.)", file) else None


def changed_number(text, dice):
    """A literal of C++ or Python with another value; an integer keeps its suffix. The result is None if the text is no plain number."""
    if re.fullmatch(r"(0|[1-9][0-9']*)([uUlLzZ]*)", text):
        digits, suffix = re.fullmatch(r"([0-9']+)(\w*)", text).groups()
        value = int(digits.replace("'", ""))
        return f"{dice.choice([value + 1, 0]) if value else 1}{suffix}"
    if re.fullmatch(r"(0x[0-9a-fA-F.]+p[-+]?\d+|[\d'.]+(e[-+]?\d+)?)[fFlL]?", text, re.I) and not re.fullmatch(r"0x\w+|\d+", text):
        zero = not re.search(r"[1-9a-f]", re.split("[ep]", text.lower().removeprefix("0x"))[0])
        return "1.0" if zero else dice.choice([f"({text} * 1.1)", f"({text} * 1.1)", "0.0"])
    return None


class Cpp:
    """Collects the places of C++ sources and of the headers that they include, each file once."""

    def __init__(self, root, rooms=None):
        import clang.cindex
        self.kinds = clang.cindex.CursorKind
        self.index = clang.cindex.Index.create()
        self.root, self.seen, self.places = str(root) + "/", set(), []
        self.is_asked = lambda file: (room := room_of(file)) is not None and (rooms is None or room in rooms)

    def read(self, command, file):
        words = iter(shlex.split(command)[1:])
        kept = [word for word in words if not (word in ("-o", "-include", "-c") and next(words)) and word != "-Winvalid-pch"]
        unit = self.index.parse(file, [*kept, "-w", "-I" + CLANG_HEADERS])
        self.texts, fresh = {}, set()
        self.fields = Fields()
        self.fields.read(unit.cursor, self.root, self.kinds)
        self.top(unit.cursor, fresh)
        self.seen |= fresh

    def top(self, cursor, fresh):
        for child in cursor.get_children():
            file = child.location.file
            name = file.name if file else ""
            if not name.startswith(self.root):
                continue
            path = str(pathlib.Path(name).resolve()).removeprefix(self.root)
            if path in self.seen or not self.is_asked(path) or path.endswith(".inc"):
                continue
            if path not in self.texts:
                self.texts[path] = pathlib.Path(self.root + path).read_bytes()
                fresh.add(path)
            self.file, self.text = path, self.texts[path]
            if child.kind in (self.kinds.NAMESPACE, self.kinds.LINKAGE_SPEC, self.kinds.UNEXPOSED_DECL):
                self.top(child, fresh)
                continue
            self.walk(child, [], None)

    def span(self, cursor):
        """The offsets of a cursor's begin and end, in bytes. The result is None if the cursor is not in this file or comes from a macro."""
        a, b = cursor.extent.start, cursor.extent.end
        if a.file is None or b.file is None or not a.file.name.endswith(self.file) or a.offset >= b.offset:
            return None
        return a.offset, b.offset

    def cut(self, span):
        return self.text[slice(*span)].decode()

    def add(self, operator, begin, end, replacement, *edits, variable=None):
        """Adds a place. `variable` is the declaration whose initial value has the place. That value must then be computed when the program runs,
        and so its constexpr is replaced."""
        if b".reserve(" in self.text[self.text.rfind(b"\n", 0, begin) + 1:begin]:
            return  # a list grows by itself beyond its reserved size
        if variable is not None:
            place = self.constant(variable)
            if place is False:
                return
            edits = [(a, b, re.sub(r"(?<=::tribocheck_mutants::)(?=on\b|choose\b)", "late_", text)) for a, b, text in edits]
            edits += [place] if place else []
        self.places.append({"file": self.file, "begin": begin, "end": end, "replacement": replacement,
                            "operator": operator, "edits": edits})

    def constant(self, variable):
        """The edit that makes a constexpr variable a const one. It is None if no edit is needed, and False if the text of the variable is not
        known."""
        span = self.span(variable)
        if span is None:
            return False
        found = re.search(rb"\bconstexpr\b", self.text[span[0]:span[1]])
        if found is None:
            return None
        inside = variable.semantic_parent.kind in (self.kinds.CLASS_DECL, self.kinds.STRUCT_DECL, self.kinds.CLASS_TEMPLATE)
        inline = inside and b"inline" not in self.text[span[0]:span[0] + found.end()]
        return span[0] + found.start(), span[0] + found.end(), "inline const" if inline else "const"

    def choice(self, operator, span, original, changed, kind, variable, whole=None):
        """Chooses one expression or the other. If both are cheap and have no side effects, both are evaluated and compared."""
        pure = kind in ARITHMETIC and not IMPURE.search(self.text[slice(*span)]) and not (whole and kind in WHOLE)
        if pure:
            text = f"::tribocheck_mutants::choose({{n}}, ({original}), ({changed}))"
        elif kind == "DEPENDENT" and room_of(self.file) != "engine" and not IMPURE.search(self.text[slice(*span)]):
            # In the engine such a type may be a vector. Only functions that are compiled for its instruction set can take it.
            text = f"::tribocheck_mutants::choose<::tribocheck_mutants::value<decltype({original})>>({{n}}, {original}, {changed})"
        elif kind == "DEPENDENT" or kind not in ARITHMETIC:
            value = f"::tribocheck_mutants::value<decltype({original})>"
            text = f"(::tribocheck_mutants::on({{n}}) ? {value}({changed}) : {value}({original}))"
        else:
            text = f"(::tribocheck_mutants::on({{n}}) ? ({changed}) : ({original}))"
        self.add(operator, *span, changed, (*span, text), variable=variable)

    def walk(self, cursor, above, variable):
        kinds, kind = self.kinds, cursor.kind
        if kind in (kinds.STATIC_ASSERT, kinds.ENUM_DECL):
            return
        children = list(cursor.get_children())
        span = self.span(cursor)
        if kind in (kinds.VAR_DECL, kinds.FIELD_DECL):
            variable = cursor if kind == kinds.VAR_DECL and self.is_early(cursor, above) else None
        elif kind == kinds.COMPOUND_STMT:
            variable = None
        if span is not None:
            parent = above[-1] if above else None
            # The seed depends on the file, the position and the text, so that a place has the same mutants in every run on the same tree.
            self.dice = random.Random(f"{self.file}:{span}:{self.cut(span)}")
            if kind == kinds.BINARY_OPERATOR and len(children) == 2:
                self.binary(cursor, span, children, above, variable)
            elif kind in (kinds.INTEGER_LITERAL, kinds.FLOATING_LITERAL):
                self.literal(cursor, span, parent, variable)
            elif kind in (kinds.IF_STMT, kinds.WHILE_STMT, kinds.CONDITIONAL_OPERATOR) and children:
                self.condition(kind, span, children[0], variable)
            elif kind == kinds.CALL_EXPR:
                self.call(cursor, span, variable)
            elif kind == kinds.MEMBER_REF_EXPR:
                self.member(cursor, span, parent, variable)
            elif kind == kinds.COMPOUND_STMT:
                self.block(span, children, above)
        for child in children[kind == kinds.CASE_STMT:]:
            self.walk(child, [*above, cursor], variable)

    def is_early(self, cursor, above):
        """Whether the variable may get its value while compiling."""
        k = self.kinds
        inside = any(one.kind in (k.COMPOUND_STMT, k.LAMBDA_EXPR) for one in above)
        span = self.span(cursor)
        text = self.cut(span).split("=")[0] if span else ""
        return not inside or bool(re.search(r"\b(constexpr|static)\b", text)) or cursor.type.is_const_qualified() \
            and cursor.type.get_canonical().kind.name in WHOLE

    def binary(self, cursor, span, children, above, variable):
        left, right = map(self.span, children)
        if not left or not right or left[0] != span[0] or right[1] != span[1] or left[1] > right[0]:
            return
        sign = re.sub(r"//.*|/\*.*?\*/", "", self.text[left[1]:right[0]].decode()).strip()
        if sign not in OTHER:
            return
        kind = cursor.type.get_canonical().kind.name
        a, b, original = self.cut(left), self.cut(right), self.cut(span)
        operator, other = OTHER[sign]
        loop = above and above[-1].kind == self.kinds.FOR_STMT and sign in ("<", "<=")
        kinds = [operator] + (["comparison"] if sign in TURNED else []) + (["end"] if loop else [])
        for one in kinds:
            if one == "end":
                changed = f"{a} + 1 {sign} {b}"
            else:
                changed = f"{a} {TURNED[sign] if one == 'comparison' and sign in TURNED else other} {b}"
            self.choice(one, span, original, changed, kind, variable, whole=sign == "*" or sign == "/")

    def literal(self, cursor, span, parent, variable):
        text = self.cut(span)
        before, after = self.text[max(0, span[0] - 60):span[0]].decode(errors="replace"), self.text[span[1]:span[1] + 40].decode(errors="replace")
        if re.search(r"\w<[^<>;(){}]*$", before) and re.match(r"[^<>;(){}]*>", after) or re.search(r"\w\[$", before) and \
                parent is not None and parent.kind in (self.kinds.VAR_DECL, self.kinds.FIELD_DECL):
            return  # part of a type
        changed = changed_number(text, self.dice)
        if changed is None:
            return
        kind = cursor.type.get_canonical()
        # If the literal is converted implicitly, choose() gets the converted type. Inside braces C++ may narrow a literal, but not the
        # result of choose().
        if parent is not None and parent.kind == self.kinds.UNEXPOSED_EXPR and self.span(parent) == span:
            kind = parent.type.get_canonical()
        if kind.kind.name not in ARITHMETIC:
            return
        name = re.sub(r"\bconst\b", "", kind.spelling).strip()
        self.add("constant", *span, changed, (*span, f"::tribocheck_mutants::choose<{name}>({{n}}, {text}, {changed})"), variable=variable)

    def condition(self, kind, span, child, variable):
        inner = self.span(child)
        if inner is None or not child.kind.is_expression() or self.text[span[0]:span[0] + 15].startswith(b"if constexpr"):
            return
        text = self.cut(inner)
        if text.endswith(";") or "\n#" in text:
            return
        self.add("condition", *inner, f"!({text})",
                 (*inner, f"(static_cast<bool>({text}) != ::tribocheck_mutants::on({{n}}))"), variable=variable)

    def call(self, cursor, span, variable):
        text = self.cut(span)
        spans = [self.span(one) for one in cursor.get_arguments()]
        types = [one.type.get_canonical() for one in cursor.get_arguments()]
        called = re.match(r"(?:\w+::)*(\w+)\(", text)
        for i in range(len(spans) - 1):
            a, b = spans[i], spans[i + 1]
            if i == 0 and (called and called[1] in ORDER_FREE or a and b and self.text[a[1]:b[0]].strip() in (b"==", b"!=")):
                continue  # the order of these two changes nothing
            if not a or not b or a[1] > b[0] or types[i].spelling.removeprefix("const ") != types[i + 1].spelling.removeprefix("const "):
                continue
            if "=" in re.sub(rb"[=!<>]=", b"", self.text[a[1]:b[0]]).decode():
                continue  # an assignment stands between them, and would change a copy
            one, two = self.cut(a), self.cut(b)
            if one == two or " = " in one + two or re.match(r'["{\[]', one) or re.match(r'["{\[]', two) or "lambda" in types[i].spelling:
                continue
            gap = self.text[a[1]:b[0]].decode()
            on = "::tribocheck_mutants::on({n})"
            self.add("arguments", a[0], b[1], f"{two}{gap}{one}",
                     (a[0], b[1], f"({on} ? ({two}) : ({one})){gap}({on} ? ({one}) : ({two}))"), variable=variable)
        vector = re.match(r"hn::(\w+)\(", text)
        if vector and vector[1] in VECTOR:
            changed = f"hn::{VECTOR[vector[1]]}{text[vector.end() - 1:]}"
            operator = "boundary" if vector[1] in ("Lt", "Le", "Gt", "Ge") else "logic" if vector[1] in ("And", "Or") else "arithmetic"
            self.choice(operator, span, text, changed, "VECTOR", variable)
        if re.search(r"[\w)\]](\.|->)size\(\)$", text):
            self.choice("end", span, text, f"({text} - 1)", "ULONG", variable)

    def member(self, cursor, span, parent, variable):
        text = self.cut(span)
        name = cursor.spelling or re.search(r"\w*$", text)[0]
        if not re.search(rf"(^|\W){re.escape(name)}$", text) or self.text[span[1]:span[1] + 1] == b"(":
            return
        known = cursor.referenced
        others = self.fields.of(known.semantic_parent.get_usr() if known is not None and known.kind == self.kinds.FIELD_DECL else None, name)
        if not others:
            return
        changed = text[:len(text) - len(name)] + self.dice.choice(others)
        kind = cursor.type.get_canonical().kind.name
        value = parent is not None and parent.kind == self.kinds.UNEXPOSED_EXPR and self.span(parent) == span
        if value and kind in ARITHMETIC:
            self.choice("field", span, text, changed, kind, variable)
        else:
            self.add("field", *span, changed, (*span, f"(::tribocheck_mutants::on({{n}}) ? {changed} : {text})"), variable=variable)

    def block(self, span, children, above):
        k = self.kinds
        function = above[-1] if above else None
        if function is not None and function.kind in (k.FUNCTION_DECL, k.CXX_METHOD, k.FUNCTION_TEMPLATE, k.CONSTRUCTOR) and len(children) > 1:
            result = function.result_type.spelling
            if "auto" not in result and "&" not in result and function.spelling != "main":
                end = "return;" if result == "void" or function.kind == k.CONSTRUCTOR else "return {};"
                self.add("early return", span[0] + 1, span[0] + 1, f" {end}",
                         (span[0] + 1, span[0] + 1, f" if (::tribocheck_mutants::on({{n}})) {end}"))
        for child in children:
            inner = self.span(child)
            statement = child.kind in (k.CALL_EXPR, k.BINARY_OPERATOR, k.COMPOUND_ASSIGNMENT_OPERATOR, k.UNARY_OPERATOR,
                                       k.UNEXPOSED_EXPR, k.IF_STMT, k.CONTINUE_STMT, k.BREAK_STMT, k.CXX_THROW_EXPR)
            if not inner or not statement or re.match(r"if constexpr|assert", self.cut(inner)):
                continue
            block = child.kind == k.IF_STMT
            self.add("statement", *inner, "{}" if block else "(void)0",
                     (inner[0], inner[0], "if (!::tribocheck_mutants::on({n})) "), (inner[1], inner[1], ""))


class Fields:
    """For each field of a record of the project: the record's other fields that have the type of that field."""

    def __init__(self):
        self.records = {}

    def of(self, record, name):
        sets = [self.records[record]] if record in self.records else list(self.records.values()) if record is None else []
        found = [[other for other, kind in one.items() if other != name and kind == one[name]] for one in sets if name in one]
        return sorted({other for one in found for other in one}) if len(found) <= 3 else []

    def read(self, cursor, root, kinds):
        for child in cursor.get_children():
            if child.location.file is None or not child.location.file.name.startswith(root):
                continue
            if child.kind in (kinds.STRUCT_DECL, kinds.CLASS_DECL, kinds.CLASS_TEMPLATE):
                self.records[child.get_usr()] = {one.spelling: one.type.spelling for one in child.get_children() if one.kind == kinds.FIELD_DECL}
            if child.kind in (kinds.NAMESPACE, kinds.STRUCT_DECL, kinds.CLASS_DECL, kinds.CLASS_TEMPLATE):
                self.read(child, root, kinds)


def cpp_part(root, commands, rooms=None):
    found = Cpp(root, rooms)
    for command, file in commands:
        found.read(command, file)
    return found.places


def sources_of(file):
    """The sources that an entry of the build compiles: the entry's own file, or those that CMake joined in that file."""
    joined = file.parent.name == "Unity" and file.suffix == ".cxx"
    return re.findall(r'^#include "(.+)"', file.read_text(), flags=re.MULTILINE) if joined else [str(file)]


def files_of(root, rooms=None):
    """The sorted paths of the texts in these rooms, or in all rooms."""
    return sorted(path for folder in {folder.split("/")[0] for folder in ROOMS} for path in (root / folder).glob("**/*")
                  if path.suffix in (".cpp", ".hpp", ".py", ".md", ".gp", ".js")
                  and (room := room_of(path.relative_to(root).as_posix())) and (rooms is None or room in rooms) and path.is_file())


def cpp_places(root, build, workers=2, rooms=None):
    """The places of the sources that the build compiles in these rooms, or in all rooms, and of the rooms' headers that they include."""
    entries = json.loads((build / "compile_commands.json").read_text())
    commands = [(one["command"], file) for one in entries for file in sources_of(pathlib.Path(one["file"]))
                if file.endswith(".cpp") and (name := file.removeprefix(f"{root}/")) != file and room_of(name)]
    if rooms is not None:
        mine = files_of(root, rooms)
        texts = "".join(path.read_text() for path in mine if path.suffix in (".cpp", ".hpp"))
        # A header that no text of these rooms includes is read with the first source that includes it.
        lonely = [path.name for path in mine if path.suffix == ".hpp" and f'{path.name}"' not in texts]
        readers = {next((file for _, file in commands if f'/{name}"' in pathlib.Path(file).read_text()), None) for name in lonely}
        commands = [row for row in commands if pathlib.Path(row[1]) in mine or row[1] in readers]
    random.Random(1).shuffle(commands)
    with concurrent.futures.ProcessPoolExecutor(workers) as pool:
        parts = list(pool.map(cpp_part, [root] * workers, [commands[i::workers] for i in range(workers)], [rooms] * workers))
    once = {(one["file"], one["begin"], one["end"], one["operator"], one["replacement"]): one for part in parts for one in part}
    return list(once.values())


def python_places(file, text):
    lines = [0]
    for line in text.encode().splitlines(keepends=True):
        lines.append(lines[-1] + len(line))
    whole = text.encode()
    span = lambda node: (lines[node.lineno - 1] + node.col_offset, lines[node.end_lineno - 1] + node.end_col_offset)  # noqa: E731
    cut = lambda node: whole[slice(*span(node))].decode()  # noqa: E731
    places = []

    def add(operator, begin, end, replacement):
        places.append({"file": file, "begin": begin, "end": end, "replacement": replacement, "operator": operator})

    def between(left, right, pairs):
        gap = whole[span(left)[1]:span(right)[0]].decode()
        for sign, operator, other in pairs:
            if gap.strip("() \n") == sign:
                add(operator, span(left)[1], span(right)[0], gap.replace(sign, other))

    signs = [(sign, *rest) for sign, rest in OTHER.items() if sign not in ("&&", "||")]
    signs += [(sign, "comparison", other) for sign, other in (*TURNED.items(), ("in", "not in"), ("is", "is not"), ("is not", "is"))]
    for node in ast.walk(ast.parse(text)):
        dice = random.Random(f"{file}:{getattr(node, 'lineno', 0)}:{getattr(node, 'col_offset', 0)}")
        if isinstance(node, ast.Compare):
            between(node.left, node.comparators[0], signs)
        elif isinstance(node, ast.BinOp):
            between(node.left, node.right, signs)
        elif isinstance(node, ast.BoolOp):
            between(node.values[0], node.values[1], [("and", "logic", "or"), ("or", "logic", "and")] if len(node.values) == 2 else [])
        elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
            if (changed := changed_number(cut(node), dice)) is not None:
                add("constant", *span(node), changed)
        elif isinstance(node, ast.Call):
            for one, two in zip(node.args, node.args[1:]):
                if type(one) is type(two) and cut(one) != cut(two) and not isinstance(one, ast.Starred):
                    add("arguments", span(one)[0], span(two)[1], cut(two) + ", " + cut(one))
        if isinstance(node, (ast.If, ast.While, ast.IfExp)):
            add("condition", *span(node.test), f"(not ({cut(node.test)}))")
        if isinstance(node, (ast.AugAssign, ast.Continue, ast.Raise)) or isinstance(node, ast.Expr) and not isinstance(node.value, ast.Constant):
            add("statement", *span(node), "pass")
        if isinstance(node, ast.FunctionDef) and len(node.body) > 1:
            first = node.body[1 if isinstance(node.body[0], ast.Expr) and isinstance(node.body[0].value, ast.Constant) else 0]
            add("early return", span(first)[0], span(first)[0], "return None\n" + " " * first.col_offset)
        if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load) and isinstance(node.value, ast.Name):
            others = sorted({one.attr for one in ast.walk(ast.parse(text)) if isinstance(one, ast.Attribute)
                             and isinstance(one.value, ast.Name) and one.value.id == node.value.id and one.attr != node.attr})
            if others:
                add("field", span(node)[1] - len(node.attr), span(node)[1], dice.choice(others))
    return places


def template_places(file, text):
    """Places of Markdown with Jinja: cells of tables, and expressions between braces."""
    import jinja2
    places, tokens, at = [], [], 0
    for _, kind, value in jinja2.Environment(keep_trailing_newline=True).lex(text):
        at = text.index(value, at)  # the lexer leaves out blanks that {%- removes
        tokens.append((kind, value, at))
        at += len(value)
    byte = lambda place: len(text[:place].encode())  # noqa: E731

    def add(operator, begin, end, replacement):
        places.append({"file": file, "begin": byte(begin), "end": byte(end), "replacement": replacement, "operator": operator})

    start = 0
    for line in text.splitlines(keepends=True):
        # A bar inside {{ }} or {% %} belongs to a filter and does not separate cells.
        if line.startswith("| ") and "{{" in line:
            bars = [m.start() for m in re.finditer(r"\{\{.*?\}\}|\{%.*?%\}|\|", line) if m[0] == "|"]
            cells = list(zip(bars, bars[1:]))
            for (a, b), (_, c) in zip(cells, cells[1:]):
                if line[a + 1:b] != line[b + 1:c] and "{{" in line[a:c]:
                    add("exchanged cells", start + a + 1, start + c, line[b + 1:c] + "|" + line[a + 1:b])
            for a, b in cells:
                if "{{" in line[a:b]:
                    add("dropped cell", start + a + 1, start + b, " – ")
        start += len(line)
    names = {}
    solid = [token for token in tokens if token[0] != "whitespace"]
    for one, dot, two in zip(solid, solid[1:], solid[2:]):
        if one[0] == two[0] == "name" and dot[1] == ".":
            names.setdefault(one[1], set()).add(two[1])
    for i, (kind, value, at) in enumerate(solid):
        dice = random.Random(f"{file}:{at}")
        if kind in ("integer", "float") and (changed := changed_number(value, dice)):
            add("constant", at, at + len(value), changed.strip("()") if "*" not in changed else changed)
        elif kind == "operator" and value in OTHER and value not in ("&&", "||") and solid[i - 1][0] in ("name", "integer", "float", "operator"):
            add(OTHER[value][0], at, at + len(value), OTHER[value][1])
        elif kind == "name" and value in ("and", "or"):
            add("logic", at, at + len(value), "or" if value == "and" else "and")
        elif kind == "name" and value in ("if", "elif"):
            add("condition", at, at + len(value), f"{value} not")
        elif kind == "name" and i >= 2 and solid[i - 1][1] == "." and (others := sorted(names.get(solid[i - 2][1], set()) - {value})):
            add("field", at, at + len(value), dice.choice(others))
    return places


def text_places(file, text):
    """Places of gnuplot and JavaScript, found by regular expressions: numbers, columns, signs."""
    places = []
    byte = lambda place: len(text[:place].encode())  # noqa: E731

    def add(operator, found, group, replacement):
        places.append({"file": file, "begin": byte(found.start(group)), "end": byte(found.end(group)),
                       "replacement": replacement, "operator": operator})

    bare = re.sub(r"^\s*(#|//).*$|\"[^\"\n]*\"", lambda m: " " * len(m[0]), text, flags=re.MULTILINE)
    for found in re.finditer(r"(?<![\w.$#])\d+(\.\d+)?(?![\w.:])", bare):
        add("constant", found, 0, changed_number(found[0], random.Random(f"{file}:{found.start()}")))
    for found in re.finditer(r"using (\$?\w+|\([^()]*(?:\([^()]*\)[^()]*)*\)):(\$?\w+|\([^()]*(?:\([^()]*\)[^()]*)*\))", bare):
        if found[1] != found[2]:
            places.append({"file": file, "begin": byte(found.start(1)), "end": byte(found.end(2)), "operator": "exchanged columns",
                           "replacement": f"{text[slice(*found.span(2))]}:{text[slice(*found.span(1))]}"})
    for found in re.finditer(r"(?<= )(<=|>=|===|!==|==|!=|<|>|&&|\|\||\+|-|\*|/)(?= )", bare):
        sign = found[1].replace("===", "==").replace("!==", "!=")
        add(OTHER[sign][0], found, 1, OTHER[sign][1])
    return places


def decides_while_compiling(text, begin):
    """Whether a place stands in the brackets of an expression that the compiler evaluates. A mutant there cannot be switched on when the
    program runs."""
    for found in re.finditer(r"\b(if constexpr|requires|static_assert|noexcept|sizeof|alignas)\s*\(", text[max(0, begin - 300):begin].decode(errors="replace")):
        after = found.string[found.end():]
        if after.count("(") >= after.count(")") and all(after[:i].count("(") >= after[:i].count(")") for i in range(len(after))):
            return True
    return False


def planted_places(root):
    """Places of texts that need no compiler: Python, templates, gnuplot, JavaScript."""
    readers = {".py": python_places, ".md": template_places, ".gp": text_places, ".js": text_places}
    places = []
    for path in sorted([*root.glob("reports/page/**/*"), *root.glob("reports/field/**/*"), *root.glob("benchmarks/**/*.py")]):
        file = path.relative_to(root).as_posix()
        if path.suffix in readers and room_of(file) and path.name != "README.md":
            places += readers[path.suffix](file, path.read_text())
    return places


def all_places(root, build, rooms=None):
    """All places, or those of some rooms; they are cached in the build folder for one state of the files."""
    files = files_of(root, rooms)
    state = hashlib.sha256(pathlib.Path(__file__).read_bytes() + b"".join(str(path).encode() + path.read_bytes() for path in files)).hexdigest()
    cache = build / "mutant_places.json"
    if cache.is_file() and (kept := json.loads(cache.read_text()))["state"] == state:
        return kept["places"]
    texts = {path.relative_to(root).as_posix(): path.read_bytes() for path in files}
    places = [one for one in cpp_places(root, build, rooms=rooms) if not decides_while_compiling(texts[one["file"]], one["begin"])]
    places += [one for one in planted_places(root) if one["file"] in texts]
    for one in places:
        one["room"] = room_of(one["file"])
    cache.write_text(json.dumps({"state": state, "places": places}))
    return places
