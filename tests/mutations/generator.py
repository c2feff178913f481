"""Makes the mutants of a header: signs, comparisons, constants, conditions, dropped statements, swapped arguments.

Each is a range of the header's text and what takes its place. Most can be switched while the program runs, and know how:
the calls of mutants.hpp that are put around the range. One that the compiler itself computes, in a constexpr, can't."""
from dataclasses import dataclass, field

from source import expression, is_name, read, split, statements

swapped_signs = {"+": "-", "-": "+", "*": "/", "/": "*"}
functions = {"+": "plus", "-": "minus", "*": "times", "/": "divided_by", "<": "less", "<=": "less_equal", ">": "greater",
             ">=": "greater_equal", "==": "equal", "!=": "not_equal"}
neighbours = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
assigning = {"+=": ("add_to", ["-=", "="]), "-=": ("take_from", ["+="]), "*=": ("multiply", ["/="]),
             "/=": ("divide", ["*="])}
# Calls whose arguments may change places, and such as are no calls.
symmetric = {"max", "min", "hypot", "dot", "swap", "same_bits", "cwiseProduct", "cwiseMax", "cwiseMin"}
# Functions that change what they are given.
changing = {"unique", "exchange", "remove", "remove_if", "partition"}
# Members that change nothing.
constant_members = {"size", "empty", "begin", "end", "front", "back", "data", "get", "x", "y", "z", "row", "col", "norm",
                    "squaredNorm", "dot", "cross", "cast", "diagonal", "at", "name", "what", "traits", "time_step"}
# Tables that the compiler computes, but that may as well be computed when the program starts.
late_variables = {"row", "from", "portions", "rule", "weight", "turning_ladder", "motion_ladder", "torque_ladder", "quarter_turn",
                  "sine_series", "cosine_series", "element_slack", "short_list", "smallest_share", "packs_in_block",
                  "errors", "error_sees_end", "is_asked_for"}
integers = {"bool", "int", "unsigned", "size_t", "int64_t", "uint32_t", "uint64_t"}
no_calls = {"if", "for", "while", "sizeof", "decltype", "noexcept", "alignof", "static_assert", "requires", "catch",
            "return", "throw", "operator", "alignas"}


@dataclass
class Wrap:
    """Text before and after a range."""
    start: int
    end: int
    before: str
    after: str


@dataclass
class Replace:
    start: int
    end: int
    by: str


@dataclass
class Mutant:
    header: str
    kind: str
    start: int
    end: int
    replacement: str
    number: int = 0
    edits: list = field(default_factory=list)  # empty if it can't be switched; one of several of a site holds them
    site: int = 0
    may_be_constant: bool = False  # it may be computed by the compiler
    is_late: bool = False  # it is in a table that is computed when the program starts


