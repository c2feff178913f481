"""What the generator must know of a header: its words, its brackets, its functions, statements and expressions.

This is no parser of C++. It reads our headers, which clang-format has laid out: a `<` with a blank before it compares, one
without opens a list of template arguments, and an operator between two operands stands between blanks. What it does not
understand it passes over, so that nothing is changed there."""
import re
from dataclasses import dataclass, field

word_pattern = re.compile(r"""
    (?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:\\\n|[^\n])*|\s+)
  | (?P<string>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
  | (?P<number>(?:0[xX][0-9a-fA-F']+|(?:\d[\d']*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)[uUlLfF]*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<mark>->\*|<=>|\.\.\.|::|->|\+\+|--|<<=|>>=|[-+*/%&|^]=|[=!<>]=|&&|\|\||<<|[-+*/%&|^~!=<>?:;,.()\[\]{}])
""", re.VERBOSE | re.MULTILINE | re.DOTALL)

closing = {"(": ")", "[": "]", "{": "}"}


@dataclass
class Word:
    kind: str  # string, number, name, mark, or one of ( [ { < for a group
    text: str
    start: int
    end: int
    after_blank: bool
    inside: list = field(default_factory=list)  # the words of a group

    def __repr__(self):
        return f"{self.text}" if not self.inside else f"{self.kind}{self.inside}"


def words_of(text):
    """The words of a text, brackets as marks of their own."""
    found, place, blank = [], 0, True
    while place < len(text):
        match = word_pattern.match(text, place)
        if not match:
            raise ValueError(f"unknown character {text[place]!r}")
        end = match.end()
        if match.lastgroup == "skip":
            blank = True
        else:
            mark = match[0]
            if mark == ">>" and not blank:  # two lists of template arguments end
                mark, end = ">", place + 1
            found.append(Word(match.lastgroup, mark, place, end, blank))
            blank = False
        place = end
    return found


def is_angle(word, before):
    if word.text != "<" or before is None:
        return False
    return before.text in ("template", "]") or (not word.after_blank and before.text != "operator")


def grouped(words):
    """The same as a tree: what stands between brackets is one word with others inside."""
    stack = [Word("{", "", 0, 0, True)]
    for word in words:
        inside = stack[-1].inside
        before = inside[-1] if inside else None
        before_is_word = before if before is None or before.kind in ("name", "mark") else Word(
            "mark", "]" if before.kind == "[" else "", 0, 0, False)
        if word.kind == "mark" and word.text in closing:
            stack.append(Word(word.text, word.text, word.start, word.end, word.after_blank))
        elif is_angle(word, before_is_word):
            stack.append(Word("<", "<", word.start, word.end, word.after_blank))
        elif word.kind == "mark" and word.text == ">" and stack[-1].kind == "<":
            close(stack, word)
        elif word.kind == "mark" and word.text in (")", "]", "}"):
            while stack[-1].kind == "<":  # it was no list of template arguments: give up on it
                lost = stack.pop()
                stack[-1].inside += [Word("mark", "<", lost.start, lost.start + 1, lost.after_blank), *lost.inside]
            close(stack, word)
        else:
            stack[-1].inside.append(word)
    if len(stack) != 1:
        raise ValueError("brackets do not match")
    return stack[0].inside


def close(stack, word):
    group = stack.pop()
    group.end = word.end
    group.text = group.kind
    stack[-1].inside.append(group)


# --- Expressions -------------------------------------------------------------------------------------------------------

assignments = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
levels = [{"||"}, {"&&"}, {"|"}, {"^"}, {"&"}, {"==", "!="}, {"<", ">", "<=", ">="}, {"<=>"}, {"<<", ">>"},
          {"+", "-"}, {"*", "/", "%"}]
prefixes = {"-", "+", "!", "~", "*", "&", "++", "--"}


@dataclass
class Expression:
    """kind: binary, prefix, assign, choice (a ? b : c), atom"""
    kind: str
    start: int
    end: int
    operator: Word = None
    parts: list = field(default_factory=list)
    words: list = field(default_factory=list)


def split(words, marks):
    """The runs of words between the marks."""
    runs, run = [], []
    for word in words:
        if word.kind == "mark" and word.text in marks:
            runs.append(run)
            run = []
        else:
            run.append(word)
    return [*runs, run]


def is_binary(words, i):
    word = words[i]
    if word.kind != "mark" or i == 0 or i + 1 >= len(words):
        return False
    before = words[i - 1]
    if before.kind == "mark" and before.text not in ("++", "--"):
        return False
    if before.kind == "name" and before.text in ("return", "throw", "operator", "co_yield", "case", "new", "delete"):
        return False
    return word.after_blank and words[i + 1].after_blank and any(word.text in level for level in levels)


