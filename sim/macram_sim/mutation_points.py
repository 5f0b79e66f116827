"""Single-point mutations of gateware sources: one operator, constant, condition or assignment at a time.

A mutation replaces one piece of the text, so its difference to the source is what a reader sees. Constructors, widths
of signals and ports given as a plain number, names and defaults are left alone: they are the interface, not the logic.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass

_OPERATORS: dict[type[ast.AST], tuple[str, str]] = {
    ast.Eq: ("==", "!="), ast.NotEq: ("!=", "=="), ast.Lt: ("<", "<="), ast.LtE: ("<=", "<"), ast.Gt: (">", ">="),
    ast.GtE: (">=", ">"), ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "+"), ast.BitAnd: ("&", "|"),
    ast.BitOr: ("|", "&"), ast.BitXor: ("^", "|"), ast.LShift: ("<<", ">>"), ast.RShift: (">>", "<<"),
}  # fmt: skip
_LEFT_ALONE = {"__init__", "__repr__", "__eq__", "__hash__"}
_REDUCTIONS = {"any": "all", "all": "any"}


@dataclass(frozen=True, slots=True)
class Mutation:
    """Replace ``text[start:end]``, which is ``before``, by ``after``. ``line`` counts from 1."""

    file: str
    line: int
    kind: str
    start: int
    end: int
    before: str
    after: str

    def apply(self, text: str) -> str:
        """The mutated source."""
        assert text[self.start : self.end] == self.before
        return text[: self.start] + self.after + text[self.end :]

    def lines(self, text: str) -> tuple[str, str]:
        """The first source line that differs, without indentation, before and after."""
        pairs = zip(text.splitlines(), self.apply(text).splitlines(), strict=False)
        old, new = next((a, b) for a, b in pairs if a != b)
        return old.strip(), new.strip()


def mutations(file: str, text: str) -> list[Mutation]:
    """Every mutation of a source, in the order of the text.

    Args:
        file: its name, for the reader.
        text: its contents.
    """
    lengths = [0]
    for line in text.splitlines(keepends=True):
        lengths.append(lengths[-1] + len(line))
    places = {(m.start, m.end, m.after): m for m in _Finder(file, text, lengths).all(ast.parse(text))}
    return [places[key] for key in sorted(places)]


class _Finder:
    def __init__(self, file: str, text: str, line_starts: list[int]) -> None:
        self._file, self._text, self._starts = file, text, line_starts

    def all(self, tree: ast.Module) -> Iterator[Mutation]:
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef) and node.name not in _LEFT_ALONE:
                for statement in node.body:
                    yield from self._inside(statement)

    def _inside(self, node: ast.AST) -> Iterator[Mutation]:
        if isinstance(node, (ast.Assert, ast.Raise, ast.FunctionDef, ast.JoinedStr)):
            return
        yield from self._of(node)
        for child in ast.iter_child_nodes(node):
            is_width = _calls(node) in ("Signal", "In", "Out") and isinstance(child, ast.Constant)
            is_name = isinstance(child, ast.keyword) and child.arg in (
                "name",
                "attrs",
                "init",
                "path",
                "strict",
            )
            if not (is_width or is_name):
                yield from self._inside(child)

    def _of(self, node: ast.AST) -> Iterator[Mutation]:
        match node:
            case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in _OPERATORS:
                yield from self._between(left, right, op, "comparison")
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
                yield from self._between(left, right, op, "operator")
            case ast.UnaryOp(op=ast.Invert() | ast.USub(), operand=operand):
                yield self._replace(node, self._source(operand), "sign or inversion dropped")
            case ast.Constant(value=int(value)) if not isinstance(value, bool):
                yield self._replace(node, str(1 - value if value in (0, 1) else value + 1), "constant")
            case ast.Call(func=ast.Name(id="Mux"), args=[_, yes, no]):
                start, end = self._at(yes)[0], self._at(no)[1]
                yield self._cut(start, end, f"{self._source(no)}, {self._source(yes)}", "multiplexer swapped")
            case ast.Call(func=ast.Attribute(value=value, attr=attr), args=[]) if attr in _REDUCTIONS:
                yield self._replace(node, f"{self._source(value)}.{_REDUCTIONS[attr]}()", "reduction")
            case ast.Call(func=ast.Attribute(attr="eq"), args=[argument]):
                stuck = "1" if self._source(argument) == "0" else "0"
                yield self._replace(argument, stuck, "assignment stuck")
            case ast.Call(func=ast.Attribute(attr="If" | "Elif"), args=[condition]):
                yield self._replace(condition, f"({self._source(condition)}) | 1", "condition dropped")
            case _:
                pass

    def _between(self, left: ast.expr, right: ast.expr, op: ast.AST, kind: str) -> Iterator[Mutation]:
        """The operator's sign lies between its operands, perhaps among brackets."""
        before, after = _OPERATORS[type(op)]
        start, end = self._at(left)[1], self._at(right)[0]
        at = self._text.find(before, start, end)
        if at >= 0:
            yield self._cut(at, at + len(before), after, kind)

    def _at(self, node: ast.expr) -> tuple[int, int]:
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        return (
            self._starts[node.lineno - 1] + node.col_offset,
            self._starts[node.end_lineno - 1] + node.end_col_offset,
        )

    def _source(self, node: ast.expr) -> str:
        start, end = self._at(node)
        return self._text[start:end]

    def _replace(self, node: ast.expr, after: str, kind: str) -> Mutation:
        return self._cut(*self._at(node), after, kind)

    def _cut(self, start: int, end: int, after: str, kind: str) -> Mutation:
        line = self._text.count("\n", 0, start) + 1
        return Mutation(self._file, line, kind, start, end, self._text[start:end], after)


def _calls(node: ast.AST) -> str:
    return node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