class Generator:
    def __init__(self, header, text, first_number):
        self.header, self.text, self.next = header, text, first_number
        self.mutants = []
        self.sites = 0
        self.constant = False  # inside of what the compiler computes
        self.may_be_constant = False  # inside of a function that it may compute
        self.late = []  # the edits that let this constexpr be computed when the program starts
        self.late_edits = []  # all of the header

    def everything(self):
        source = read(self.text)
        for words, declared in source.initialisers:
            self.declared(words, declared, "inline const")
        for function in source.functions:
            self.may_be_constant = function.is_constexpr
            self.block(function.body)
        return self.mutants

    def declared(self, words, declared, late_words):
        """The initialiser of a variable. `declared` stands before it where it is a constexpr, and is empty else."""
        names = [word.text for word in declared if word.kind == "name"]
        outer_late, self.late = self.late, []
        if names and names[-1] in late_variables:
            word = next(word for word in declared if is_name(word, "constexpr"))
            inline = "const" if "inline" in names else late_words
            self.late = [Replace(word.start, word.end, inline)]
            self.late_edits += self.late
        outer, self.constant = self.constant, self.constant or bool(names and not self.late)
        self.list_of(words)
        self.constant, self.late = outer, outer_late

    def add(self, kind, alternatives, edits):
        """A site with a mutant for each (start, end, replacement). `edits(number)` makes its edits, given its first number."""
        first = self.next
        made = [] if self.constant else edits(first)
        self.sites += 1
        for start, end, replacement in alternatives:
            self.mutants.append(Mutant(self.header, kind, start, end, replacement, self.next, made, self.sites, self.may_be_constant, bool(self.late)))
            self.next += 1

    # --- Statements ----------------------------------------------------------------------------------------------------

    def block(self, found):
        for statement in found:
            if statement:
                self.statement(statement)

    def statement(self, statement):
        if statement.kind in ("block", "try"):
            return self.block(statement.inner)
        if statement.kind in ("if", "while"):
            outer = self.constant
            head = statement.head.inside
            asked = head[1:] if head and head[0].text == "!" else head
            if statement.is_constexpr and asked and is_name(asked[0], *late_variables):
                self.late = [Replace(statement.start, statement.head.start, "if ")]
                self.late_edits += self.late
            self.constant = outer or (statement.is_constexpr and not self.late)
            pieces = split(statement.head.inside, {";"})
            for piece in pieces[:-1]:
                self.list_of(piece)
            dropped = statement.kind == "if" and len(statement.inner) == 1
            self.condition(pieces[-1], "a dropped statement" if dropped else "")
            self.constant, self.late = outer, []
            return self.block(statement.inner)
        if statement.kind == "for":
            pieces = split(statement.head.inside, {";"})
            if len(pieces) == 3:
                self.list_of(pieces[0])
                self.condition(pieces[1], "")
            else:
                halves = split(pieces[-1], {":"})
                if len(halves) == 2:
                    self.list_of(halves[1])
            return self.block(statement.inner)
        words = statement.words
        if statement.kind == "return":
            if len(words) == 1:
                self.drop(statement)
            if not is_name(words[0], "throw"):  # the sentence that says what is wrong is checked as a text
                self.list_of(words[1:])
            return None
        if statement.kind == "jump":
            return self.drop(statement)
        if statement.kind == "declaration":
            if is_name(words[0], "using", "static_assert", "struct", "class", "enum", "typedef"):
                return None
            constant = any(is_name(word, "constexpr") for word in words)
            place = next((i for i, word in enumerate(words) if word.kind == "mark" and word.text == "="), 0)
            if constant and place:
                self.declared(words[place + 1:], words[:place], "const")
            else:
                outer = self.may_be_constant
                # The compiler computes a constant integer where it can, without its saying so.
                if is_name(words[0], "const") and any(is_name(word, *integers) for word in words):
                    self.may_be_constant = True
                self.list_of(words)
                self.may_be_constant = outer
            return None
        if not is_name(words[0], "delete"):
            self.drop(statement)
            self.list_of(words)
        return None

    def drop(self, statement):
        start, end = statement.start, statement.end
        self.add("a dropped statement", [(start, end, ";")], lambda n: [
            Wrap(start, end, f"{{ if (!::tumble_mutants::chosen({n})) ", " }")])

    def condition(self, words, dropped):
        """A condition: it is negated, and of an if without else what hangs on it is left out."""
        tree = expression(words)
        if tree is None:
            return
        if tree.kind == "assign":  # it declares a name
            return self.tree(tree)
        text = self.text[tree.start:tree.end]
        negates_itself = (tree.kind == "binary" and tree.operator.text in ("==", "!=")) or (
            tree.kind == "prefix" and tree.operator.text == "!")
        alternatives = [] if negates_itself else [("a negated condition", f"!({text})")]
        if dropped:
            alternatives.append((dropped, "false"))
        code = {("a negated condition",): "negated_if", ("a dropped statement",): "false_if",
                ("a negated condition", "a dropped statement"): "negated_or_false_if"}
        if alternatives:
            call = code[tuple(kind for kind, _ in alternatives)]
            first = len(self.mutants)
            self.add("", [(tree.start, tree.end, by) for _, by in alternatives], lambda n: [
                Wrap(tree.start, tree.end, f"::tumble_mutants::{call}({n}, ", ")")])
            for mutant, (kind, _) in zip(self.mutants[first:], alternatives):
                mutant.kind = kind
        self.tree(tree)

    # --- Expressions ---------------------------------------------------------------------------------------------------

    def list_of(self, words):
        """Expressions between commas."""
        for run in split(words, {","}):
            if run and run[0].kind == "mark" and run[0].text == ".":  # .member = value
                run = run[3:] if len(run) > 2 and run[2].text == "=" else run[2:]
            tree = expression(run)
            if tree:
                self.tree(tree)

    def tree(self, tree):
        if tree.kind == "binary":
            self.binary(tree)
        elif tree.kind == "prefix":
            self.prefix(tree)
        elif tree.kind == "assign":
            self.assign(tree)
        elif tree.kind == "choice":
            condition = tree.parts[0]
            if not (condition.kind == "binary" and condition.operator.text in ("==", "!=")):
                text = self.text[condition.start:condition.end]
                self.add("a negated condition", [(condition.start, condition.end, f"!({text})")], lambda n: [
                    Wrap(condition.start, condition.end, f"::tumble_mutants::negated_if({n}, ", ")")])
        elif tree.kind == "atom":
            self.atom(tree.words)
        for part in tree.parts:
            self.tree(part)

    def binary(self, tree):
        operator, (left, right) = tree.operator, tree.parts
        mark = operator.text
        if '"' in self.text[left.start:right.end] and mark == "+":  # a sentence is put together
            return
        if mark in swapped_signs or mark in neighbours:
            kind = ("a sign" if mark in "+-" else "a factor" if mark in "*/" else "a comparison")
            other = swapped_signs.get(mark) or neighbours[mark]
            self.add(kind, [(operator.start, operator.end, other)], lambda n: [
                Wrap(tree.start, tree.end, f"::tumble_mutants::{functions[mark]}({n}, ", ")"),
                Replace(operator.start, operator.end, ",")])
        elif mark in ("&&", "||"):
            call, other = ("both", "||") if mark == "&&" else ("either_of", "&&")
            self.add("and, or", [(operator.start, operator.end, other)], lambda n: [
                Wrap(tree.start, tree.end, f"::tumble_mutants::{call}({n}, ", ")"),
                Replace(operator.start, operator.end, ","),
                Wrap(right.start, right.end, "[&]() -> decltype(auto) { return ", "; }")])

    def prefix(self, tree):
        operator, part = tree.operator, tree.parts[0]
        if operator.text in ("-", "!"):
            call = "opposite" if operator.text == "-" else "inverse"
            self.add("a dropped negation", [(operator.start, operator.end, "")], lambda n: [
                Replace(operator.start, operator.end, ""),
                Wrap(tree.start, tree.end, f"::tumble_mutants::{call}({n}, ", ")")])

    def assign(self, tree):
        operator, (left, right) = tree.operator, tree.parts
        if operator.text in assigning and left.kind == "atom" and not (right.words and right.words[0].kind == "{"):
            call, others = assigning[operator.text]
            self.add("a sign" if operator.text in ("+=", "-=") else "a factor",
                     [(operator.start, operator.end, other) for other in others], lambda n: [
                         Wrap(tree.start, tree.end, f"::tumble_mutants::{call}({n}, ", ")"),
                         Replace(operator.start, operator.end, ",")])

    def atom(self, words):
        skip = 0
        for i, word in enumerate(words):
            before = words[i - 1] if i > 0 else None
            if skip > 0:
                skip -= 1
            elif is_name(word, "requires"):  # what it asks is no computation
                return
            elif is_name(word, "sizeof", "decltype", "noexcept", "alignof"):
                skip = 1
            elif is_name(word, "operator"):
                skip = 1
            elif word.kind == "number" or is_name(word, "true", "false"):
                self.constant_word(word)
            elif word.kind == "(":
                if before is not None and (before.kind == "<" or before.kind == "name") and not is_name(before, *no_calls):
                    self.call(words, i)
                self.list_of(word.inside)
            elif word.kind == "[":
                if before is not None and (before.kind in ("name", "(", "[", "<") and not is_name(before, "return")):
                    self.list_of(word.inside)
                elif not (word.inside and word.inside[0].kind == "["):  # a lambda
                    skip = self.skip_to_body(words, i)
            elif word.kind == "{":
                if self.is_body(words, i):
                    self.block(statements(word.inside))
                else:
                    self.list_of(word.inside)

    def skip_to_body(self, words, i):
        """How many words stand between a lambda's captures and its body."""
        j = i + 1
        while j < len(words) and words[j].kind != "{":
            j += 1
        return j - i - 1

    def is_body(self, words, i):
        """Whether braces hold the body of a lambda: its captures come before, and what stands between is no value."""
        for j in range(i - 1, -1, -1):
            word = words[j]
            if word.kind == "[":
                return j == 0 or words[j - 1].kind == "mark" or is_name(words[j - 1], "return")
            if word.kind == "{":
                return False
        return False

    def constant_word(self, word):
        start, end, text = word.start, word.end, word.text
        if text in ("true", "false"):
            others = ["false" if text == "true" else "true"]
        else:
            digits = text.rstrip("uUlLfF")
            if digits.lower().startswith("0x"):
                return
            suffix = text[len(digits):]
            if "." in digits or "e" in digits.lower():
                others = [f"1.0{suffix}"] if float(digits.replace("'", "")) == 0.5 else [f"(2 * {text})"]
            else:
                value = int(digits.replace("'", ""))
                others = {0: [f"1{suffix}"], 1: [f"0{suffix}", f"2{suffix}"], 2: [f"1{suffix}"]}.get(value, [f"{value + 1}{suffix}"])
        self.add("a constant", [(start, end, other) for other in others], lambda n: [
            Replace(start, end, f"::tumble_mutants::{'late_number' if self.late else 'number'}({', '.join([str(n), text, *others])})")])

    def call(self, words, i):
        """Neighbouring arguments of a call change places. Whether they are of one type is found out when the program runs."""
        name = next((word.text for word in reversed(words[:i]) if word.kind == "name"), "")
        if name in symmetric or name in no_calls:
            return
        runs = split(words[i].inside, {","})
        for left, right in zip(runs, runs[1:]):
            if not left or not right or not all(self.is_plain(run) for run in (left, right)):
                continue
            (a, b), (c, d) = (left[0].start, left[-1].end), (right[0].start, right[-1].end)
            first, second = self.text[a:b], self.text[c:d]
            if first == second:
                continue
            flat = [" ".join(text.split()) for text in (first, second)]
            # An argument stands there twice. What may change something must still be called once.
            call, before, after = ("first_of", "", "") if not (self.may_change(left) or self.may_change(right)) else (
                "first_called", "[&]() -> decltype(auto) { return ::tumble_mutants::kept(", "); }")
            self.add("swapped arguments", [(a, d, f"{second}{self.text[b:c]}{first}")], lambda n: [
                Wrap(a, b, f"::tumble_mutants::{call}({n}, {before}", f"{after}, {before}{flat[1]}{after})"),
                Wrap(c, d, f"::tumble_mutants::{call}({n}, {before}", f"{after}, {before}{flat[0]}{after})")])

    def may_change(self, run):
        """Whether an argument calls what may change something: a member that is not known to change nothing, or such a function."""
        for j, word in enumerate(run):
            if word.kind == "(" and j > 0 and run[j - 1].kind == "name":
                is_member = j > 1 and run[j - 2].text in (".", "->")
                if run[j - 1].text in changing or (is_member and run[j - 1].text not in constant_members):
                    return True
            if word.inside and self.may_change(word.inside):
                return True
        return False

    def is_plain(self, run):
        """Whether an argument may be written twice: no text, no lambda, no braces, nothing that changes something."""
        for j, word in enumerate(run):
            if word.kind in ("string", "{") or word.text in ("++", "--", "...", "this", "move", "forward") or "//" in self.text[word.start:word.end]:
                return False
            if word.kind == "[" and (j == 0 or run[j - 1].kind == "mark"):
                return False
            if word.kind in "([" and not self.is_plain(word.inside):
                return False
            if word.kind == "mark" and word.text in ("=", "+=", "-="):
                return False
        return True