def expression(words):
    """The tree of one expression without commas; a declaration's type and name are an atom on the left of its =."""
    if not words:
        return None
    for i, word in enumerate(words):
        if word.kind == "mark" and word.text in assignments and i > 0:
            left, right = expression(words[:i]), expression(words[i + 1:])
            if left is None or right is None:
                return atom(words)
            return Expression("assign", words[0].start, words[-1].end, word, [left, right])
    for i, word in enumerate(words):
        if word.kind == "mark" and word.text == "?":
            depth = 0
            for j in range(i + 1, len(words)):
                if words[j].kind == "mark" and words[j].text == "?":
                    depth += 1
                elif words[j].kind == "mark" and words[j].text == ":":
                    if depth == 0:
                        parts = [expression(words[:i]), expression(words[i + 1:j]), expression(words[j + 1:])]
                        if None not in parts:
                            return Expression("choice", words[0].start, words[-1].end, word, parts)
                    depth -= 1
            return atom(words)
    for level in levels:
        for i in range(len(words) - 2, 0, -1):
            if words[i].text in level and is_binary(words, i):
                parts = [expression(words[:i]), expression(words[i + 1:])]
                if None in parts:
                    return atom(words)
                return Expression("binary", words[0].start, words[-1].end, words[i], parts)
    first = words[0]
    if first.kind == "mark" and first.text in prefixes and len(words) > 1:
        part = expression(words[1:])
        return Expression("prefix", first.start, words[-1].end, first, [part])
    return atom(words)


def atom(words):
    return Expression("atom", words[0].start, words[-1].end, None, [], words)


# --- Statements --------------------------------------------------------------------------------------------------------

@dataclass
class Statement:
    """kind: block, if, for, while, return, declaration, expression, jump, other"""
    kind: str
    start: int
    end: int
    words: list = field(default_factory=list)
    head: Word = None  # the ( ) of if, for and while
    inner: list = field(default_factory=list)  # statements
    is_constexpr: bool = False


def is_name(word, *names):
    return word.kind == "name" and word.text in names


def declares(words):
    """Whether a statement declares a name: two names, or a type and a name, stand side by side."""
    if is_name(words[0], "const", "constexpr", "static", "auto", "using", "static_assert", "typename", "thread_local",
               "struct", "class", "enum", "inline", "typedef"):
        return True
    for before, word in zip(words, words[1:]):
        if before.kind == "mark" and before.text in assignments:
            return False
        if word.kind == "name" and (before.kind == "<" or (before.kind == "name" and before.text != "template") or
                                    (before.kind == "mark" and before.text in ("*", "&", "&&") and
                                     (not before.after_blank or not word.after_blank) and before is not words[0])):
            return True
    return False


def statements(words):
    """The statements of a block, given the words inside its braces."""
    found, i = [], 0
    while i < len(words):
        statement, i = one_statement(words, i)
        if statement:
            found.append(statement)
    return found


def one_statement(words, i):
    word = words[i]
    if word.kind == "{":
        return Statement("block", word.start, word.end, [word], inner=statements(word.inside)), i + 1
    if word.kind == "mark" and word.text == ";":
        return None, i + 1
    if is_name(word, "if", "for", "while"):
        is_constexpr = word.text == "if" and is_name(words[i + 1], "constexpr")
        head = words[i + 1 + is_constexpr]
        inner, next_i = one_statement(words, i + 2 + is_constexpr)
        inners = [inner]
        if word.text == "if" and next_i < len(words) and is_name(words[next_i], "else"):
            other, next_i = one_statement(words, next_i + 1)
            inners.append(other)
        return Statement(word.text, word.start, words[next_i - 1].end, [], head, inners, is_constexpr), next_i
    if is_name(word, "try"):
        inner, next_i = one_statement(words, i + 1)
        inners = [inner]
        while next_i < len(words) and is_name(words[next_i], "catch"):
            handler, next_i = one_statement(words, next_i + 2)
            inners.append(handler)
        return Statement("try", word.start, words[next_i - 1].end, [], None, inners), next_i
    if is_name(word, "switch"):
        body = words[i + 2]
        return Statement("block", word.start, body.end, [], inner=statements(body.inside)), i + 3
    if is_name(word, "case", "default"):
        while not (words[i].kind == "mark" and words[i].text == ":"):
            i += 1
        return None, i + 1
    if is_name(word, "else", "do", "catch"):
        raise ValueError(f"a statement with {word.text}")
    end = i
    while end < len(words) and not (words[end].kind == "mark" and words[end].text == ";"):
        end += 1
    whole = words[i:end]
    stop = words[end].end if end < len(words) else words[-1].end
    if is_name(word, "return", "throw"):
        kind = "return"
    elif is_name(word, "break", "continue"):
        kind = "jump"
    elif declares(whole):
        kind = "declaration"
    else:
        kind = "expression"
    return Statement(kind, word.start, stop, whole), end + 1


