"""The names that a C source keeps to itself, found and renamed token by token, so that many sources fit into one.

Knows as much of C as this library's sources use: no K&R definitions, no names made by ##.
"""
import re

TOKEN = re.compile(r"""
    (?P<skip>\s+|/\*.*?\*/|//[^\n]*|\\\n)
  | (?P<text>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
  | (?P<number>\.?[0-9](?:[eEpP][+-]|[\w.])*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<sign>->|\#\#|.)
""", re.X | re.S)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)
OPEN, CLOSE = "([{", ")]}"


def tokens_of(text):
    """[kind, text] of all tokens; joined they are the text again."""
    return [[match.lastgroup, match.group()] for match in TOKEN.finditer(text)]


def declarations(text):
    """The file-scope declarations and definitions, each a list of tokens without the contents of function bodies' inner parts."""
    current, depth = [], 0
    for kind, token in tokens_of(DIRECTIVE.sub("", text)):
        if kind == "skip":
            continue
        current.append(token)
        depth += (token in OPEN) - (token in CLOSE)
        body_ends = token == "}" and depth == 0 and is_function(current)
        if (token == ";" and depth == 0) or body_ends:
            yield current
            current = []


def is_function(tokens):
    """Whether a declaration that has just closed a brace is a function's definition."""
    head = outermost(tokens)
    return "(" in head and "=" not in head


def outermost(tokens):
    """The tokens outside all brackets, and the brackets themselves."""
    depth, kept = 0, []
    for token in tokens:
        depth -= token in CLOSE
        if depth == 0:
            kept.append(token)
        depth += token in OPEN
    return kept


def enumerators(tokens):
    """The constants of the enums in a declaration."""
    for start, token in enumerate(tokens):
        if token == "enum":
            open_at = start + (1 if tokens[start + 1] == "{" else 2)
            if tokens[open_at] != "{":
                continue
            body = tokens[open_at + 1:tokens.index("}", open_at)]
            yield from (name for before, name in zip(["{", *body], body) if before in "{," and re.match(r"[A-Za-z_]", name))


def declared(tokens):
    """The names that one declaration gives to the file alone."""
    if tokens[0] == "FC_INLINE":  # bits.h
        tokens = ["static", "inline", *tokens[1:]]
    if tokens[0] not in ("static", "typedef", "enum", "struct", "union"):
        return
    yield from enumerators(tokens)
    for word, tag, following in zip(tokens, tokens[1:], tokens[2:]):
        if word in ("struct", "union", "enum") and following == "{":
            yield tag
    head = [token for token in outermost(tokens) if token != "FC_ROM"]
    if tokens[0] == "typedef":
        yield head[-2] if head[-2] != ")" else tokens[tokens.index("*", tokens.index("(")) + 1]
    elif tokens[0] == "static":
        ends = "(" if is_function(head) else "[=;,"
        names = [name for name, end in zip(head, head[1:]) if end in ends and re.match(r"[A-Za-z_]", name)]
        yield from names[:1] if ends == "(" else names


def private_names(text):
    """The file-scope names of a source that no other source can see."""
    names = set(re.findall(r"^[ \t]*#[ \t]*define[ \t]+(\w+)", text, re.M))
    for tokens in declarations(text):
        names.update(declared(tokens))
    return names


def has_private_functions(text):
    """Whether a header defines functions that each of its sources has for itself, and which therefore are not inline."""
    return any(tokens[0] == "static" and "inline" not in tokens and is_function(tokens) and tokens[-1] == "}"
               for tokens in declarations(text))


def rename(text, renamed):
    """The text with names replaced, except members of structs, whose names are their struct's."""
    tokens = tokens_of(text)
    seen = [token for token in tokens if token[0] != "skip"]
    structs, before = [], ["", ""]  # for each open brace: whether it is a struct's
    for at, token in enumerate(seen):
        kind, word = token
        following = seen[at + 1][1] if at + 1 < len(seen) else ""
        if word == "{":
            structs.append(before[-1] in ("struct", "union") or before[-2] in ("struct", "union"))
        elif word == "}":
            structs.pop()
        member = before[-1] in (".", "->") or (structs and structs[-1] and following in (";", ",", "[", ":"))
        before = [before[-1], word]
        if kind == "name" and word in renamed and not member:
            token[1] = renamed[word]
    return "".join(token for _, token in tokens)