# --- Declarations ------------------------------------------------------------------------------------------------------

@dataclass
class Function:
    start: int  # of the body's {
    end: int
    body: list  # statements
    is_constexpr: bool = False


@dataclass
class Source:
    text: str
    functions: list = field(default_factory=list)  # bodies
    initialisers: list = field(default_factory=list)  # (words, the words declared by a constexpr) outside of functions


def read(text):
    source = Source(text)
    read_scope(source, grouped(words_of(text)))
    return source


def read_scope(source, words):
    """The declarations of a namespace or a class."""
    i = 0
    while i < len(words):
        i = read_declaration(source, words, i)


def read_declaration(source, words, i):
    first = i
    while i < len(words) and (is_name(words[i], "template", "friend", "inline", "static", "export") or words[i].kind in "<["):
        i += 1
    if i >= len(words):
        return i
    word = words[i]
    if is_name(word, "public", "private", "protected"):
        return i + 2
    end = i
    while end < len(words) and not (words[end].kind == "mark" and words[end].text == ";") and words[end].kind != "{":
        end += 1
    if is_name(word, "namespace", "struct", "class", "union") and end < len(words) and words[end].kind == "{" and not any(
            w.kind == "(" for w in words[i:end]):
        read_scope(source, words[end].inside)
        return end + 1
    if is_name(word, "enum", "using", "static_assert", "concept", "typedef", "extern", "struct", "class"):
        return skip_to_semicolon(words, i)
    return read_value_or_function(source, words, first)


def skip_to_semicolon(words, i):
    while i < len(words) and not (words[i].kind == "mark" and words[i].text == ";"):
        i += 1
    return i + 1


def read_value_or_function(source, words, first):
    """A function with its body, or a variable with its initialiser."""
    i, parameters = first, None
    constant = False
    while i < len(words):
        word = words[i]
        if is_name(word, "constexpr"):
            constant = True
        if is_name(word, "operator"):
            i += 2
            while words[i].kind != "(" or (i + 1 < len(words) and words[i + 1].kind == "("):  # operator()(...)
                i += 1
            parameters = words[i]
        elif is_name(word, "noexcept", "alignas", "decltype", "__attribute__") and i + 1 < len(words) and words[i + 1].kind == "(":
            i += 1
        elif word.kind == "(" and parameters is None:
            parameters = word
        elif word.kind == "mark" and word.text == ";":
            if parameters:
                read_parameters(source, parameters)
            return i + 1
        elif word.kind == "mark" and word.text == "=" and parameters is None:
            end = i
            while end < len(words) and not (words[end].kind == "mark" and words[end].text == ";"):
                end += 1
            source.initialisers.append((words[i + 1:end], words[first:i] if constant else []))
            return end + 1
        elif word.kind == "mark" and word.text == "=":  # = 0, = default, = delete
            return skip_to_semicolon(words, i)
        elif word.kind == "mark" and word.text == ":" and parameters:
            i = read_members(source, words, i + 1)
            continue
        elif word.kind == "{":
            if parameters is None:  # a variable, initialised by braces
                source.initialisers.append(([word], words[first:i] if constant else []))
            else:
                read_parameters(source, parameters)
                source.functions.append(Function(word.start, word.end, statements(word.inside), constant))
                return i + 1
        i += 1
    return i


def read_members(source, words, i):
    """The members' initialisers of a constructor; gives the place of its body."""
    while i < len(words):
        while words[i].kind not in ("(", "{"):
            i += 1
        source.initialisers.append(([words[i]], []))
        i += 1
        if i < len(words) and words[i].kind == "mark" and words[i].text == ",":
            i += 1
        else:
            return i
    return i


def read_parameters(source, group):
    """Default arguments."""
    for run in split(group.inside, {","}):
        for i, word in enumerate(run):
            if word.kind == "mark" and word.text == "=" and i + 1 < len(run):
                source.initialisers.append((run[i + 1:], []))
                break
